#pragma once
// Parameters of a module that have a component per direction.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/tensor.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/location.hpp"

namespace hawser {

/// A fault where numbers or formulas are not as many as the mesh has directions. None at all is
/// well: the deck leaves them out.
template <class Components>
void check_components(const Located<Components>& vector, const std::string& name, int dimension,
                      Diagnostics& diagnostics) {
  const std::size_t given = vector.value.size();
  if (given != 0 && given != static_cast<std::size_t>(dimension))
    diagnostics.error(vector.location, name + " has " + std::to_string(given) +
                                           " components, the mesh " + std::to_string(dimension));
}

/// Weight of a `mass`, kg, N; or of a mass per length, kg/m, N/m. Along `gravity`, m/s^2; as much
/// as `submerged`, where it is given, else mass times gravity. None without gravity.
template <int D>
Vector<double, D> weight_in_water(const std::vector<double>& gravity,
                                  const std::optional<double>& submerged, double mass) {
  Vector<double, D> weight;
  double squared = 0;
  for (const double component : gravity)
    squared += component * component;
  if (squared == 0) return weight;
  const double factor = submerged ? *submerged / std::sqrt(squared) : mass;
  for (int i = 0; i < D; ++i)
    weight[i] = factor * gravity[static_cast<std::size_t>(i)];
  return weight;
}

}  // namespace hawser
