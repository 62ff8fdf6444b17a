// The named values of a deck.
#include <algorithm>
#include <cctype>

#include "hawser/deck/spec_reader.hpp"
#include "src/deck_edit.hpp"
#include "src/formula.hpp"
#include "src/quantity.hpp"

namespace hawser {
namespace {

std::string name_fault(const std::string& name, const NamedValues& known) {
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  if (!std::all_of(name.begin(), name.end(), fits) ||
      std::isdigit(static_cast<unsigned char>(name[0])))
    return "a name in formulas has letters, digits and _ only, such as tow_speed";
  const auto taken = names_of_formulas();
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    return "formulas use this name already; taken are " + listed(taken);
  if (const NamedValue* const first = find_named(&known, name))
    return "a parameter of this name stands at " + first->location.text() + " already";
  return "";
}

class Definitions {
 public:
  explicit Definitions(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // What is missing altogether is reported when the element is read by its spec.
  void add(const DeckNode& node) {
    const DeckAttribute* const name = node.find_attribute("name");
    const DeckAttribute* const value = node.find_attribute("value");
    if (name == nullptr || value == nullptr) return;
    NamedValue result{trimmed(name->value), 1, 1, std::nullopt, node.location};
    if (result.name.empty() || trimmed(value->value).empty()) return;
    const std::string fault = name_fault(result.name, values_);
    if (!fault.empty()) return report_value(node, *name, fault, diagnostics_);
    if (const DeckAttribute* const unit = node.find_attribute("unit")) read(node, *unit, result);
    read_value_of(node, *value, result);
    values_.push_back(result);
  }

  NamedValues take() { return std::move(values_); }

 private:
  void read(const DeckNode& node, const DeckAttribute& attribute, NamedValue& result) {
    Unit unit;
    const std::string fault = read_unit(attribute.value, unit);
    if (!fault.empty()) return report_value(node, attribute, fault, diagnostics_);
    result.unit = unit;
  }

  // A bare number is in the unit that the element names, or else in SI units.
  void read_value_of(const DeckNode& node, const DeckAttribute& attribute, NamedValue& result) {
    const std::string text = trimmed(attribute.value);
    const std::string wanted = result.unit ? result.unit->text : "SI";
    const Rules rules;
    const Reading reading{text, attribute.location, wanted, rules, &values_};
    double value = 0;
    const std::string fault = read_quantity(reading, text, value);
    if (!fault.empty()) return report_value(node, attribute, fault, diagnostics_);
    Expression expression;
    if (result.unit) {
      result.given = value;
      result.value = value * result.unit->factor;
    } else if (read_expression(reading, text, expression).empty()) {
      result.value = value;
      result.unit = expression.unit();
      result.given = value / (result.unit ? result.unit->factor : 1);
    }
  }

  NamedValues values_;
  Diagnostics& diagnostics_;
};

void hand_out(const std::shared_ptr<const NamedValues>& names, DeckNode& node) {
  node.names = names;
  for (DeckNode& child : node.children)
    hand_out(names, child);
}

}  // namespace

void define_parameters(DeckNode& root, Diagnostics& diagnostics) {
  Definitions definitions(diagnostics);
  for (const DeckNode& child : root.children)
    if (child.tag == "parameter") definitions.add(child);
  hand_out(std::make_shared<const NamedValues>(definitions.take()), root);
}

}  // namespace hawser
