#include "geom/map/geographic_frame.h"

#include <fmt/format.h>

#include <GeographicLib/TransverseMercator.hpp>

namespace geom {

struct GeographicFrame::Projection {
  GeographicLib::TransverseMercator mercator{6378137, 1 / 298.257223563, 1};
};

GeographicFrame::GeographicFrame(const GeodeticOrigin& origin)
    : projection_(std::make_unique<Projection>()), origin_(origin) {
  double east;
  projection_->mercator.Forward(origin.longitude, origin.latitude, origin.longitude, east, north_);
}
GeographicFrame::~GeographicFrame() = default;

void GeographicFrame::to_geodetic(double east, double north, double& latitude,
                                  double& longitude) const {
  projection_->mercator.Reverse(origin_.longitude, east, north + north_, latitude, longitude);
}

void GeographicFrame::from_geodetic(double latitude, double longitude, double& east,
                                    double& north) const {
  projection_->mercator.Forward(origin_.longitude, latitude, longitude, east, north);
  north -= north_;
}

GeodeticPlace GeographicFrame::place(const Vec3& enu) const {
  GeodeticPlace place{0, 0, origin_.height + enu.z()};
  to_geodetic(enu.x(), enu.y(), place.latitude, place.longitude);
  return place;
}

Vec3 GeographicFrame::enu(const GeodeticPlace& place) const {
  Vec3 enu(0, 0, place.height - origin_.height);
  from_geodetic(place.latitude, place.longitude, enu.x(), enu.y());
  return enu;
}

std::string plane_about(const GeodeticOrigin& origin) {
  return fmt::format(
      "+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
      origin.latitude, origin.longitude);
}

bool counts_from_origin(const Frame& frame) {
  return frame.origin && (frame.crs.empty() || frame.crs.starts_with("+proj=tmerc"));
}

}  // namespace geom
