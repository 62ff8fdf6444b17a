#include "hawser/fields/formula_fields.hpp"

#include <algorithm>

namespace hawser {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

FormulaNames names_of(const DofMap& dofs, bool on_boundary) {
  FormulaNames names;
  names.dimension = dofs.mesh().dimension;
  for (const FieldDescription& field : dofs.fields())
    names.fields.push_back({field.name, field.components});
  for (int j = 0; on_boundary && j < names.dimension; ++j)
    names.others.push_back(std::string("normal_") + axes[j]);
  return names;
}

}  // namespace

FormulaFields::FormulaFields(const DofMap& dofs, FieldExpression formula, bool on_boundary,
                             Diagnostics& diagnostics)
    : formula_(std::move(formula)) {
  const FormulaNames names = names_of(dofs, on_boundary);
  refuse_hidden_fields(formula_, names.fields, diagnostics);
  for (const FieldReference& reference : formula_.references())
    items_.push_back(look_up(names, reference, on_boundary, diagnostics));
}

FormulaFields::Item FormulaFields::look_up(const FormulaNames& names,
                                           const FieldReference& reference, bool on_boundary,
                                           Diagnostics& diagnostics) {
  Item item{0, reference.component, reference.along, false};
  const auto refuse = [&](const std::string& why) {
    diagnostics.error(formula_.location(), begin_of_fault(formula_, reference) + why);
    complete_ = false;
    return item;
  };
  const auto is_normal = [](const NamedField& field) { return field.name == "normal"; };
  const bool of_normal =
      reference.of_vector && reference.field == "normal" && reference.component < names.dimension;
  if (on_boundary && of_normal) {
    if (reference.along >= 0) return refuse("no derivative of a field");
    item.is_normal = true;
    return item;
  }
  if (of_normal && std::none_of(names.fields.begin(), names.fields.end(), is_normal))
    return refuse("known on the boundary of a body only");
  const auto found = look_up_field(formula_, reference, names, diagnostics);
  if (!found) {
    complete_ = false;
    return item;
  }
  const auto field = static_cast<int>(found->field);
  const auto known = std::find(fields_.begin(), fields_.end(), field);
  item = {static_cast<std::size_t>(known - fields_.begin()), found->component, found->along, false};
  if (known == fields_.end()) fields_.push_back(field);
  return item;
}

bool FormulaFields::has_derivatives() const {
  return std::any_of(items_.begin(), items_.end(),
                     [](const Item& item) { return item.along >= 0; });
}
bool FormulaFields::has_normal() const {
  return std::any_of(items_.begin(), items_.end(), [](const Item& item) { return item.is_normal; });
}

int FormulaFields::quadrature_degree(const DofMap& dofs, int moving) const {
  constexpr int of_no_polynomial = 8, most = 19;
  const auto degree_of = [&](int field) {
    return field < 0 ? 1 : polynomial_degree(dofs.fields()[static_cast<std::size_t>(field)].basis);
  };
  std::vector<int> degrees;
  bool straight = true;  // every cell an affine image: derivatives lower the degree
  if (dofs.mesh().has_body()) straight = traits(dofs.mesh().body.shape).simplex;
  for (const Item& item : items_) {
    const int lower = item.along >= 0 && straight ? 1 : 0;
    degrees.push_back(item.is_normal ? 0 : degree_of(fields_[item.field]) - lower);
  }
  const int degree = formula_.degree(degree_of(moving), degrees);
  if (degree < 0) return of_no_polynomial;
  // The cell's volume varies in a quadrilateral, and where it is bent.
  const int bent = (straight ? 0 : 1) + 2 * (degree_of(moving) - 1);
  return std::min(degree + bent, most);
}

double FormulaFields::value(const FieldSampler& at, const Vector<double, 3>& normal) const {
  constexpr std::size_t usual = 16;
  double few[usual];
  std::vector<double> many(items_.size() > usual ? items_.size() : 0);
  double* const values = items_.size() > usual ? many.data() : few;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    values[i] = item.is_normal   ? normal[item.component]
                : item.along < 0 ? at.value(item.field, item.component)
                                 : at.derivative(item.field, item.component, item.along);
  }
  return formula_(at.place(), values);
}

bool FormulaFields::is_plain() const {
  return items_.size() == 1 && formula_.references().front().text() == formula_.text();
}

std::string FormulaFields::plain_name() const {
  if (!is_plain()) return "";
  const FieldReference& reference = formula_.references().front();
  return (reference.along < 0 ? "" : std::string("d") + axes[reference.along] + "_") +
         reference.name();
}

std::string FormulaFields::plain_unit(const DofMap& dofs) const {
  if (!is_plain() || items_.front().is_normal || fields_.empty()) return "";
  const std::string& unit = dofs.fields()[static_cast<std::size_t>(fields_.front())].unit;
  if (items_.front().along < 0) return unit;
  if (unit == "m") return "1";
  if (unit.compare(0, 2, "m/") == 0) return "1" + unit.substr(1);
  return unit == "1" || unit.empty() ? "1/m" : unit + "/m";
}

}  // namespace hawser
