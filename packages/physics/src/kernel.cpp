#include "hawser/physics/kernel.hpp"

#include <string_view>

namespace hawser {

int Kernel::rate_partner() const {
  for (std::size_t f = 0; f < fields_.size(); ++f)
    if (std::string_view(fields_[f].name) == "velocity") return static_cast<int>(f);
  return -1;
}

std::vector<double> Kernel::sample_amplitudes() const {
  return std::vector<double>(fields_.size(), 0.1);
}

}  // namespace hawser
