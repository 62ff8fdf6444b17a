#pragma once
#include <vector>

#include "hawser/base/communicator.hpp"

namespace hawser {

/// Sum of all ranks' terms, to the last bit the same however they are ordered and spread over the
/// ranks: the terms are added as whole multiples of the largest one's 2^-90. Not a number where a
/// term is not finite. Collective.
double exact_sum(const Communicator& communicator, const std::vector<double>& terms);

}  // namespace hawser
