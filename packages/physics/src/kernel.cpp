#include <algorithm>

#include "hawser/base/error.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

int Kernel::rate_partner(std::size_t field) const {
  return hawser::rate_partner(fields_.data(), fields_.size(), field);
}

std::vector<double> Kernel::sample_amplitudes() const {
  return std::vector<double>(fields_.size(), 0.1);
}

void detail::check_size(const Kernel& kernel, const CellTabulation& table) {
  int unknowns = 0, most = 0;
  for (std::size_t f = 0; f < table.fields.size(); ++f) {
    most = std::max(most, table.fields[f].nodes);
    unknowns += table.fields[f].nodes * kernel.fields()[f].components;
  }
  if (unknowns > max_unknowns || most > max_nodes)
    throw PluginError("a kernel on '" + kernel.domain().text() + "' has " +
                      std::to_string(unknowns) + " unknowns and up to " + std::to_string(most) +
                      " nodes per cell; there is room for " + std::to_string(max_unknowns) +
                      " and " + std::to_string(max_nodes));
}

}  // namespace hawser
