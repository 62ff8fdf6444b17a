#include "src/refine_deck.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_parameters.hpp"

namespace hawser {
namespace {

/// The growth of cells with the distance from the cable is halved with the sizes: so all cells are
/// halved, those between the cable and the far field too.
const std::vector<std::string> lengths = {"size", "cable-size", "far-size", "end-size", "growth"};
const std::vector<std::string> counts = {"cells", "segments"};

DeckNode* child(DeckNode& node, const std::string& tag) {
  for (DeckNode& candidate : node.children)
    if (candidate.tag == tag) return &candidate;
  return nullptr;
}

const NodeSpec* spec_of_child(const NodeSpec& spec, const std::string& tag) {
  for (const ChildSpec& candidate : spec.children)
    if (candidate.node.tag == tag) return &candidate.node;
  return nullptr;
}

/// Numbers stay numbers, a unit after them stays; formulas get a factor each.
std::string multiplied(const std::string& text, double factor) {
  std::istringstream words(text);
  std::vector<double> numbers;
  for (double number = 0; words >> number;)
    numbers.push_back(number * factor);
  words.clear();
  std::string rest;
  std::getline(words >> std::ws, rest);
  const bool unit = !numbers.empty() && !rest.empty() && std::isalpha(rest[0]) != 0;
  if (!numbers.empty() && (rest.empty() || unit))
    return write_value(numbers) + (unit ? " " + rest : "");
  std::string result;
  std::istringstream formulas(text);
  for (std::string formula; std::getline(formulas, formula, ';');)
    result += (result.empty() ? "(" : "; (") + formula + ")*" + write_value(factor);
  return result;
}

/// An attribute, or its default where it is not given.
void multiply(DeckNode& node, const AttributeSpec& attribute, double factor) {
  auto given = std::find_if(node.attributes.begin(), node.attributes.end(),
                            [&](const DeckAttribute& a) { return a.name == attribute.name; });
  if (given == node.attributes.end()) {
    if (attribute.default_text.empty()) return;
    given = node.attributes.insert(given, {attribute.name, attribute.default_text, node.location});
  }
  given->value = multiplied(given->value, factor);
}

void refine_mesh(DeckNode& mesh, const NodeSpec& spec, double factor) {
  for (DeckNode& source : mesh.children) {
    if (source.tag == "file")
      throw DeckError(source.location.text() +
                      ": a mesh from a file cannot be refined; refine in time, or let the deck "
                      "generate its mesh");
    const NodeSpec* const known = spec_of_child(spec, source.tag);
    if (known == nullptr) continue;
    const auto among = [](const std::vector<std::string>& names, const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const AttributeSpec& attribute : known->attributes)
      if (among(lengths, attribute.name))
        multiply(source, attribute, 1 / factor);
      else if (among(counts, attribute.name))
        multiply(source, attribute, factor);
  }
}

void refine_time(DeckNode& time, const NodeSpec& spec, double factor) {
  const DeckAttribute* const scheme = time.find_attribute("scheme");
  if (scheme != nullptr && scheme->value == "steady")
    throw DeckError(time.location.text() + ": a steady solve has no step to refine");
  for (const AttributeSpec& attribute : spec.attributes)
    if (attribute.name == "step" || attribute.name == "least-step")
      multiply(time, attribute, 1 / factor);
}

}  // namespace

void refine(DeckNode& deck, const RefinedBy& refined) {
  const double factor = std::ldexp(1.0, refined.level);
  const NodeSpec spec = RunDeck::spec().node_spec();
  DeckNode* const mesh = child(deck, "mesh");
  DeckNode* const time = child(deck, "time");
  if (refined.what != Refinement::time && mesh != nullptr)
    refine_mesh(*mesh, *spec_of_child(spec, "mesh"), factor);
  if (refined.what != Refinement::space && time != nullptr)
    refine_time(*time, *spec_of_child(spec, "time"), factor);
  deck.children.erase(std::remove_if(deck.children.begin(), deck.children.end(),
                                     [](const DeckNode& node) { return node.tag == "expect"; }),
                      deck.children.end());
}

}  // namespace hawser
