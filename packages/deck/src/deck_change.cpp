// Values that the command line replaces.
#include <algorithm>
#include <charconv>

#include "hawser/base/error.hpp"
#include "hawser/deck/number.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "src/deck_edit.hpp"
#include "src/shortened.hpp"

namespace hawser {
namespace {

struct Step {
  std::string tag, key;  // tag[key]
};

/// A part of a path: "b" or "b[k]".
std::string read_step(const std::string& part, Step& step) {
  const std::size_t bracket = part.find('[');
  if (bracket == std::string::npos && part.find(']') == std::string::npos)
    step = {part, ""};
  else if (bracket == std::string::npos || part.back() != ']')
    return "the path must be like time/step or conditions/prescribe[inflow]/value";
  else
    step = {part.substr(0, bracket), part.substr(bracket + 1, part.size() - bracket - 2)};
  return step.tag.empty() ? "the path must be like time/step; it has no '/' at its beginning" : "";
}

/// "a/b[k]/c": the steps a and b[k] to the element, and its attribute c.
std::string read_path(const std::string& path, std::vector<Step>& steps, std::string& attribute) {
  std::vector<std::string> parts(1);
  bool in_key = false;
  for (const char c : path) {
    if (c == '[') in_key = true;
    if (c == ']') in_key = false;
    if (c == '/' && !in_key)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  if (in_key) return "a ']' is missing in the path";
  attribute = parts.back();
  parts.pop_back();
  for (const std::string& part : parts) {
    std::string fault = read_step(part, steps.emplace_back());
    if (!fault.empty()) return fault;
  }
  return "";
}

/// "" for the name of an attribute.
std::string attribute_fault(const std::string& attribute) {
  if (attribute.empty() || attribute.find('[') != std::string::npos)
    return "the path must end with the name of an attribute, such as time/step";
  return "";
}

class Setter {
 public:
  Setter(const DeckChange& change, const DeckLanguage& language, Diagnostics& diagnostics)
      : where_{"--set " + shortened(change.text(), 120), 0, 0},
        change_(change),
        language_(language),
        diagnostics_(diagnostics) {}

  void set(DeckNode& root) {
    std::vector<Step> steps;
    std::string attribute;
    std::string fault = read_path(change_.path, steps, attribute);
    const bool removes = change_.value.empty();
    if (fault.empty() && !removes) fault = attribute_fault(attribute);
    if (!fault.empty()) return error(fault);
    const NodeSpec* spec = &language_.root;
    DeckNode* node = &root;
    if (!removes && steps.empty() && !is_attribute_of_root(root, attribute)) {
      if (!has_parameter(root, attribute)) return report_unknown_name(root, attribute);
      steps.push_back({"parameter", attribute});
      attribute = "value";
    }
    for (const Step& step : steps) {
      const NodeSpec* const child_spec = language_.find_child(spec, step.tag);
      node = go_to(*node, step, spec, child_spec);
      if (node == nullptr) return;
      spec = child_spec;
    }
    if (removes)
      remove(*node, attribute, spec);
    else
      set(*node, attribute, spec);
  }

 private:
  void error(const std::string& sentence) { diagnostics_.error(where_, sentence); }

  static bool has_parameter(DeckNode& root, const std::string& name) {
    const auto parameters = children_of(root, "parameter");
    return std::any_of(parameters.begin(), parameters.end(), [&](const DeckNode* parameter) {
      const DeckAttribute* const given = parameter->find_attribute("name");
      return given != nullptr && given->value == name;
    });
  }

  bool is_attribute_of_root(const DeckNode& root, const std::string& name) const {
    const auto& known = language_.root.attributes;
    return root.find_attribute(name) != nullptr ||
           std::any_of(known.begin(), known.end(),
                       [&](const AttributeSpec& attribute) { return attribute.name == name; });
  }

  void report_unknown_name(DeckNode& root, const std::string& name) {
    std::vector<std::string> names;
    for (const DeckNode* const parameter : children_of(root, "parameter"))
      if (const DeckAttribute* const given = parameter->find_attribute("name"))
        names.push_back(given->value);
    error("the deck has no parameter " + quoted(name) + "; it has " + listed(names) +
          did_you_mean(name, names) +
          (names.empty() ? "; other values are set by their path, such as time/step" : ""));
  }

  DeckNode* go_to(DeckNode& parent, const Step& step, const NodeSpec* parent_spec,
                  const NodeSpec* spec) {
    std::vector<DeckNode*> candidates = children_of(parent, step.tag);
    if (candidates.empty()) return make(parent, step, parent_spec);
    if (step.key.empty()) {
      if (candidates.size() == 1) return candidates.front();
      error("there are " + std::to_string(candidates.size()) + " <" + step.tag +
            ">; say which by name or number, such as " + step.tag +
            "[1]: " + keys_of(candidates, spec));
      return nullptr;
    }
    std::vector<std::string> keys;
    for (DeckNode* const candidate : candidates) {
      const DeckAttribute* const key = key_of(*candidate, spec);
      if (key != nullptr && trimmed(key->value) == step.key) return candidate;
      if (key != nullptr) keys.push_back(trimmed(key->value));
    }
    int number = 0;
    if (read_whole_number(step.key, number).empty() && number >= 1 &&
        static_cast<std::size_t>(number) <= candidates.size())
      return candidates[static_cast<std::size_t>(number - 1)];
    error("there is no <" + step.tag + "> " + quoted(step.key) +
          (candidates.size() == 1 ? "; there is " : "; there are ") + keys_of(candidates, spec) +
          did_you_mean(step.key, keys));
    return nullptr;
  }

  // An element that the deck leaves out, with all its defaults, is written for the purpose.
  DeckNode* make(DeckNode& parent, const Step& step, const NodeSpec* parent_spec) {
    const bool declared = parent_spec != nullptr && parent_spec->find_child(step.tag) != nullptr;
    if (declared && step.key.empty()) return &add_child(parent, {step.tag, where_, {}, {}, {}});
    std::vector<std::string> tags;
    for (const DeckNode& child : parent.children)
      tags.push_back(child.tag);
    for (std::size_t i = 0; parent_spec != nullptr && i < parent_spec->children.size(); ++i)
      tags.push_back(parent_spec->children[i].node.tag);
    std::sort(tags.begin(), tags.end());
    tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
    const bool known = std::find(tags.begin(), tags.end(), step.tag) != tags.end();
    error("<" + parent.tag + "> has no <" + step.tag + "> in this deck" +
          (known ? "" : "; there are " + listed(tags) + did_you_mean(step.tag, tags)));
    return nullptr;
  }

  void set(DeckNode& node, const std::string& name, const NodeSpec* spec) {
    std::vector<std::string> names;
    for (std::size_t i = 0; spec != nullptr && i < spec->attributes.size(); ++i)
      names.push_back(spec->attributes[i].name);
    if (spec != nullptr && std::find(names.begin(), names.end(), name) == names.end())
      return error("<" + node.tag + "> has no attribute " + quoted(name) +
                   "; allowed: " + listed(names) + did_you_mean(name, names));
    for (DeckAttribute& attribute : node.attributes)
      if (attribute.name == name) {
        attribute.value = change_.value, attribute.location = where_;
        return;
      }
    node.attributes.push_back({name, change_.value, where_});
  }

  /// The attribute of that name, or the element "tag" or "tag[key]".
  void remove(DeckNode& node, const std::string& what, const NodeSpec* spec) {
    const auto attribute =
        std::find_if(node.attributes.begin(), node.attributes.end(),
                     [&](const DeckAttribute& given) { return given.name == what; });
    if (attribute != node.attributes.end()) {
      node.attributes.erase(attribute);
      return;
    }
    Step step;
    const std::string fault = read_step(what, step);
    if (!fault.empty()) return error(fault);
    if (!children_of(node, step.tag).empty()) {
      DeckNode* const child = go_to(node, step, spec, language_.find_child(spec, step.tag));
      if (child != nullptr)
        node.children.erase(node.children.begin() + (child - node.children.data()));
      return;
    }
    std::vector<std::string> names;
    for (const DeckAttribute& given : node.attributes)
      names.push_back(given.name);
    for (const DeckNode& child : node.children)
      names.push_back(child.tag);
    error("<" + node.tag + "> has no " + quoted(what) + " that could be taken away; it has " +
          listed(names) + did_you_mean(what, names));
  }

  Location where_;
  const DeckChange& change_;
  const DeckLanguage& language_;
  Diagnostics& diagnostics_;
};

}  // namespace

DeckChange read_change(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(ExitCode::usage, "--set " + text + ": needed is path=value, such as time/step=5");
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

void apply(const DeckChange& change, DeckNode& root, const DeckLanguage& language,
           Diagnostics& diagnostics) {
  Setter(change, language, diagnostics).set(root);
}

}  // namespace hawser
