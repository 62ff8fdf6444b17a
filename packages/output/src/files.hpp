#pragma once
// Files that are complete or absent. Called on one rank, within Communicator::on_root.
#include <string>

#include "hawser/base/types.hpp"

namespace hawser {

/// Where a file is written until it is complete.
std::string unfinished(const std::string& path);

[[noreturn]] void throw_cannot(const std::string& verb, const std::string& path, int error_number);

/// Bytes that an HDF5 file of so many numbers of 8 bytes takes, with plenty for its own tables.
std::size_t room_for(GlobalIndex numbers);

/// Makes the file, and makes sure that there is room for so many bytes: the system tells here why
/// it refuses, whereas MPI-IO gives no reason, and on a full disk hangs when only some ranks fail.
void try_room(const std::string& path, std::size_t bytes);

/// Returns when the file's content is on disk.
void sync(const std::string& path);

/// Puts unfinished(path), already closed, safely on disk under its own name.
void finish(const std::string& path);

void write_atomically(const std::string& path, const std::string& text);

}  // namespace hawser
