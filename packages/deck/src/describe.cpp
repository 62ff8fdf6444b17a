#include <algorithm>

#include "hawser/deck/node_spec.hpp"

namespace hawser {
namespace {

std::string properties(const AttributeSpec& spec) {
  std::string text = spec.type;
  if (spec.unit == "1")
    text += ", no unit";
  else if (!spec.unit.empty())
    text += " in " + spec.unit;
  if (!spec.range.empty()) text += "; " + spec.range;
  if (spec.is_required)
    text += "; required";
  else
    text += spec.default_text.empty() ? "; optional" : "; default " + spec.default_text;
  return text;
}

std::string how_often(const ChildSpec& child) {
  if (child.repeats) return child.is_required ? "at least once" : "any number of times";
  return child.is_required ? "once" : "at most once";
}

void describe_into(std::string& text, const NodeSpec& spec, const std::string& note,
                   const std::string& indent) {
  text += indent + "<" + spec.tag + ">" + note + "  " + spec.meaning + "\n";
  std::size_t width = 0;
  for (const AttributeSpec& attribute : spec.attributes)
    width = std::max(width, attribute.name.size());
  const std::string inner = indent + "  ";
  for (const AttributeSpec& attribute : spec.attributes) {
    const std::string padding(width - attribute.name.size() + 2, ' ');
    text += inner + attribute.name + padding + properties(attribute) + "\n";
    text += inner + std::string(width + 2, ' ') + attribute.meaning + "\n";
  }
  for (const ChildSpec& child : spec.children)
    describe_into(text, child.node, " " + how_often(child) + ".", inner);
  if (!spec.open_children.empty()) text += inner + "<...> any of the " + spec.open_children + "\n";
}

}  // namespace

std::string describe(const NodeSpec& spec) {
  std::string text;
  describe_into(text, spec, "", "");
  return text;
}

}  // namespace hawser
