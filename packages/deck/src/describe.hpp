#pragma once
// Words that the description, the schema and the reference manual share.
#include <string>
#include <vector>

#include "hawser/deck/read_deck.hpp"

namespace hawser {

/// "number in m/s; >= 0; default 0".
std::string properties(const AttributeSpec& attribute);

/// "at most once".
std::string how_often(const ChildSpec& child);

/// Path of a child, as for --set: "solver/newton", "conditions/prescribe[name]".
std::string path_of_child(const std::string& parent, const ChildSpec& child);

/// With &lt; for < and so on.
std::string xml_escaped(const std::string& text);

}  // namespace hawser
