#pragma once
// Layout of a checkpoint, an HDF5 file behind a seal (seal.hpp) of its every byte.
//
// Attributes of "/": format_version, step, time (s); group "numbers" with one attribute each;
// groups "texts", "files" (numbered; attributes name and path) and "arrays" with one dataset each.
// Every dataset has a checksum of what was in memory, "/" has one of all that is no dataset, and of
// the names of the datasets.
#include <cstdint>
#include <vector>

#include "hawser/output/checkpoint.hpp"

namespace hawser::layout {

constexpr GlobalIndex format_version = 3;
constexpr const char* checksum = "checksum";  // the attribute

inline std::string array_path(const std::string& name) { return "arrays/" + name; }
inline std::string text_path(const std::string& name) { return "texts/" + name; }
inline std::string file_path(std::size_t number) { return "files/" + std::to_string(number); }

/// Of everything but the contents of datasets. Of `files` names and paths count.
GlobalIndex header_checksum(const CheckpointHeader& header, const std::vector<std::string>& arrays,
                            const std::vector<KeptFile>& files);
GlobalIndex text_checksum(const std::string& text);
/// Of values [id][component] that are spread over the ranks in any way. Collective.
GlobalIndex array_checksum(const Communicator& communicator, int components,
                           const std::vector<GlobalIndex>& ids, const std::vector<double>& values);

}  // namespace hawser::layout
