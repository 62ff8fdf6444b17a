#include "hawser/navigation/chart.hpp"

#include <fmt/format.h>
#include <proj.h>

#include <cmath>

#include "hawser/base/error.hpp"

namespace hawser {

struct Chart::Handles {
  struct Destroy {
    void operator()(PJ* handle) const { proj_destroy(handle); }
    void operator()(PJ_CONTEXT* handle) const { proj_context_destroy(handle); }
  };
  using Handle = std::unique_ptr<PJ, Destroy>;
  std::unique_ptr<PJ_CONTEXT, Destroy> context{proj_context_create()};
  Handle chart, geodetic, way;
};

Chart::Chart(const std::string& crs) : crs_(crs), handles_(std::make_unique<Handles>()) {
  PJ_CONTEXT* const context = handles_->context.get();
  proj_log_level(context, PJ_LOG_NONE);
  handles_->chart.reset(proj_create(context, crs.c_str()));
  const auto fault = [&](const std::string& why) {
    return DeckError(
        quoted(crs) + " " + why +
        "; needed is a projected system in metres, such as EPSG:32631, UTM zone 31 north on "
        "WGS 84");
  };
  PJ* const chart = handles_->chart.get();
  if (chart == nullptr) throw fault("is no coordinate reference system that PROJ knows");
  if (proj_get_type(chart) != PJ_TYPE_PROJECTED_CRS) throw fault("is no projected system");
  const Handles::Handle axes(proj_crs_get_coordinate_system(context, chart));
  double factor = 0;
  proj_cs_get_axis_info(context, axes.get(), 0, nullptr, nullptr, nullptr, &factor, nullptr,
                        nullptr, nullptr);
  if (factor != 1) throw fault("is not in metres");
  handles_->geodetic.reset(proj_crs_get_geodetic_crs(context, chart));
  const Handles::Handle way(
      proj_create_crs_to_crs_from_pj(context, chart, handles_->geodetic.get(), nullptr, nullptr));
  // East before north and longitude before latitude, whatever the system's own order.
  handles_->way.reset(proj_normalize_for_visualization(context, way.get()));
  if (!handles_->way) throw fault("cannot be converted to latitude and longitude");
}

Chart::~Chart() = default;

Chart::Geographic Chart::geographic(const Place& place) const {
  const PJ_COORD at = proj_trans(handles_->way.get(), PJ_FWD, proj_coord(place[0], place[1], 0, 0));
  if (!std::isfinite(at.xy.x) || !std::isfinite(at.xy.y))
    throw DeckError(
        fmt::format("easting {:.1f} m, northing {:.1f} m is no place on the chart {}; is the "
                    "origin right?",
                    place[0], place[1], crs_));
  return {at.xy.y, at.xy.x};
}

std::string Chart::name() const { return proj_get_name(handles_->chart.get()); }
std::string Chart::datum() const { return proj_get_name(handles_->geodetic.get()); }

std::string Chart::ellipsoid() const {
  PJ_CONTEXT* const context = handles_->context.get();
  const Handles::Handle ellipsoid(proj_get_ellipsoid(context, handles_->geodetic.get()));
  double axis = 0, inverse_flattening = 0;
  proj_ellipsoid_get_parameters(context, ellipsoid.get(), &axis, nullptr, nullptr,
                                &inverse_flattening);
  return fmt::format("{} {:.3f} {:.7f}", proj_get_name(ellipsoid.get()), axis, inverse_flattening);
}

}  // namespace hawser
