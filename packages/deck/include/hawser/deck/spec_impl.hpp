#pragma once
// Definitions of Spec's templates; included by spec.hpp only.
#include <memory>

#include "hawser/deck/spec.hpp"

namespace hawser {

template <class P>
template <class T, class Owner>
Spec<P>&& Spec<P>::attribute(const std::string& name, T Owner::*member, const std::string& unit,
                             const Rules& rules, const std::string& meaning) && {
  Attribute attribute;
  attribute.spec = {name,        type_name(T{}),    unit,        "", rules.range_text(), meaning,
                    rules.words, rules.is_required, rules.absent};
  if constexpr (IsNumeric<T>::value)
    attribute.spec.resolve = [](const Reading& reading) {
      T value{};
      return read_value(reading, value).empty() ? write_value(value) : reading.text;
    };
  attribute.rules = rules;
  attribute.read = [member](const Reading& reading, P& p) {
    T value = p.*member;
    std::string fault = read_value(reading, value);
    if (fault.empty()) p.*member = std::move(value);
    return fault;
  };
  attribute.write = [member](const P& p) { return write_value(p.*member); };
  attributes_.push_back(std::move(attribute));
  return std::move(*this);
}

template <class P>
template <class T, class Owner>
Spec<P>&& Spec<P>::choice(const std::string& name, T Owner::*member, const Rules& rules,
                          std::vector<std::pair<std::string, T>> words,
                          const std::string& meaning) && {
  Attribute attribute;
  attribute.spec = {name, "choice", "", "", "", meaning, {}, rules.is_required, rules.absent};
  for (const auto& word : words)
    attribute.spec.choices.push_back(word.first);
  attribute.spec.range = "one of " + listed(attribute.spec.choices);
  attribute.rules = rules;
  attribute.read = [member, words, names = attribute.spec.choices](const Reading& reading, P& p) {
    for (const auto& [word, value] : words) {
      if (word != reading.text) continue;
      p.*member = value;
      return std::string();
    }
    return not_among(reading.text, names);
  };
  attribute.write = [member, words](const P& p) {
    for (const auto& [word, value] : words)
      if (value == p.*member) return word;
    return std::string();
  };
  attributes_.push_back(std::move(attribute));
  return std::move(*this);
}

template <class P>
template <class Q, class Owner>
Spec<P>&& Spec<P>::child(Q Owner::*member, Spec<Q> spec, const Rules& rules) && {
  auto shared = std::make_shared<const Spec<Q>>(std::move(spec));
  children_.push_back({{shared->tag(), rules.is_required, false},
                       [member, shared](const DeckNode& node, P& p, Diagnostics& diagnostics) {
                         shared->read_into(node, p.*member, diagnostics);
                       },
                       [member, shared, required = rules.is_required](const P& p) {
                         return ChildSpec{shared->node_spec(p.*member), required, false, !required};
                       }});
  return std::move(*this);
}

template <class P>
template <class Q, class Owner>
Spec<P>&& Spec<P>::child(std::optional<Q> Owner::*member, Spec<Q> spec, const Rules& rules) && {
  auto shared = std::make_shared<const Spec<Q>>(std::move(spec));
  children_.push_back({{shared->tag(), rules.is_required, false},
                       [member, shared](const DeckNode& node, P& p, Diagnostics& diagnostics) {
                         shared->read_into(node, (p.*member).emplace(), diagnostics);
                       },
                       [shared, required = rules.is_required](const P&) {
                         return ChildSpec{shared->node_spec(), required, false, false};
                       }});
  return std::move(*this);
}

template <class P>
template <class Q, class Owner>
Spec<P>&& Spec<P>::children(std::vector<Q> Owner::*member, Spec<Q> spec, const Rules& rules) && {
  auto shared = std::make_shared<const Spec<Q>>(std::move(spec));
  children_.push_back({{shared->tag(), rules.is_required, true},
                       [member, shared](const DeckNode& node, P& p, Diagnostics& diagnostics) {
                         shared->read_into(node, (p.*member).emplace_back(), diagnostics);
                       },
                       [shared, required = rules.is_required](const P&) {
                         return ChildSpec{shared->node_spec(), required, true, false};
                       }});
  return std::move(*this);
}

template <class P>
template <class Owner>
Spec<P>&& Spec<P>::any_children(std::vector<DeckNode> Owner::*member, const std::string& kind) && {
  open_kind_ = kind;
  take_open_child_ = [member](const DeckNode& node, P& p) { (p.*member).push_back(node); };
  return std::move(*this);
}

template <class P>
template <class Owner>
Spec<P>&& Spec<P>::location(Location Owner::*member) && {
  take_location_.push_back([member](const Location& where, P& p) { p.*member = where; });
  return std::move(*this);
}

template <class P>
void Spec<P>::read_into(const DeckNode& node, P& value, Diagnostics& diagnostics) const {
  const std::size_t errors_before = diagnostics.error_count();
  for (const auto& take : take_location_)
    take(node.location, value);

  std::vector<AttributeSpec> specs;
  for (const Attribute& attribute : attributes_)
    specs.push_back(attribute.spec);
  const auto given = match_attributes(node, specs, diagnostics);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) continue;
    const Attribute& attribute = attributes_[i];
    const Reading reading{trimmed(given[i]->value), given[i]->location, attribute.spec.unit,
                          attribute.rules, node.names.get()};
    const std::string fault = attribute.read(reading, value);
    if (!fault.empty()) report_value(node, *given[i], fault, diagnostics);
  }

  std::vector<ChildRule> rules;
  for (const Child& child : children_)
    rules.push_back(child.rule);
  const auto rule_of = match_children(node, rules, bool(take_open_child_), diagnostics);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (rule_of[i] >= 0)
      children_[static_cast<std::size_t>(rule_of[i])].read(node.children[i], value, diagnostics);
    else if (take_open_child_)
      take_open_child_(node.children[i], value);
  }

  if (diagnostics.error_count() > errors_before) return;
  for (const Check& check : checks_)
    check(value, node.location, diagnostics);
}

template <class P>
NodeSpec Spec<P>::node_spec(const P& defaults) const {
  NodeSpec result;
  result.tag = tag_;
  result.meaning = meaning_;
  result.source = source_;
  result.open_children = open_kind_;
  for (const Attribute& attribute : attributes_) {
    result.attributes.push_back(attribute.spec);
    if (!attribute.spec.is_required)
      result.attributes.back().default_text = attribute.write(defaults);
  }
  for (const Child& child : children_)
    result.children.push_back(child.describe(defaults));
  return result;
}

}  // namespace hawser
