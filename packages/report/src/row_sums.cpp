#include "src/row_sums.hpp"

#include <algorithm>
#include <set>

#include "hawser/base/exact_sum.hpp"
#include "hawser/fields/look_up.hpp"

namespace hawser {
namespace {

/// On one of these regions; on any where none is named.
bool lives_on(const PhysicsModule& module, const std::vector<std::string>& regions) {
  if (regions.empty()) return true;
  for (const auto& kernel : module.kernels)
    for (const std::string& region : kernel->domain().regions)
      if (kernel->domain().kind == Domain::Kind::cells &&
          std::find(regions.begin(), regions.end(), region) != regions.end())
        return true;
  return false;
}

}  // namespace

RowSums::RowSums(LoadDeck deck, const ReportContext& context, Diagnostics& diagnostics)
    : assembler_(context.assembler), deck_(std::move(deck)) {
  const DofMap& dofs = context.dofs();
  field_ = find_field(dofs, deck_.field, diagnostics);
  std::set<LocalIndex> rows;
  std::vector<LocalIndex> vertices;
  bool all_there = true;
  for (const std::string& name : deck_.on.value) {
    const Region* const region = find_region(dofs.mesh(), name, deck_.on.location, diagnostics);
    all_there = all_there && region != nullptr;
    if (region == nullptr || field_ < 0) continue;
    for (const LocalIndex row : dofs.region_rows(field_, *region))
      if (row < dofs.owned()) rows.insert(row);
    vertices.insert(vertices.end(), region->vertices.begin(), region->vertices.end());
  }
  rows_.assign(rows.begin(), rows.end());
  if (all_there && field_ >= 0 && !dofs.mesh().communicator.any(!rows_.empty()))
    diagnostics.error(deck_.on.location, "no module solves for a " + deck_.field.value +
                                             " on region '" + Domain(deck_.on.value).text() +
                                             "': there is no " + deck_.kind + " to report");
  if (deck_.module.value != "all") choose_modules(context.modules, diagnostics);
  if (all_there) note_a_sum(context.modules, vertices, diagnostics);
}

/// A region of one module alone that another of the name meets, as in the joint of two cables,
/// could mean either; one that they share among them, such as the wall of two waters, means both.
void RowSums::note_a_sum(const std::vector<PhysicsModule>& modules,
                         const std::vector<LocalIndex>& vertices, Diagnostics& diagnostics) const {
  if (!deck_.module_on.value.empty()) return;
  const Mesh& mesh = assembler_.dofs().mesh();
  // All cells at an owned vertex are here.
  std::set<LocalIndex> wanted(vertices.begin(), vertices.end());
  wanted.erase(wanted.lower_bound(mesh.vertices.owned), wanted.end());
  std::vector<std::string> there;
  bool one_has_all = false;
  for (const int m : modules_) {
    const PhysicsModule& module = modules[static_cast<std::size_t>(m)];
    std::set<LocalIndex> has;
    for (const auto& kernel : module.kernels)
      if (const Region* const domain = mesh.find(kernel->domain()); domain != nullptr)
        for (const LocalIndex vertex : domain->vertices)
          if (wanted.count(vertex) > 0) has.insert(vertex);
    if (!mesh.communicator.any(!has.empty())) continue;
    there.push_back(module.location.text());
    one_has_all = !mesh.communicator.any(has.size() < wanted.size()) || one_has_all;
  }
  if (there.size() > 1 && one_has_all)
    diagnostics.note(deck_.module.location,
                     deck_.kind + " '" + deck_.name + "' is the sum of " +
                         std::to_string(there.size()) + " modules '" + deck_.module.value +
                         "' that meet on '" + Domain(deck_.on.value).text() + "' (" +
                         listed(there) +
                         "); name in module-on=\"...\" the regions of those that are meant");
}

void RowSums::choose_modules(const std::vector<PhysicsModule>& modules, Diagnostics& diagnostics) {
  const std::string& wanted = deck_.module.value;
  std::vector<std::string> names = {"all"};
  for (std::size_t m = 0; m < modules.size(); ++m) {
    names.push_back(modules[m].name);
    if (modules[m].name == wanted && lives_on(modules[m], deck_.module_on.value))
      modules_.push_back(static_cast<int>(m));
  }
  if (modules_.empty() && std::count(names.begin(), names.end(), wanted) > 0) {
    diagnostics.error(deck_.module_on.location,
                      "no module '" + wanted + "' lives on " + listed(deck_.module_on.value));
    return;
  }
  if (modules_.empty())
    diagnostics.error(deck_.module.location, "the deck has no module '" + wanted + "'; it has " +
                                                 listed(names) + did_you_mean(wanted, names));
}

std::vector<double> RowSums::sum(const Step& step) const {
  const FieldDescription& field = assembler_.dofs().fields()[static_cast<std::size_t>(field_)];
  const auto components = static_cast<std::size_t>(field.components);
  std::vector<double> terms;  // [row][component], of each contribution
  const auto add = [&](const std::vector<double>& rows, double sign) {
    for (const LocalIndex row : rows_)
      for (std::size_t c = 0; c < components; ++c)
        terms.push_back(sign * rows[static_cast<std::size_t>(row) + c]);
  };
  if (modules_.empty()) add(step.reactions, 1);
  std::vector<double> residual;
  for (const int module : modules_) {
    assembler_.residual(step.balance, residual, module);
    add(residual, -1);
  }
  std::vector<double> result, of_one(terms.size() / components);
  for (std::size_t c = 0; c < components; ++c) {
    for (std::size_t i = 0; i < of_one.size(); ++i)
      of_one[i] = terms[i * components + c];
    result.push_back(exact_sum(assembler_.dofs().mesh().communicator, of_one));
  }
  return result;
}

}  // namespace hawser
