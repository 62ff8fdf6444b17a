#include "hawser/base/domain.hpp"

namespace hawser {

Domain Domain::facets(Domain boundary) {
  boundary.kind = Kind::facets;
  return boundary;
}

Domain Domain::patches(Domain lines) {
  lines.kind = Kind::patches;
  return lines;
}

Domain Domain::ends(Domain lines, std::string point_region) {
  lines.kind = Kind::ends;
  lines.point = std::move(point_region);
  return lines;
}

std::string Domain::text() const {
  std::string names;
  for (const auto& region : regions)
    names += (names.empty() ? "" : " ") + region;
  switch (kind) {
    case Kind::facets: return "facets of " + names;
    case Kind::patches: return "patches of " + names;
    case Kind::ends: return names + " at " + point;
    default: return names;
  }
}

}  // namespace hawser
