#pragma once
// A seal on a file: its first block says how long the file is and what every byte of it adds up to.
#include <string>

#include "hawser/base/communicator.hpp"

namespace hawser {

constexpr int seal_size =
    512;  ///< bytes; the least block that HDF5 leaves free at a file's beginning

/// Writes the seal of a file that was closed and whose first block was left free. Collective;
/// OutputError on all ranks.
void seal(const Communicator& communicator, const std::string& path);

enum class Sealed {
  whole,   ///< every byte is what it was when the file was sealed
  broken,  ///< the file was sealed, and has changed
  never
};
/// Collective; OutputError on all ranks when the file cannot be read.
Sealed check_seal(const Communicator& communicator, const std::string& path);

}  // namespace hawser
