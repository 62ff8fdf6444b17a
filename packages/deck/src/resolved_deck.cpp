#include <algorithm>

#include "hawser/deck/node_spec.hpp"
#include "hawser/deck/spec_reader.hpp"

namespace hawser {
namespace {

std::string escaped(const std::string& text) {
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

class Writer {
 public:
  explicit Writer(const SpecLookup& lookup) : lookup_(lookup) {}

  /// Without a spec, the node as it is.
  void write(const DeckNode& node, const NodeSpec* spec, const std::string& indent) {
    text_ += indent + "<" + node.tag;
    for (const auto& [name, value] : attributes(node, spec))
      text_ += " " + name + "=\"" + escaped(value) + "\"";
    const std::size_t end_of_tag = text_.size();
    text_ += ">\n";
    const std::size_t begin_of_children = text_.size();
    for (const DeckNode& child : node.children)
      write(child, spec_of(child, spec), indent + "  ");
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
      const std::string value = given ? trimmed(given->value) : attribute.default_text;
      if (!value.empty()) result.emplace_back(attribute.name, value);
    }
    return result;
  }

  const NodeSpec* spec_of(const DeckNode& child, const NodeSpec* parent) const {
    if (!parent) return nullptr;
    for (const ChildSpec& candidate : parent->children)
      if (candidate.node.tag == child.tag) return &candidate.node;
    return lookup_ ? lookup_(child.tag) : nullptr;
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
        write({child.node.tag, {}, {}, {}}, &child.node, indent);
    }
  }

  const SpecLookup& lookup_;
  std::string text_;
};

}  // namespace

std::string resolved_deck(const DeckNode& node, const NodeSpec& spec, const SpecLookup& lookup) {
  Writer writer(lookup);
  writer.write(node, &spec, "");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + writer.take();
}

}  // namespace hawser
