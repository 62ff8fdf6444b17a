#pragma once
#include "hawser/navigation/chart.hpp"

namespace hawser {

struct P190Options {
  std::string line{};  ///< name of the line, 12 characters at most
  int streamer = 1;    ///< 1 to 9
  double epoch = 0;    ///< s since 1970, of time 0
  double depth = 0;    ///< m, of the water; 0: not known
};

/// The line as UKOOA P1/90: header records, and per shot S and V records at the head (there is no
/// other point that a cable alone knows) and the receivers, three per record. Places are those of
/// the chart, times UTC. OutputError where a number does not fit its columns.
std::string write_p190(const NavigationLine& line, const Chart& chart, const P190Options& options);

}  // namespace hawser
