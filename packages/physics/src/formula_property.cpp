#include "hawser/physics/formula_property.hpp"

#include <algorithm>
#include <string_view>

#include "hawser/deck/look_up_field.hpp"
#include "hawser/element/cell_geometry.hpp"
#include "hawser/physics/moving_frame.hpp"

namespace hawser {
namespace {

constexpr std::size_t most_references = 32;  // in one formula

constexpr FieldUse displacement(int dimension) {
  constexpr unsigned needs = need::value | need::gradient;
  return dimension == 2 ? StandardFields<2>::displacement.as(Role::reads_if_solved, needs)
                        : StandardFields<3>::displacement.as(Role::reads_if_solved, needs);
}

bool is_constant(const FieldExpressions& formulas) {
  return std::all_of(formulas.begin(), formulas.end(),
                     [](const FieldExpression& formula) { return formula.is_constant(); });
}

PropertyConstant constant(const GivenProperty& given) {
  if (given.formulas.empty()) return std::nullopt;
  std::vector<double> values(static_cast<std::size_t>(given.property.components), 0.0);
  if (is_constant(given.formulas))
    for (std::size_t c = 0; c < values.size(); ++c)
      values[c] = given.formulas[c]({});
  return values;
}

/// Reads fields at one point of the moved mesh, and adds the slopes of what it read.
template <int D>
struct MovedReader {
  const CellTabulation& table;
  const CellInput& cell;
  const CellGeometry<D>& geometry;
  int q;
  MovingFrame<double, D> frame;
  int displacement;

  /// d N_a / d X_k of a field's shape.
  double slope(std::size_t field, int a, int k) const {
    const Tabulation& shape = table.fields[field];
    const double* const local =
        &shape.gradients[static_cast<std::size_t>((q * shape.nodes + a) * D)];
    double sum = 0;
    for (int m = 0; m < D; ++m)
      sum += local[m] * geometry.inverse_jacobian(m, k);
    return sum;
  }
  double shape(std::size_t field, int a) const {
    return table.fields[field].values[static_cast<std::size_t>(q * table.fields[field].nodes + a)];
  }
  double value(std::size_t field, int components, int c) const {
    double sum = 0;
    for (int a = 0; a < table.fields[field].nodes; ++a)
      sum += shape(field, a) * cell.fields[field].value[a * components + c];
    return sum;
  }
  /// d u_c / d x_j.
  double gradient(std::size_t field, int components, int c, int j) const {
    double sum = 0;
    for (int a = 0; a < table.fields[field].nodes; ++a)
      for (int k = 0; k < D; ++k)
        sum +=
            cell.fields[field].value[a * components + c] * slope(field, a, k) * frame.inverse(k, j);
    return sum;
  }
  void add_value_slope(double factor, std::size_t field, int components, int c,
                       double* line) const {
    for (int a = 0; a < table.fields[field].nodes; ++a)
      line[a * components + c] += factor * shape(field, a);
  }
  /// By the field's nodes into `line`, by the displacement's into `moved`: the derivative of F^-1
  /// is -F^-1 dF F^-1.
  void add_gradient_slope(double factor, std::size_t field, int components, int c, int j,
                          double* line, double* moved) const {
    for (int a = 0; a < table.fields[field].nodes; ++a)
      for (int k = 0; k < D; ++k)
        line[a * components + c] += factor * slope(field, a, k) * frame.inverse(k, j);
    const auto d = static_cast<std::size_t>(displacement);
    for (int i = 0; i < D; ++i) {
      const double along = gradient(field, components, c, i);
      for (int a = 0; a < table.fields[d].nodes; ++a)
        for (int k = 0; k < D; ++k)
          moved[a * D + i] -= factor * along * slope(d, a, k) * frame.inverse(k, j);
    }
  }
};

}  // namespace

FormulaProperty::FormulaProperty(std::string name, int dimension, FieldExpressions formulas)
    : PropertySource({}),
      name_(std::move(name)),
      dimension_(dimension),
      formulas_(std::move(formulas)) {}

FormulaProperty::FormulaProperty(const PropertyUse& property, int dimension,
                                 FieldExpressions formulas)
    : PropertySource({}),
      name_(property.name),
      unit_(property.unit),
      dimension_(dimension),
      formulas_(std::move(formulas)) {}

void FormulaProperty::resolve(const std::vector<FieldUse>& run, Diagnostics& diagnostics) {
  FormulaNames names;
  names.dimension = dimension_;
  for (const FieldUse& use : run)
    names.fields.push_back({use.name, use.components});
  std::vector<FieldUse> fields;
  const auto index_of = [&](const FieldUse& use) {
    const auto known = std::find_if(fields.begin(), fields.end(), [&](const FieldUse& other) {
      return std::string_view(other.name) == use.name;
    });
    const auto index = static_cast<std::size_t>(known - fields.begin());
    if (known == fields.end()) fields.push_back(use.as(Role::reads, need::value));
    return index;
  };
  readings_.clear();
  bool moves = false;
  for (const FieldExpression& formula : formulas_) {
    refuse_hidden_fields(formula, names.fields, diagnostics);
    if (formula.references().size() > most_references)
      return diagnostics.error(formula.location(), "'" + formula.text() + "' names more than " +
                                                       std::to_string(most_references) +
                                                       " fields and derivatives");
    std::vector<Reading> readings;
    moves = moves || formula.depends_on_moved_position();
    for (const FieldReference& reference : formula.references()) {
      const auto found = look_up_field(formula, reference, names, diagnostics);
      if (!found) return;
      const std::size_t field = index_of(run[found->field]);
      if (found->along >= 0) fields[field].needs |= need::gradient;
      moves = moves || found->along >= 0;
      readings.push_back({field, found->component, found->along});
    }
    readings_.push_back(std::move(readings));
  }
  displacement_ = -1;
  if (moves) {
    displacement_ = static_cast<int>(index_of(displacement(dimension_)));
    fields[static_cast<std::size_t>(displacement_)] = displacement(dimension_);
  }
  set_fields(std::move(fields));
}

void FormulaProperty::check_unit(const char* wanted, Diagnostics& diagnostics) const {
  Unit unit;
  if (!read_unit(wanted, unit).empty()) return;
  for (const FieldExpression& formula : formulas_)
    if (formula.unit() && !same_dimension(*formula.unit(), unit))
      diagnostics.error(formula.location(), "'" + formula.text() + " " + formula.unit()->text +
                                                "' is in " + formula.unit()->text + ", and '" +
                                                name_ + "' in " + wanted);
}

void FormulaProperty::bind(const CellTabulation& table) {
  table_ = table;
  first_ = {0};
  for (std::size_t f = 0; f < fields().size(); ++f)
    first_.push_back(first_.back() + table.fields[f].nodes * fields()[f].components);
}

bool FormulaProperty::evaluate(const CellInput& cell, double* values, double* slopes) const {
  return dimension_ == 2 ? evaluate_in<2>(cell, values, slopes)
                         : evaluate_in<3>(cell, values, slopes);
}

template <int D>
bool FormulaProperty::evaluate_in(const CellInput& cell, double* values, double* slopes) const {
  const auto d = static_cast<std::size_t>(std::max(displacement_, 0));
  const int unknowns = first_.back();
  CellGeometry<D> geometry;
  geometry.enter(table_, cell.coordinates);
  for (int q = 0; q < table_.rule.points; ++q) {
    geometry.go_to(q, table_, cell.coordinates);
    Tensor<double, D> nothing;
    MovedReader<D> at{table_, cell, geometry, q, MovingFrame<double, D>(nothing), displacement_};
    SpaceTime place;
    place.t = cell.time;
    constexpr double SpaceTime::*reference[] = {&SpaceTime::X, &SpaceTime::Y, &SpaceTime::Z};
    constexpr double SpaceTime::*moved[] = {&SpaceTime::x, &SpaceTime::y, &SpaceTime::z};
    for (int j = 0; j < D; ++j)
      place.*moved[j] = place.*reference[j] = geometry.position[j];
    if (displacement_ >= 0) {
      Tensor<double, D> gradient;
      for (int i = 0; i < D; ++i) {
        place.*moved[i] += at.value(d, D, i);
        for (int k = 0; k < D; ++k)
          gradient(i, k) = at.gradient(d, D, i, k);
      }
      at.frame = MovingFrame<double, D>(gradient);
      if (at.frame.inverted()) return false;
    }
    for (std::size_t c = 0; c < formulas_.size(); ++c) {
      double read[most_references];
      double derivative[3 + most_references];
      for (std::size_t r = 0; r < readings_[c].size(); ++r) {
        const Reading& reading = readings_[c][r];
        const int components = fields()[reading.field].components;
        read[r] = reading.along < 0
                      ? at.value(reading.field, components, reading.component)
                      : at.gradient(reading.field, components, reading.component, reading.along);
      }
      const std::size_t component = static_cast<std::size_t>(q) * formulas_.size() + c;
      if (slopes == nullptr) {
        values[component] = formulas_[c](place, read);
        continue;
      }
      values[component] = formulas_[c].tangent(place, read, derivative);
      double* const line = slopes + component * static_cast<std::size_t>(unknowns);
      std::fill(line, line + unknowns, 0.0);
      for (int j = 0; j < D && displacement_ >= 0; ++j)
        at.add_value_slope(derivative[j], d, D, j, line + first_[d]);
      for (std::size_t r = 0; r < readings_[c].size(); ++r) {
        const Reading& reading = readings_[c][r];
        const int components = fields()[reading.field].components;
        double* const own = line + first_[reading.field];
        if (reading.along < 0)
          at.add_value_slope(derivative[3 + r], reading.field, components, reading.component, own);
        else
          at.add_gradient_slope(derivative[3 + r], reading.field, components, reading.component,
                                reading.along, own, line + first_[d]);
      }
    }
  }
  return true;
}

std::vector<PropertyConstant> give(const std::vector<GivenProperty>& all, const Domain& on,
                                   int dimension, std::vector<Supply>& supplies) {
  std::vector<PropertyConstant> constants;
  for (const GivenProperty& one : all) {
    constants.push_back(constant(one));
    if (!is_constant(one.formulas))
      supplies.push_back(
          {on, true, std::make_unique<FormulaProperty>(one.property, dimension, one.formulas)});
  }
  return constants;
}

}  // namespace hawser
