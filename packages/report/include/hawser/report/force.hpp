#pragma once
// Forces as reports give them.
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/output/history.hpp"

namespace hawser {

/// In N; per metre of depth in a flow in the plane. `across` is 90 degrees to the left of the axis
/// in the plane; in space, where nothing is left, the magnitude of what is normal to the axis.
struct Force {
  double along = 0, across = 0, magnitude = 0;
};

/// The force as seen from an axis (of any length); both have the mesh's dimension.
Force split_force(const std::vector<double>& force, const std::vector<double>& axis);

/// NAME_force, NAME_force_along, NAME_force_across.
std::vector<Column> force_columns(const std::string& name, const Mesh& mesh);
inline std::vector<double> force_values(const Force& force) {
  return {force.magnitude, force.along, force.across};
}

}  // namespace hawser
