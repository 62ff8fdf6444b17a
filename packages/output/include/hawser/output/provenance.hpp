#pragma once
#include "hawser/base/communicator.hpp"
#include "hawser/output/summary.hpp"

namespace hawser {

/// Version, git revision, libraries, ranks, host and date of this run.
void add_provenance(const Communicator& communicator, Summary& summary);

}  // namespace hawser
