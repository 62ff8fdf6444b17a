#pragma once
// Files that are complete or absent. Called on one rank, within Communicator::on_root.
#include <string>

namespace hawser {

/// Where a file is written until it is complete.
std::string unfinished(const std::string& path);

[[noreturn]] void throw_cannot(const std::string& verb, const std::string& path, int error_number);

/// Makes an empty file, because open(2) tells the reason of a failure and MPI-IO does not.
void create_empty(const std::string& path);

/// Puts unfinished(path), already closed, safely on disk under its own name.
void finish(const std::string& path);

void write_atomically(const std::string& path, const std::string& text);

}  // namespace hawser
