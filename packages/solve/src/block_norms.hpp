#pragma once
// How far the named blocks of a residual are from balance.
#include <string>
#include <vector>

#include "hawser/base/types.hpp"
#include "hawser/solve/nonlinear_driver.hpp"

namespace hawser {

/// What a Jacobian says of the rows.
struct JacobianScales {
  /// Per owned row, the derivative of the residual with respect to its own unknown (absolute; the
  /// row's largest entry where that is zero). Empty before the first Jacobian.
  std::vector<double> of_unknown;
  /// Per block, the 2-norm of |J| |x|: multiplied by the machine's precision, what rounding alone
  /// can do to a residual whose contributions cancel before they are recorded as its magnitude.
  std::vector<double> products;
};
JacobianScales jacobian_scales(const BlockSystem& system, const TpetraVector& x);

/// One norm per block. Unknowns with a size are judged by how much they are off, which the row's
/// derivative tells, against their size; others by the residual against what cancels in it. A
/// residual below `round_off` |J| |x| counts as none.
std::vector<BlockNorm> block_norms(const BlockSystem& system, const TpetraVector& residual,
                                   const TpetraVector& magnitude, const JacobianScales& scales,
                                   double round_off);

/// Per block, the 2-norm of a change of the unknowns relative to their size: that of the block
/// where it has sizes, else their values at x, of the block or, where those are larger, of the
/// whole field (root mean squares). Of a field that has a level both are without their means.
std::vector<double> relative_changes(const BlockSystem& system, const TpetraVector& change,
                                     const TpetraVector& x);

/// Index of the largest ratio, a NaN before all.
std::size_t worst_of(const std::vector<BlockNorm>& norms);

/// "block fluid, field velocity: residual 1.2e+03 N, 3.1e-04 of its magnitude, largest at <row>".
std::string describe_block(const BlockSystem& system, const BlockNorm& norm, const Block& block,
                           const TpetraVector& residual,
                           const std::function<std::string(GlobalIndex)>& describe_row);

}  // namespace hawser
