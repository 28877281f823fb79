#pragma once

// Reference systems as PROJ knows them, and the way from one to metres about a place.
//
// Example:
//   const auto utm = geom::ProjReference::of("EPSG:25832");
//   const geom::GeodeticOrigin origin = geom::origin_near(*utm, {500000, 5300000, 0}, "scan.laz");
//   std::vector<geom::CloudPoint> points = {{geom::Vec3(500000, 5300000, 120)}};
//   geom::way_to_plane(*utm, origin, "scan.laz").project(points);
//   assert(points[0].position.head<2>().norm() < 200);  // metres from the origin

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "geom/cloud/coordinate_reference.h"
#include "geom/cloud/point_cloud.h"
#include "geom/map/frame.h"
#include "geom/shape/aabb.h"

namespace geom {

class ProjReference {
 public:
  // The reference system that a text names to PROJ: "EPSG:25832", "EPSG:2994+6360" (with heights),
  // well-known text, a PROJ string. Nothing if PROJ knows none of that name.
  static std::optional<ProjReference> of(const std::string& text);
  ~ProjReference();
  ProjReference(ProjReference&&) noexcept;
  ProjReference& operator=(ProjReference&&) noexcept;

  // Kind and units as PROJ has them. A system of places on a sphere is of Kind::no_plane.
  const CoordinateReference& told() const { return told_; }

  // Whether x and y say where on Earth a point is, so that a ProjWay leads on from here.
  bool places() const;

 private:
  friend class ProjWay;
  struct Impl;
  explicit ProjReference(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
  CoordinateReference told_;
};

// From the x and y of a reference system to those of another. Heights stay.
class ProjWay {
 public:
  // `to`: as PROJ reads it. Throws InputError(source, …) where PROJ knows no way, or only one
  // that takes two datums for one: that would be off by up to hundreds of metres.
  ProjWay(const ProjReference& from, const std::string& to, const std::string& source);
  ~ProjWay();
  ProjWay(ProjWay&&) noexcept;
  ProjWay& operator=(ProjWay&&) noexcept;

  // East before north, longitude before latitude. Throws InputError where a point has no
  // place there. One thread at a time.
  void project(std::span<CloudPoint> points) const;

  // A rectangle around what comes to lie in this one (z is not looked at), with a hundredth of its
  // sides more; nothing where PROJ cannot say.
  std::optional<Aabb> origin_of(const Aabb& region) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The plane of maps that count metres east and north of a place: transverse Mercator about it, as a
// PROJ string; and the way to it. The origin's height is not looked at.
std::string plane_about(const GeodeticOrigin& origin);
ProjWay way_to_plane(const ProjReference& from, const GeodeticOrigin& origin,
                     const std::string& source);

// Latitude and longitude of a point of the system, to 1e-3 degrees: an origin near it. Throws
// InputError(source, …) where it has none.
GeodeticOrigin origin_near(const ProjReference& reference, const Vec3& point,
                           const std::string& source);

}  // namespace geom
