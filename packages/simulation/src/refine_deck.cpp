#include "src/refine_deck.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_parameters.hpp"

namespace hawser {
namespace {

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

/// A number stays one, a unit after it stays; a formula gets the factor.
std::string multiplied(const std::string& text, double factor) {
  std::istringstream words(text);
  double number = 0;
  words >> number;
  const bool starts_with_number = !words.fail();
  words.clear();
  std::string rest;
  std::getline(words >> std::ws, rest);
  const bool unit = !rest.empty() && std::isalpha(static_cast<unsigned char>(rest[0])) != 0;
  if (starts_with_number && (rest.empty() || unit))
    return write_value(number * factor) + (unit ? " " + rest : "");
  return "(" + text + ")*" + write_value(factor);
}

std::string increased(const std::string& text, int by) {
  const bool number = text.find_first_not_of("0123456789") == std::string::npos;
  return number ? std::to_string(std::stoi(text) + by) : "(" + text + ") + " + std::to_string(by);
}

/// The text of an attribute, written out where it is not given.
std::string& given_or_default(DeckNode& node, const AttributeSpec& attribute) {
  for (DeckAttribute& given : node.attributes)
    if (given.name == attribute.name) return given.value;
  return node.attributes
      .emplace_back(DeckAttribute{attribute.name, attribute.default_text, node.location})
      .value;
}

/// Boxes are refined by cutting their triangles, so that meshes are nested.
void refine_mesh(DeckNode& mesh, const NodeSpec& spec, int level) {
  for (DeckNode& source : mesh.children) {
    if (source.tag == "file")
      throw DeckError(source.location.text() +
                      ": a mesh from a file cannot be refined; refine in time, or let the deck "
                      "generate its mesh");
    const NodeSpec* const known = spec_of_child(spec, source.tag);
    if (known == nullptr) continue;
    for (const AttributeSpec& attribute : known->attributes)
      if (attribute.name == "refinements") {
        std::string& text = given_or_default(source, attribute);
        text = increased(text, level);
      } else if (attribute.name == "segments") {
        std::string& text = given_or_default(source, attribute);
        text = multiplied(text, std::ldexp(1.0, level));
      }
  }
}

void refine_time(DeckNode& time, const NodeSpec& spec, int level) {
  const DeckAttribute* const scheme = time.find_attribute("scheme");
  if (scheme != nullptr && scheme->value == "steady")
    throw DeckError(time.location.text() + ": a steady solve has no step to refine");
  for (const AttributeSpec& attribute : spec.attributes)
    if (attribute.name == "step" || attribute.name == "least-step") {
      std::string& text = given_or_default(time, attribute);
      text = multiplied(text, std::ldexp(1.0, -level));
    }
}

}  // namespace

void refine(DeckNode& deck, const RefinedBy& refined) {
  const NodeSpec spec = RunDeck::spec().node_spec();
  DeckNode* const mesh = child(deck, "mesh");
  DeckNode* const time = child(deck, "time");
  if (refined.what != Refinement::time && mesh != nullptr)
    refine_mesh(*mesh, *spec_of_child(spec, "mesh"), refined.level);
  if (refined.what != Refinement::space && time != nullptr)
    refine_time(*time, *spec_of_child(spec, "time"), refined.level);
  deck.children.erase(std::remove_if(deck.children.begin(), deck.children.end(),
                                     [](const DeckNode& node) { return node.tag == "expect"; }),
                      deck.children.end());
}

}  // namespace hawser
