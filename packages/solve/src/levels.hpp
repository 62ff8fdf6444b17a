#pragma once
// The constant of a field that only differences count of, such as a pressure's.
#include "hawser/algebra/block_system.hpp"

namespace hawser {

/// Adds to `rise`, per field that has a level, the constant that makes the linearised residual
/// f + J rise least, rows scaled by their largest entry. True when that takes a good part of it
/// away. With an outflow at 10 MPa and a guess of zero that is nearly all, and what is left is as
/// if the outflow were at zero: whatever is relative to a first residual must not know the level.
bool level_fields(const BlockSystem& system, const TpetraVector& f, TpetraVector& rise);

}  // namespace hawser
