#pragma once
// How far the named blocks of a residual are from balance.
#include <string>
#include <vector>

#include "hawser/base/types.hpp"
#include "hawser/solve/nonlinear_driver.hpp"

namespace hawser {

/// One norm per block. `round_off` holds, per block, the residual that counts as none.
std::vector<BlockNorm> block_norms(const BlockSystem& system, const TpetraVector& residual,
                                   const TpetraVector& magnitude,
                                   const std::vector<double>& round_off);

/// Per block, the 2-norm of |J| |x|: multiplied by the machine's precision, what rounding alone can
/// do to a residual whose contributions cancel before they are recorded as its magnitude.
std::vector<double> product_magnitudes(const BlockSystem& system, const TpetraVector& x);

/// Index of the largest ratio, a NaN before all.
std::size_t worst_of(const std::vector<BlockNorm>& norms);

/// "block fluid, field velocity: residual 1.2e+03 N, 3.1e-04 of its magnitude, largest at <row>".
std::string describe_block(const BlockSystem& system, const BlockNorm& norm, const Block& block,
                           const TpetraVector& residual,
                           const std::function<std::string(GlobalIndex)>& describe_row);

}  // namespace hawser
