#pragma once
// The part of Spec that does not depend on the struct: which attribute and child is which, and the
// words of every complaint.
#include <string>
#include <vector>

#include "hawser/deck/deck.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/node_spec.hpp"

namespace hawser {

struct ChildRule {
  std::string tag;
  bool is_required = false;
  bool repeats = false;
};

/// Reports an element that is not called `tag`.
bool is_expected_tag(const DeckNode& node, const std::string& tag, Diagnostics& diagnostics);

/// For every spec the attribute given for it, or null. Reports unknown, missing and empty ones.
std::vector<const DeckAttribute*> match_attributes(const DeckNode& node,
                                                   const std::vector<AttributeSpec>& specs,
                                                   Diagnostics& diagnostics);

/// For every child of `node` the position of its rule, or -1. Reports missing and doubled children,
/// and unknown ones unless `open`.
std::vector<int> match_children(const DeckNode& node, const std::vector<ChildRule>& rules,
                                bool open, Diagnostics& diagnostics);

/// Reports that the value of an attribute is not acceptable, for the reason given by read_value().
void report_value(const DeckNode& node, const DeckAttribute& attribute, const std::string& reason,
                  Diagnostics& diagnostics);

/// "must be one of a, b; did you mean 'a'?"
std::string not_among(const std::string& given, const std::vector<std::string>& allowed);

std::string trimmed(const std::string& text);
std::vector<std::string> split_at_blanks(const std::string& text);
std::vector<std::string> split_at(const std::string& text, char separator);  ///< parts are trimmed

}  // namespace hawser
