#pragma once
// Lines and points written as a mesh file.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "hawser/base/communicator.hpp"

namespace hawser {

struct LinesToWrite {
  struct Line {
    std::string name;
    std::vector<std::size_t> nodes;  ///< in order, of its segments' ends
  };
  std::vector<std::array<double, 3>> nodes;  ///< m
  std::vector<Line> lines;
  std::vector<std::pair<std::string, std::size_t>> points;  ///< name and node
};

/// Collective; MeshError on all ranks.
void write_lines(const Communicator& communicator, const LinesToWrite& lines,
                 const std::string& path);

}  // namespace hawser
