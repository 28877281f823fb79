#include "geographic_frame.h"

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

bool counts_from_origin(const Frame& frame) {
  return frame.origin && (frame.crs.empty() || frame.crs.starts_with("+proj=tmerc"));
}

}  // namespace geom
