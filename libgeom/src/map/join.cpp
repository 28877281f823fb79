#include "geom/map/join.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "geom/base/error.h"
#include "geom/base/rounding.h"
#include "geom/map/geographic_frame.h"

namespace geom {
namespace {

constexpr double kRadius = 6.3e6;  // metres, less than any of the Earth's: bounds the bulge

class Mover {
 public:
  Mover(const Frame& to, const Frame& from)
      : axes_(to.axes),
        to_(*to.origin),
        from_(*from.origin),
        up_(from.origin->height - to.origin->height) {}

  Aabb moved(const Aabb& box) const {
    std::optional<Aabb> out;
    for (const double x : {box.min.x(), box.max.x()}) {
      for (const double y : {box.min.y(), box.max.y()}) {
        const Vec3 p = moved(Vec3(x, y, 0));
        out = out ? merged(*out, {p, p}) : Aabb{p, p};
      }
    }
    const double side = (box.max - box.min).head<2>().norm();
    out = grow(*out, Vec3(1, 1, 0) * (side * side / (8 * kRadius) + 1e-6));
    out->min.z() = next_down(box.min.z() + up_);
    out->max.z() = next_up(box.max.z() + up_);
    return *out;
  }

 private:
  Vec3 moved(const Vec3& p) const {
    const Vec3 enu = to_enu(axes_, p);
    double latitude;
    double longitude;
    Vec3 out = enu;
    from_.to_geodetic(enu.x(), enu.y(), latitude, longitude);
    to_.from_geodetic(latitude, longitude, out.x(), out.y());
    return to_enu(axes_, out);
  }

  Axes axes_;
  GeographicFrame to_;
  GeographicFrame from_;
  double up_;
};

// A height of 0 means that nobody knows it, so it is no difference of heights.
void require_like_heights(const Frame& frame, const Frame& from, std::string_view source) {
  const double first = frame.origin->height;
  const double other = from.origin->height;
  if ((first == 0) == (other == 0)) return;
  const auto shown = [](double height) {
    return height == 0 ? std::string("none (0 m)") : fmt::format("{:g} m", height);
  };
  throw InputError(source, {.says = fmt::format("expected a height of the origin above the "
                                                "ellipsoid in both maps or in none, found {} in "
                                                "the first map, {} in this one",
                                                shown(first), shown(other)),
                            .advice = "make the map without it anew (--origin "
                                      "LAT,LON,HEIGHT)"});
}

}  // namespace

BoxTable table_of(const BoxMap& map, const Aabb* region) {
  BoxTable table;
  table.labels = map.labels();
  const auto boxes = map.boxes();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (region && !overlap(boxes[i], *region)) continue;
    table.add(boxes[i], map.ids()[i], map.label()[i]);
    if (!map.timed().empty()) table.set_time(table.boxes.size() - 1, map.time(i));
  }
  return table;
}

BoxTable in_frame(const Frame& frame, const BoxMap& other, std::string_view source) {
  BoxTable table = table_of(other);
  const Frame& from = other.spec().frame;
  if (from == frame) return table;
  if (from.axes != frame.axes) {
    throw InputError(
        source, {.expected = "axes " + std::string(name(frame.axes)) + ", as the first map has",
                 .found = std::string(name(from.axes))});
  }
  if (!counts_from_origin(frame) || !counts_from_origin(from)) {
    throw InputError(source,
                     {.says = "expected the coordinate reference system of the first map (\"" +
                              frame.crs + "\"), or coordinates of both maps that count from " +
                              "an origin on Earth; found \"" + from.crs + "\"" +
                              (from.origin ? "" : " and no origin")});
  }
  require_like_heights(frame, from, source);
  const Mover mover(frame, from);
  for (Aabb& box : table.boxes) box = mover.moved(box);
  return table;
}

}  // namespace geom
