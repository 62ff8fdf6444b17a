// The reference manual of decks, as Markdown.
#include <sstream>

#include "hawser/deck/manual.hpp"
#include "src/describe.hpp"

namespace hawser {
namespace {

// A bar would end the cell of the table; <tag> would be taken for HTML.
std::string fit_for_table(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|')
      result += "\\|";
    else if (c == '<')
      result += "&lt;";
    else if (c == '*')
      result += "\\*";
    else
      result += c;
  }
  return result;
}

std::string default_of(const AttributeSpec& attribute) {
  if (attribute.is_required) return "required";
  return attribute.default_text.empty() ? attribute.absent : "`" + attribute.default_text + "`";
}

void attributes(std::ostream& out, const NodeSpec& spec) {
  if (spec.attributes.empty()) return;
  out << "| attribute | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n";
  for (const AttributeSpec& a : spec.attributes)
    out << "| `" << a.name << "` | " << a.type << " | "
        << fit_for_table(a.unit.empty() ? "-" : a.unit) << " | " << fit_for_table(default_of(a))
        << " | " << fit_for_table(a.range.empty() ? "-" : a.range) << " | "
        << fit_for_table(a.meaning) << " |\n";
  out << '\n';
}

void element(std::ostream& out, const NodeSpec& spec, const DeckLanguage& language,
             const std::string& path, const std::string& how_often) {
  out << (path.empty() ? "## `<" : "### `<") << spec.tag << ">`\n\n";
  if (!path.empty()) out << "`" << path << "`, " << how_often << ". ";
  out << fit_for_table(spec.meaning) << '\n';
  if (!spec.source.empty()) out << "Source: " << spec.source << ".\n";
  out << '\n';
  attributes(out, spec);
  for (const ChildSpec& child : language.children(spec))
    element(out, child.node, language, path_of_child(path, child), hawser::how_often(child));
}

}  // namespace

std::string deck_reference(const DeckLanguage& language) {
  std::ostringstream out;
  out << "# Deck reference\n\n"
         "Made by `hawser describe --markdown` from the declarations that decks are read with; do "
         "not edit.\n[decks.md](decks.md) says what goes for all values: units, formulas, "
         "parameters, extending, paths.\nThe path under each heading is that of `--set` and "
         "`hawser describe`.\n\n";
  element(out, language.root, language, "", "");
  std::string text = out.str();
  text.pop_back();  // the empty line at the end
  return text;
}

}  // namespace hawser
