#pragma once
// gmsh's numbers of the types of elements.
#include <optional>
#include <string>

#include "hawser/element/cell_shape.hpp"

namespace hawser {

/// Of the types that are read. One more shape is one more case here.
std::optional<CellShape> shape_of(long long type);

/// Nodes of an element of any type that gmsh fills lines, planes and volumes with; 0: not known.
int nodes_of(long long type);

/// What an element is that is not read, and what to do about it in gmsh: "a quadrilateral; ...".
std::string what_is_refused(long long type);

}  // namespace hawser
