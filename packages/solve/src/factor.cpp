#include "hawser/solve/factor.hpp"

#include "block_factor.hpp"
#include "mumps_factor.hpp"
#include "schwarz_factor.hpp"

namespace hawser {

std::unique_ptr<Factor> make_factor(const BlockSystem& system, const RowScaling& scaling,
                                    const LinearOptions& options) {
  switch (options.method) {
    case LinearOptions::Method::gmres:
      return std::make_unique<SchwarzFactor>(system.communicator, options);
    case LinearOptions::Method::mumps:
      return std::make_unique<MumpsFactor>(system.communicator, options.repeatable);
    case LinearOptions::Method::blocks:
      return std::make_unique<BlockFactor>(system, scaling, options);
  }
  throw std::logic_error("make_factor: unknown method");
}

}  // namespace hawser
