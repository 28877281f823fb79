#pragma once

// Metres east and north of an origin, and latitudes and longitudes.
//
// Example:
//   const geom::GeographicFrame earth({47.4, 8.5, 400});
//   const geom::GeodeticPlace place = earth.place({100, 200, 30});  // east, north, up
//   assert((earth.enu(place) - geom::Vec3(100, 200, 30)).norm() < 1e-6);

#include <memory>

#include "geom/map/frame.h"

namespace geom {

using GeodeticPlace = GeodeticOrigin;  // any place on Earth, in the same three numbers

// By a transverse Mercator projection of scale 1 about the origin, on WGS 84: what the coordinates
// of a map whose frame counts from its origin mean. Good to nanometres within 1000 km of it.
class GeographicFrame {
 public:
  explicit GeographicFrame(const GeodeticOrigin& origin);
  ~GeographicFrame();

  void to_geodetic(double east, double north, double& latitude, double& longitude) const;
  void from_geodetic(double latitude, double longitude, double& east, double& north) const;

  // A point in east-north-up axes, and back; heights add up.
  GeodeticPlace place(const Vec3& enu) const;
  Vec3 enu(const GeodeticPlace& place) const;

 private:
  struct Projection;
  std::unique_ptr<Projection> projection_;
  GeodeticOrigin origin_;
  double north_ = 0;  // of the origin from the equator
};

// The same projection as a PROJ string, which is the `crs` of such a frame. The origin's height is
// not looked at.
std::string plane_about(const GeodeticOrigin& origin);

// Whether a frame's coordinates are metres from its origin: it has one, and no CRS of another kind.
bool counts_from_origin(const Frame& frame);

}  // namespace geom
