#include "hawser/assembly/connect_properties.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "hawser/base/error.hpp"
#include "src/cell_vertices.hpp"

namespace hawser {
namespace {

struct Supplier {
  const PhysicsModule* module;
  const Supply* supply;
};

std::string text_of(const Supplier& supplier) {
  return named(*supplier.module) + " (" + supplier.module->location.text() + ")";
}

class Connecting {
 public:
  Connecting(const Mesh& mesh, std::vector<PhysicsModule>& modules, Diagnostics& diagnostics)
      : mesh_(mesh), modules_(modules), diagnostics_(diagnostics) {}

  void all() {
    gather();
    for (const Supplier& supplier : suppliers_)
      check_is_used(supplier);
    if (!diagnostics_.ok()) return;
    for (PhysicsModule& module : modules_)
      for (const auto& kernel : module.kernels)
        for (std::size_t p = 0; p < kernel->properties().uses().size(); ++p)
          connect(module, *kernel, p);
  }

 private:
  void gather() {
    std::vector<FieldUse> fields;
    for (const PhysicsModule& module : modules_)
      for (const auto& kernel : module.kernels)
        for (const FieldUse& use : kernel->fields())
          if (!only_reads(use.role)) fields.push_back(use);
    for (const PhysicsModule& module : modules_)
      for (const Supply& supply : module.supplies) {
        supply.source->resolve(fields, diagnostics_);
        suppliers_.push_back({&module, &supply});
      }
  }

  /// A name that is misspelt would be supplied to nobody, without a word.
  void check_is_used(const Supplier& supplier) {
    const PropertyUse wanted = supplier.supply->source->property();
    std::set<std::string> names;
    for (const PhysicsModule& module : modules_)
      for (const auto& kernel : module.kernels)
        for (const PropertyUse& use : kernel->properties().uses()) {
          const bool is_new = names.insert(use.name).second;
          if (std::string_view(use.name) != wanted.name) continue;
          if (is_new) supplier.supply->source->check_unit(use.unit, diagnostics_);
          const bool same_unit = *wanted.unit == '\0' || std::string_view(use.unit) == wanted.unit;
          if (same_unit && use.components == wanted.components) continue;
          if (*wanted.unit == '\0') {
            diagnostics_.error(supplier.module->location,
                               "'" + std::string(use.name) + "' has " +
                                   std::to_string(use.components) + " components, and here are " +
                                   std::to_string(wanted.components) +
                                   "; a semicolon sets expressions apart");
            return;
          }
          throw PluginError(named(*supplier.module) + " supplies '" + wanted.name + "' in " +
                            wanted.unit + " with " + std::to_string(wanted.components) +
                            " components, and " + named(module) + " uses it in " + use.unit +
                            " with " + std::to_string(use.components));
        }
    const std::vector<std::string> known(names.begin(), names.end());
    if (names.count(wanted.name) == 0)
      diagnostics_.error(supplier.module->location,
                         named(*supplier.module) + " supplies '" + wanted.name +
                             "', which no module of this run uses; used are " + listed(known) +
                             did_you_mean(wanted.name, known));
  }

  void connect(const PhysicsModule& module, Kernel& kernel, std::size_t property) {
    const PropertyUse use = kernel.properties().uses()[property];
    const Region& region = mesh_.region(kernel.domain());
    const bool has_constant = kernel.properties().has_constant(property);
    const auto cells = static_cast<std::size_t>(region.size());
    std::vector<const Supplier*> first(cells, nullptr);  // that holds on a cell
    const Supplier* clash[2] = {nullptr, nullptr};
    bool clashes_with_constant = false;
    for (const Supplier& supplier : suppliers_) {
      const Supply& supply = *supplier.supply;
      if (std::string_view(supply.source->property().name) != use.name) continue;
      const std::vector<char> holds = cells_within(mesh_, region, supply.on);
      if (!mesh_.communicator.any(std::count(holds.begin(), holds.end(), 1) > 0)) continue;
      kernel.connect(property, supply);
      bool alone_twice = false;
      for (std::size_t cell = 0; cell < cells; ++cell) {
        if (holds[cell] == 0) continue;
        const Supplier* const other = first[cell];
        if (other != nullptr && !(other->supply->adds && supply.adds)) {
          alone_twice = true;
          clash[0] = other;
        }
        if (other == nullptr) first[cell] = &supplier;
      }
      if (mesh_.communicator.any(alone_twice)) clash[1] = &supplier;
      if (has_constant && !supply.adds) {
        clashes_with_constant = true;
        clash[1] = &supplier;
      }
    }
    if (clash[1] != nullptr) complain_of_two(module, use, clash, clashes_with_constant);
    const bool lacks = std::count(first.begin(), first.end(), nullptr) > 0;
    if (mesh_.communicator.any(lacks) && !has_constant && !use.otherwise)
      complain_of_none(module, kernel, use);
  }

  void complain_of_two(const PhysicsModule& module, const PropertyUse& use,
                       const Supplier* const (&clash)[2], bool with_constant) {
    const std::string other =
        with_constant || clash[0] == nullptr ? "its own attribute" : text_of(*clash[0]);
    diagnostics_.error(module.location, named(module) + " gets '" + use.name + "' from " + other +
                                            " and from " + text_of(*clash[1]) +
                                            " on the same cells, and not both of them add; leave "
                                            "one out, or give each cells of its own");
  }

  void complain_of_none(const PhysicsModule& module, const Kernel& kernel, const PropertyUse& use) {
    std::set<std::string> names;
    for (const Supplier& supplier : suppliers_)
      names.insert(supplier.supply->source->property().name);
    const std::vector<std::string> known(names.begin(), names.end());
    diagnostics_.error(
        module.location,
        named(module) + " needs '" + use.name + "' (" + use.unit + ") on all of '" +
            kernel.domain().text() +
            "', and nobody gives it there: neither an attribute of the module, nor <property>, "
            "nor another module" +
            (known.empty() ? ""
                           : "; supplied are " + listed(known) + did_you_mean(use.name, known)));
  }

  const Mesh& mesh_;
  std::vector<PhysicsModule>& modules_;
  Diagnostics& diagnostics_;
  std::vector<Supplier> suppliers_;
};

}  // namespace

std::vector<char> cells_within(const Mesh& mesh, const Region& region, const Domain& on) {
  const Region& body = mesh.region(on);
  std::vector<char> within(static_cast<std::size_t>(region.size()), 0);
  if (body.vertices_per_cell != region.vertices_per_cell) return within;
  std::set<Vertices> cells;
  insert_cells(body, cells);
  for (LocalIndex cell = 0; cell < region.size(); ++cell)
    within[static_cast<std::size_t>(cell)] = cells.count(sorted_vertices(region, cell)) > 0 ? 1 : 0;
  return within;
}

void connect_properties(const Mesh& mesh, std::vector<PhysicsModule>& modules,
                        Diagnostics& diagnostics) {
  Connecting(mesh, modules, diagnostics).all();
}

}  // namespace hawser
