#include "hawser/deck/spec_reader.hpp"

#include <algorithm>

namespace hawser {
namespace {

std::string in_brackets(const std::string& tag) { return "<" + tag + ">"; }

std::string bracketed_list(const std::vector<std::string>& tags) {
  std::vector<std::string> bracketed;
  for (const std::string& tag : tags)
    bracketed.push_back(in_brackets(tag));
  return listed(bracketed);
}

template <class T, class Name>
std::size_t find_by(const std::vector<T>& items, const std::string& name, Name name_of) {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const T& item) { return name_of(item) == name; });
  return static_cast<std::size_t>(found - items.begin());
}

void report_unknown_attribute(const DeckNode& node, const DeckAttribute& attribute,
                              const std::vector<AttributeSpec>& specs, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const AttributeSpec& spec : specs)
    names.push_back(spec.name);
  std::string sentence =
      in_brackets(node.tag) + " has no attribute " + quoted(attribute.name) + "; allowed: ";
  diagnostics.error(attribute.location,
                    sentence + listed(names) + did_you_mean(attribute.name, names));
}

}  // namespace

bool is_expected_tag(const DeckNode& node, const std::string& tag, Diagnostics& diagnostics) {
  if (node.tag == tag) return true;
  diagnostics.error(node.location, in_brackets(node.tag) + " stands where " + in_brackets(tag) +
                                       " is needed" + did_you_mean(node.tag, {tag}));
  return false;
}

std::vector<const DeckAttribute*> match_attributes(const DeckNode& node,
                                                   const std::vector<AttributeSpec>& specs,
                                                   Diagnostics& diagnostics) {
  std::vector<const DeckAttribute*> result(specs.size(), nullptr);
  for (const DeckAttribute& attribute : node.attributes) {
    const std::size_t i =
        find_by(specs, attribute.name, [](const AttributeSpec& spec) { return spec.name; });
    if (i == specs.size()) {
      report_unknown_attribute(node, attribute, specs, diagnostics);
    } else {
      result[i] = &attribute;
    }
  }
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const AttributeSpec& spec = specs[i];
    const std::string type =
        spec.type + (spec.unit.empty() || spec.unit == "1" ? "" : " in " + spec.unit);
    if (!result[i]) {
      if (!spec.is_required) continue;
      diagnostics.error(node.location, in_brackets(node.tag) + " needs the attribute '" +
                                           spec.name + "' (" + type + "): " + spec.meaning);
    } else if (trimmed(result[i]->value).empty()) {
      diagnostics.error(result[i]->location, "attribute '" + spec.name + "' of " +
                                                 in_brackets(node.tag) +
                                                 " is empty; needed: " + type);
      result[i] = nullptr;
    }
  }
  return result;
}

std::vector<int> match_children(const DeckNode& node, const std::vector<ChildRule>& rules,
                                bool open, Diagnostics& diagnostics) {
  std::vector<int> result;
  std::vector<const DeckNode*> first(rules.size(), nullptr);
  std::vector<std::string> tags;
  for (const ChildRule& rule : rules)
    tags.push_back(rule.tag);
  for (const DeckNode& child : node.children) {
    const std::size_t i = find_by(rules, child.tag, [](const ChildRule& rule) { return rule.tag; });
    if (i == rules.size()) {
      if (!open) is_known_child(child, node.tag, tags, diagnostics);
      result.push_back(-1);
      continue;
    }
    result.push_back(static_cast<int>(i));
    if (first[i] && !rules[i].repeats)
      diagnostics.error(child.location, in_brackets(child.tag) + " stands twice in " +
                                            in_brackets(node.tag) + ", first at line " +
                                            std::to_string(first[i]->location.line) +
                                            "; allowed: once");
    if (!first[i]) first[i] = &child;
  }
  for (std::size_t i = 0; i < rules.size(); ++i)
    if (rules[i].is_required && !first[i])
      diagnostics.error(node.location,
                        in_brackets(node.tag) + " needs a child " + in_brackets(rules[i].tag));
  return result;
}

bool is_known_child(const DeckNode& child, const std::string& parent_tag,
                    const std::vector<std::string>& allowed, Diagnostics& diagnostics) {
  if (std::find(allowed.begin(), allowed.end(), child.tag) != allowed.end()) return true;
  diagnostics.error(child.location,
                    in_brackets(parent_tag) + " has no child " + in_brackets(child.tag) +
                        "; allowed: " + bracketed_list(allowed) + did_you_mean(child.tag, allowed));
  return false;
}

void report_value(const DeckNode& node, const DeckAttribute& attribute, const std::string& reason,
                  Diagnostics& diagnostics) {
  diagnostics.error(attribute.location, "attribute '" + attribute.name + "' of " +
                                            in_brackets(node.tag) + " is " +
                                            quoted(attribute.value) + ": " + reason);
}

std::string not_among(const std::string& given, const std::vector<std::string>& allowed) {
  return "it must be one of " + listed(allowed) + did_you_mean(given, allowed);
}

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

}  // namespace hawser
