#pragma once
// The state of another run, whose deck may be another one, as the start of this one.
#include "src/system.hpp"

namespace hawser {

/// From the checkpoint that <start from="..."> names, into the problem's state, which holds the
/// initial values; the system's notes say which fields there are not. DeckError when it cannot be
/// read or belongs to another mesh. Collective.
void take_over(const Case& run_case, System& system);

}  // namespace hawser
