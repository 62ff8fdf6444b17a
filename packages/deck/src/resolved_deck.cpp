#include <algorithm>
#include <sstream>

#include "hawser/deck/node_spec.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "src/describe.hpp"

namespace hawser {
namespace {

class Writer {
 public:
  explicit Writer(const DeckLanguage& language) : language_(language) {}

  /// Without a spec, the node as it is.
  void write(const DeckNode& node, const NodeSpec* spec, const std::string& indent) {
    std::string start = indent + "<" + node.tag, given;
    for (const auto& [name, value] : attributes(node, spec)) {
      start += " " + name + "=\"" + xml_escaped(value) + "\"";
      const DeckAttribute* const written = node.find_attribute(name);
      if (written && on_one_line(written->value) != value)
        given += " " + name + "=\"" + on_one_line(written->value) + "\"";
    }
    if (!given.empty()) text_ += indent + "<!-- given:" + fit_for_comment(given) + " -->\n";
    text_ += start;
    const std::size_t end_of_tag = text_.size();
    text_ += ">\n";
    const std::size_t begin_of_children = text_.size();
    for (const DeckNode& child : node.children)
      write(child, language_.find_child(spec, child.tag), indent + "  ");
    if (spec) write_absent_children(node, *spec, indent + "  ");
    if (text_.size() == begin_of_children)
      text_.replace(end_of_tag, std::string::npos, "/>\n");
    else
      text_ += indent + "</" + node.tag + ">\n";
  }

  std::string take() { return std::move(text_); }

 private:
  using NamedValues = std::vector<std::pair<std::string, std::string>>;

  static NamedValues attributes(const DeckNode& node, const NodeSpec* spec) {
    NamedValues result;
    if (!spec) {
      for (const DeckAttribute& given : node.attributes)
        result.emplace_back(given.name, given.value);
      return result;
    }
    for (const AttributeSpec& attribute : spec->attributes) {
      const DeckAttribute* given = node.find_attribute(attribute.name);
      const std::string value = given ? resolved(*given, attribute, node) : attribute.default_text;
      if (!value.empty()) result.emplace_back(attribute.name, value);
    }
    return result;
  }

  // Plain numbers stay as they were written.
  static std::string resolved(const DeckAttribute& given, const AttributeSpec& spec,
                              const DeckNode& node) {
    std::string text = on_one_line(given.value);
    const bool plain = text.find_first_not_of("0123456789+-.eE; \t\r\n") == std::string::npos;
    if (plain || !spec.resolve) return text;
    static const Rules none;
    return spec.resolve({text, given.location, spec.unit, none, node.names.get()});
  }

  static std::string on_one_line(const std::string& text) {
    std::istringstream stream(text);
    std::string result;
    for (std::string word; stream >> word;)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }

  static std::string fit_for_comment(std::string text) {
    for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1))
      text.insert(at + 1, " ");
    return text;
  }

  void write_absent_children(const DeckNode& node, const NodeSpec& spec,
                             const std::string& indent) {
    for (const ChildSpec& child : spec.children) {
      const auto& attributes = child.node.attributes;
      // What has required attributes cannot be written out of defaults alone.
      const bool complete =
          std::none_of(attributes.begin(), attributes.end(),
                       [](const AttributeSpec& attribute) { return attribute.is_required; });
      if (child.has_defaults && complete && !node.find_child(child.node.tag))
        write({child.node.tag, {}, {}, {}, {}}, &child.node, indent);
    }
  }

  const DeckLanguage& language_;
  std::string text_;
};

}  // namespace

std::string resolved_deck(const DeckNode& node, const DeckLanguage& language) {
  Writer writer(language);
  writer.write(node, &language.root, "");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + writer.take();
}

std::string deck_text(const DeckNode& node) {
  const DeckLanguage none;
  Writer writer(none);
  writer.write(node, nullptr, "");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + writer.take();
}

}  // namespace hawser
