// The named values of a deck.
#include <algorithm>
#include <cctype>
#include <set>

#include "hawser/deck/spec_reader.hpp"
#include "src/deck_edit.hpp"
#include "src/formula_tokens.hpp"
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

/// The names in an element's values and in those of all inside of it.
void collect_names(const DeckNode& node, std::set<std::string>& names) {
  const auto in_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  static const std::set<std::string> prose = {"name", "title", "meaning", "why"};
  for (const DeckAttribute& attribute : node.attributes) {
    if (prose.count(attribute.name) > 0) continue;
    const std::string& text = attribute.value;
    for (auto at = text.begin(); at != text.end();) {
      const auto end = std::find_if_not(at, text.end(), in_name);
      if (end != at) names.emplace(at, end);
      at = end == text.end() ? end : end + 1;
    }
  }
  for (const DeckNode& child : node.children)
    collect_names(child, names);
}

/// A parameter may wait for a deck that extends this one and uses it. Not so one whose name nearly
/// is that of one in use: a change of a base's parameter under a wrong name would go unseen.
void report_misspelt(const NamedValues& values, const DeckNode& root, Diagnostics& diagnostics) {
  std::set<std::string> used;
  collect_names(root, used);
  std::vector<std::string> used_parameters;
  for (const NamedValue& value : values)
    if (used.count(value.name) > 0) used_parameters.push_back(value.name);
  for (const NamedValue& value : values) {
    if (used.count(value.name) > 0) continue;
    const std::string meant = nearest_name(value.name, used_parameters);
    if (!meant.empty())
      diagnostics.error(value.location, "nothing uses the parameter '" + value.name +
                                            "'; did you mean '" + meant + "'?");
  }
}

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
  const auto values = std::make_shared<const NamedValues>(definitions.take());
  report_misspelt(*values, root, diagnostics);
  hand_out(values, root);
}

}  // namespace hawser
