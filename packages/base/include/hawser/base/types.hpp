#pragma once
// Index types, spelled once. They match what Debian's Trilinos instantiates (int, long long).

namespace hawser {

using LocalIndex = int;         ///< position in an array of this rank
using GlobalIndex = long long;  ///< rank-independent number of a vertex, cell or row

}  // namespace hawser
