#include "hawser/conditions/conditions.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/fields/look_up.hpp"
#include "hawser/physics/field_use.hpp"
#include "hawser/values/expression_source.hpp"

namespace hawser {
namespace {

/// "x, y": the components of a field by name.
std::string component_names(int count) {
  std::string names = "x";
  for (int c = 1; c < count; ++c)
    names += std::string(", ") + static_cast<char>('x' + c);
  return names;
}

/// A constant that was written with a unit must fit the field; formulas are in SI units.
void check_units(const Located<Expressions>& values, const FieldDescription& field,
                 Diagnostics& diagnostics) {
  Unit of_field;
  if (!read_unit(field.unit, of_field).empty()) return;
  for (const Expression& value : values.value)
    if (value.unit() && !same_dimension(*value.unit(), of_field))
      diagnostics.error(values.location, "a value is in " + value.unit()->text + ", and field '" +
                                             field.name + "' is in " + field.unit +
                                             ", such as '0.5 " + field.unit + "'");
}

WantedValues wanted_values(const FieldDescription& field, std::size_t first, std::size_t count) {
  WantedValues wanted{field.name, field.unit, {},
                      first,      count,      field.name == field_name::displacement};
  for (int c = 0; c < field.components; ++c)
    wanted.components.push_back(field.components == 1 ? ""
                                                      : std::string(1, static_cast<char>('x' + c)));
  return wanted;
}

}  // namespace

Conditions::Conditions(const Assembler& assembler, const std::vector<RateRule>& rate_rules,
                       const ConditionsDeck& deck, const NamedSources& named,
                       Diagnostics& diagnostics)
    : assembler_(assembler),
      dofs_(assembler.dofs()),
      moved_(dofs_, field_name::displacement),
      rate_rules_(rate_rules) {
  velocity_of_.assign(static_cast<std::size_t>(dofs_.rows()), -1);
  for (const auto& pair : assembler.kinematic_pairs())
    velocity_of_[static_cast<std::size_t>(pair.displacement)] = pair.velocity;
  for (const ConditionDeck& condition : deck.initial)
    initial_.push_back(resolve(condition, named, diagnostics));
  for (const ConditionDeck& condition : deck.prescribe) {
    prescribed_.push_back(resolve(condition, named, diagnostics));
    follow_the_mesh_ = follow_the_mesh_ || prescribed_.back().source->depends_on_moved_position();
  }
}

Conditions::Entry Conditions::resolve(const ConditionDeck& deck, const NamedSources& named,
                                      Diagnostics& diagnostics) const {
  Entry entry;
  entry.source = std::make_shared<ExpressionSource>(Expressions(2));
  entry.place = deck.source_location();
  entry.is_table = deck.TableSource::given.has_value();
  const Location& place = entry.place;
  const auto& formulas = deck.FormulaSource::given;
  entry.from = deck.from.value_or(entry.from);
  entry.until = deck.until.value_or(entry.until);
  entry.is_displacement = deck.field.value == field_name::displacement;
  entry.location = deck.location;
  entry.field = deck.field.value;
  entry.on = Domain(deck.on.value).text();
  entry.replaces = deck.replaces;
  const int field = find_field(dofs_, deck.field, diagnostics);
  if (field < 0) {
    for (const std::string& name : deck.on.value)
      find_region(dofs_.mesh(), name, deck.on.location, diagnostics);
    return entry;
  }
  entry.has_rate = rate_rules_[static_cast<std::size_t>(field)] != RateRule::none;
  for (const std::string& name : deck.on.value) {
    const Region* const region = find_region(dofs_.mesh(), name, deck.on.location, diagnostics);
    if (region == nullptr) continue;
    const auto rows = dofs_.region_rows(field, *region);
    if (!dofs_.mesh().communicator.any(!rows.empty()))
      diagnostics.error(deck.on.location,
                        "no module solves for '" + deck.field.value + "' on region '" + name +
                            "', nor beside it: what is said here would hold nowhere");
    entry.first_rows.insert(entry.first_rows.end(), rows.begin(), rows.end());
  }
  const int components = dofs_.fields()[static_cast<std::size_t>(field)].components;
  const bool all = deck.component.value == "all";
  entry.first_component = all ? 0 : deck.component.value[0] - 'x';
  if (!all && entry.first_component >= components) {
    diagnostics.error(deck.component.location, "field '" + deck.field.value +
                                                   "' has no component " + deck.component.value +
                                                   " here; it has " + component_names(components));
    return entry;
  }
  const std::size_t wanted = all ? static_cast<std::size_t>(components) : 1;
  const auto source =
      deck.make_source({dofs_.mesh().communicator, named,
                        wanted_values(dofs_.fields()[static_cast<std::size_t>(field)],
                                      static_cast<std::size_t>(entry.first_component), wanted),
                        diagnostics});
  if (!source) return entry;
  entry.source = source;
  const auto given = static_cast<std::size_t>(entry.source->components());
  if (given != wanted)
    diagnostics.error(place, std::to_string(wanted) + (wanted == 1 ? " value" : " values") +
                                 " needed for " +
                                 (all ? "the components " + component_names(components)
                                      : "component " + deck.component.value) +
                                 " of field '" + deck.field.value + "', " + std::to_string(given) +
                                 " given" + (formulas ? "; formulas are set apart by ';'" : ""));
  if (formulas)
    check_units(*formulas, dofs_.fields()[static_cast<std::size_t>(field)], diagnostics);
  if (entry.is_displacement && entry.source->depends_on_moved_position())
    diagnostics.error(place,
                      "a displacement cannot depend on x, y or z, the moved position that follows "
                      "from it" +
                          std::string(formulas ? "; use the reference coordinates X, Y, Z" : ""));
  return entry;
}

SpaceTime Conditions::point(LocalIndex row, const State& state) const {
  double X[3] = {0, 0, 0}, x[3] = {0, 0, 0};
  dofs_.position(row, X);
  moved_.position(row, state, x);
  return {x[0], x[1], x[2], X[0], X[1], X[2], state.time};
}

void Conditions::at_its_place(const Entry& entry, const std::function<void()>& work) {
  try {
    work();
  } catch (const DeckError& error) {
    throw DeckError(entry.place.text() + ": " + error.what());
  }
}

void Conditions::set_initial(State& state) const {
  // Displacements first: the moved position of the other fields' values follows from them.
  for (const bool moving : {true, false})
    for (const Entry& entry : initial_) {
      if (entry.is_displacement != moving) continue;
      dofs_.mesh().communicator.together(
          [&] { at_its_place(entry, [&] { set_initial(entry, state); }); });
      // A region's vertex may be a ghost here although none of the region's cells are here.
      assembler_.spread(state.value);
      assembler_.spread(state.rate);
    }
}

void Conditions::set_initial(const Entry& entry, State& state) const {
  const ValueSource& source = *entry.source;
  const auto components = static_cast<std::size_t>(source.components());
  std::vector<double> values(components), rates(components);
  for (const LocalIndex first : entry.first_rows) {
    const SpaceTime at = point(first, state);
    const NodeDisplacement moved = moved_.displacement_at(first);
    source.value(at, values.data());
    source.time_derivative(at, rates.data());
    for (std::size_t c = 0; c < components; ++c) {
      const auto row = static_cast<std::size_t>(first + entry.first_component) + c;
      state.value[row] = values[c];
      state.rate[row] = rates[c];
      if (moved.count == 0 || !source.depends_on_moved_position(static_cast<int>(c))) continue;
      double slope[3];
      source.gradient(at, static_cast<int>(c), slope);  // the node is carried along
      for (int j = 0; j < dofs_.mesh().dimension; ++j)
        state.rate[row] += slope[j] * moved.component(state.rate, j);
    }
  }
}

std::vector<PrescribedRow> Conditions::prescribed(const State& state, const State& end) const {
  std::vector<PrescribedRow> result;
  dofs_.mesh().communicator.together([&] {
    for (const Entry& entry : prescribed_)
      at_its_place(entry, [&] { prescribe(entry, state, end, result); });
  });
  return result;
}

void Conditions::prescribe(const Entry& entry, const State& state, const State& end,
                           std::vector<PrescribedRow>& result) const {
  // The slack of step control: an end of a step this near to an edge is the edge.
  const bool moves = std::isfinite(end.step);  // else steady: no velocity but the drift
  const double slack = moves ? 1e-6 * end.step : 0;
  if (end.time <= entry.from + slack || end.time > entry.until + slack) return;
  const ValueSource& source = *entry.source;
  const auto components = static_cast<std::size_t>(source.components());
  std::vector<double> values(components), rates(components);
  for (const LocalIndex first : entry.first_rows) {
    if (first >= dofs_.owned()) continue;
    const SpaceTime at = point(first, entry.has_rate ? end : state);
    source.value(at, values.data());
    bool rates_known = false;
    for (std::size_t c = 0; c < components; ++c) {
      const LocalIndex row = first + entry.first_component + static_cast<LocalIndex>(c);
      PrescribedRow prescribed{row, values[c]};
      if (source.depends_on_moved_position(static_cast<int>(c))) {
        source.gradient(at, static_cast<int>(c), prescribed.slope);
        prescribed.displacement = moved_.displacement_at(first);
      }
      result.push_back(prescribed);
      const LocalIndex velocity = velocity_of_[static_cast<std::size_t>(row)];
      if (velocity < 0) continue;
      if (!rates_known) source.time_derivative(at, rates.data());
      rates_known = true;
      const auto axis = static_cast<std::size_t>(entry.first_component) + c;
      result.push_back({velocity, moves ? rates[c] : end.drift[axis]});
    }
  }
}

std::vector<double> Conditions::events() const {
  std::vector<double> events;
  for (const Entry& entry : prescribed_)
    for (const double time : {entry.from, entry.until})
      if (std::abs(time) < std::numeric_limits<double>::infinity()) events.push_back(time);
  return events;
}

}  // namespace hawser
