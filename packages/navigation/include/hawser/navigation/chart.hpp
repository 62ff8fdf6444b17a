#pragma once
// Where on the Earth a frame in metres lies, by PROJ.
#include <memory>
#include <string>

#include "hawser/navigation/navigation_line.hpp"

namespace hawser {

/// A projected coordinate reference system in metres.
class Chart {
 public:
  /// `crs` as PROJ has it: "EPSG:32631". DeckError, with what is wrong.
  explicit Chart(const std::string& crs);
  ~Chart();
  Chart(const Chart&) = delete;
  Chart& operator=(const Chart&) = delete;

  struct Geographic {
    double latitude = 0, longitude = 0;  ///< degrees, of the chart's own datum
  };
  /// DeckError where the projection has no such place.
  Geographic geographic(const Place& place) const;

  std::string name() const;       ///< "WGS 84 / UTM zone 31N"
  std::string datum() const;      ///< "WGS 84": the geographic system it projects
  std::string ellipsoid() const;  ///< "WGS 84 6378137.000 298.2572236"
  const std::string& crs() const { return crs_; }

 private:
  struct Handles;
  std::string crs_;
  std::unique_ptr<Handles> handles_;
};

}  // namespace hawser
