#include "hawser/solve/factor.hpp"

#include "mumps_factor.hpp"
#include "schwarz_factor.hpp"

namespace hawser {

std::unique_ptr<Factor> make_factor(const Communicator& communicator,
                                    const LinearOptions& options) {
  switch (options.method) {
    case LinearOptions::Method::gmres:
      return std::make_unique<SchwarzFactor>(communicator, options);
    case LinearOptions::Method::mumps:
      return std::make_unique<MumpsFactor>(communicator, options.repeatable);
  }
  throw std::logic_error("make_factor: unknown method");
}

}  // namespace hawser
