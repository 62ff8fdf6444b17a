#include "src/describe.hpp"

#include <algorithm>
#include <optional>

#include "hawser/base/error.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/manual.hpp"

namespace hawser {
namespace {

void write_attributes(std::string& text, const std::vector<AttributeSpec>& attributes,
                      const std::string& indent) {
  std::size_t width = 0;
  for (const AttributeSpec& attribute : attributes)
    width = std::max(width, attribute.name.size());
  for (const AttributeSpec& attribute : attributes) {
    const std::string padding(width - attribute.name.size() + 2, ' ');
    text += indent + attribute.name + padding + properties(attribute) + "\n";
    text += indent + std::string(width + 2, ' ') + attribute.meaning + "\n";
  }
}

/// `path` is null where paths are of no use.
void write_element(std::string& text, const NodeSpec& spec, const std::string* path,
                   const std::string& note, const std::string& indent) {
  text += indent + "<" + spec.tag + ">" + note + "  " + spec.meaning + "\n";
  const std::string inner = indent + "  ";
  if (path != nullptr && !path->empty()) text += inner + "path: " + *path + "\n";
  if (!spec.source.empty()) text += inner + "source: " + spec.source + "\n";
  write_attributes(text, spec.attributes, inner);
  for (const ChildSpec& child : spec.children) {
    const std::string child_path = path_of_child(path == nullptr ? "" : *path, child);
    write_element(text, child.node, path == nullptr ? nullptr : &child_path,
                  " " + how_often(child) + ".", inner);
  }
  if (!spec.open_children.empty()) text += inner + "<...> any of the " + spec.open_children + "\n";
}

/// An element, or an attribute of it, and the path that leads there.
struct Place {
  std::string path;
  NodeSpec element;
  std::optional<AttributeSpec> attribute;

  std::string name() const { return attribute ? attribute->name : element.tag; }
};

std::string joined(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + "/" + name;
}

void collect(std::vector<Place>& places, const NodeSpec& spec, const std::string& path,
             const DeckLanguage& language) {
  places.push_back({path, spec, std::nullopt});
  for (const AttributeSpec& attribute : spec.attributes)
    places.push_back({joined(path, attribute.name), spec, attribute});
  for (const ChildSpec& child : language.children(spec))
    collect(places, child.node, joined(path, child.node.tag), language);
}

/// "conditions/prescribe[inflow]/value" without the key.
std::string without_keys(const std::string& path) {
  std::string result;
  bool in_key = false;
  for (const char c : path) {
    in_key = c == '[' || (in_key && c != ']');
    if (!in_key && c != ']') result += c;
  }
  return result;
}

/// What is at the path; else every element of that name; else every attribute.
std::vector<Place> find_places(const std::vector<Place>& all, const std::string& path) {
  std::vector<Place> elements, attributes;
  for (const Place& place : all) {
    if (place.path == path) return {place};
    if (place.name() == path) (place.attribute ? attributes : elements).push_back(place);
  }
  return elements.empty() ? attributes : elements;
}

std::string describe(const Place& place, const DeckLanguage& language) {
  std::string text;
  if (!place.attribute) {
    write_element(text, place.element, &place.path, "", "");
    for (const auto& [parent, specs] : language.open_children) {
      if (!place.path.empty() && place.element.tag != parent) continue;
      std::vector<std::string> tags;
      for (const NodeSpec& spec : specs)
        tags.push_back(spec.tag);
      text += parent + ": " + listed(tags) + "; hawser describe NAME\n";
    }
  } else {
    text = place.path + ", attribute of <" + place.element.tag + ">\n";
    write_attributes(text, {*place.attribute}, "  ");
    if (!place.element.source.empty()) text += "  source: " + place.element.source + "\n";
  }
  return text;
}

}  // namespace

std::string properties(const AttributeSpec& spec) {
  std::string text = spec.type;
  if (spec.unit == "1")
    text += ", no unit";
  else if (!spec.unit.empty())
    text += " in " + spec.unit;
  if (!spec.range.empty()) text += "; " + spec.range;
  if (spec.is_required) return text + "; required";
  if (!spec.default_text.empty()) return text + "; default " + spec.default_text;
  return text + "; " + (spec.absent.empty() ? "optional" : "left out: " + spec.absent);
}

std::string how_often(const ChildSpec& child) {
  if (child.repeats) return child.is_required ? "at least once" : "any number of times";
  return child.is_required ? "once" : "at most once";
}

std::string path_of_child(const std::string& parent, const ChildSpec& child) {
  const std::string key = child.repeats ? child.node.key() : "";
  return (parent.empty() ? "" : parent + "/") + child.node.tag +
         (key.empty() ? "" : "[" + key + "]");
}

std::string xml_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string describe(const NodeSpec& spec) {
  std::string text;
  write_element(text, spec, nullptr, "", "");
  return text;
}

std::string describe(const DeckLanguage& language, const std::string& path) {
  std::vector<Place> all;
  collect(all, language.root, "", language);
  const std::string wanted = without_keys(path);
  const std::vector<Place> found = find_places(all, wanted);
  if (found.size() == 1) return describe(found.front(), language);
  std::vector<std::string> names;
  for (const Place& place : found.empty() ? all : found)
    names.push_back(found.empty() && wanted.find('/') == std::string::npos ? place.name()
                                                                           : place.path);
  if (found.empty())
    throw Error(ExitCode::usage, "a deck has nothing called " + quoted(path) +
                                     "; hawser describe lists all there is" +
                                     did_you_mean(wanted, names));
  std::string text = "there are several, at these paths:\n";
  for (const std::string& name : names)
    text += "  " + name + "\n";
  return text;
}

}  // namespace hawser
