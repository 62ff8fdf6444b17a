#include "hawser/physics/kernel.hpp"

#include <string_view>

namespace hawser {

int Kernel::rate_partner() const {
  for (std::size_t f = 0; f < fields_.size(); ++f)
    for (const FieldUse& use : fields_)
      if (use.follows != nullptr && std::string_view(use.follows) == fields_[f].name)
        return static_cast<int>(f);
  return -1;
}

std::vector<double> Kernel::sample_amplitudes() const {
  return std::vector<double>(fields_.size(), 0.1);
}

}  // namespace hawser
