#include "traj/home/landing_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geom/base/error.h"
#include "home/clear_region.h"
#include "traj/curve/vertical_ends.h"

namespace traj {
namespace {

using geom::Vec2;

constexpr int kPlaces = 33;  // along each side of a polygon's bounding box

// A site's place, or why there is none.
struct Landing {
  LandingSite site;
  std::string fault;
};

Vec3 margin_beside(const geom::CollisionScene& scene) { return Vec3::Constant(scene.margin()); }

// Whether a box of the map, as it stands, holds the place.
bool in_building(const geom::CollisionScene& scene, const Vec3& p) {
  for (const std::size_t i : scene.boxes_meeting({p, p})) {
    const geom::Aabb box = scene.map().box(i);
    if (geom::contains(box, p) && box.max.z() > p.z() + kLevelGround) return true;
  }
  return false;
}

// Where `above` is: as high as kApproachHeight and the bounds allow.
double approach(const geom::CollisionScene& scene, double ground) {
  return std::min(ground + scene.half().z() + kApproachHeight, scene.free_bounds()->max.z());
}

bool outside_in_plan(const geom::CollisionScene& scene, const Vec2& p) {
  const auto& free = scene.free_bounds();
  return !free || (p.array() < free->min.head<2>().array()).any() ||
         (p.array() > free->max.head<2>().array()).any();
}

Landing landing_at(const geom::CollisionScene& scene, const Vec2& p,
                   const std::optional<double>& said) {
  if (outside_in_plan(scene, p)) return {{}, "the site is outside of the map's bounds"};
  const geom::Aabb& bounds = scene.map().spec().bounds;
  if (said && (*said < bounds.min.z() - kLevelGround || *said > bounds.max.z())) {
    return {{}, fmt::format("its ground, {} m, is outside of the map's bounds", *said)};
  }
  const double from = said ? *said + kLevelGround : bounds.max.z();
  const LandingGround ground =
      landing_ground(scene, {p.x(), p.y(), from}, margin_beside(scene), kLevelGround);
  Landing out;
  out.site.ground = {p.x(), p.y(), ground.height};
  out.site.above = {p.x(), p.y(), approach(scene, ground.height)};
  if (said && in_building(scene, {p.x(), p.y(), *said})) {
    out.fault = "the site is inside a building";
  } else if (!ground.whole) {
    out.fault = fmt::format(
        "the site is on a roof edge: the ground at {:.2f} m does not reach under the whole vehicle "
        "with its margin",
        ground.height);
  } else if (said && *said > ground.height + kLevelGround) {
    out.fault = fmt::format("its ground is said to be at {} m, and the map has it at {:.2f} m",
                            *said, ground.height);
  } else {
    out.fault = landing_fault(scene, out.site.above, out.site.ground);
  }
  return out;
}

// How far inside the polygon's edges a point is; below 0 outside of it.
double inside(const geom::Polygon& polygon, const Vec2& p) {
  if (!geom::contains(polygon, p)) return -1;
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const std::vector<Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const geom::Polygon edge{{ring[i], ring[(i + 1) % ring.size()]}, {}};
      least = std::min(least, geom::distance(edge, p));
    }
  };
  look_at(polygon.outer);
  std::for_each(polygon.holes.begin(), polygon.holes.end(), look_at);
  return least;
}

struct GridPlace {
  Vec2 at;
  double inside = 0;
};

// The places of the grid at which the vehicle is inside, the furthest from the edges first.
std::vector<GridPlace> places(const geom::Polygon& polygon, double room) {
  Vec2 low = polygon.outer.front();
  Vec2 high = low;
  for (const Vec2& p : polygon.outer) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<GridPlace> out;
  for (int i = 0; i < kPlaces; ++i) {
    for (int j = 0; j < kPlaces; ++j) {
      const Vec2 share((i + 0.5) / kPlaces, (j + 0.5) / kPlaces);
      const Vec2 p = low + (high - low).cwiseProduct(share);
      const double in = inside(polygon, p);
      if (in >= room) out.push_back({p, in});
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const GridPlace& a, const GridPlace& b) { return a.inside > b.inside; });
  return out;
}

Landing best_landing(const geom::CollisionScene& scene, const DrawnSite& site) {
  if (site.outline.outer.size() == 1) {
    return landing_at(scene, site.outline.outer.front(), site.ground);
  }
  const double room = scene.half().head<2>().norm();
  std::optional<Landing> first;
  for (const GridPlace& place : places(site.outline, room)) {
    Landing one = landing_at(scene, place.at, site.ground);
    if (one.fault.empty()) return one;
    if (!first) first = std::move(one);
  }
  if (first) return *first;
  return {{},
          fmt::format("the vehicle with its margin does not fit into the polygon: it needs a "
                      "circle of {:.2f} m around its place",
                      room)};
}

}  // namespace

std::string landing_fault(const geom::CollisionScene& scene, const Vec3& above,
                          const Vec3& ground) {
  if (above.head<2>() != ground.head<2>() || !(above.z() > ground.z())) {
    return "the way down is not straight";
  }
  const Prism down{{ground.head<2>()}, ground.z(), above.z()};
  if (!scene.free(above) || !clear_region(scene, down, ground.z())) {
    return "the column above the site is not clear";
  }
  const LandingGround below = landing_ground(scene, above, margin_beside(scene), kLevelGround);
  if (!below.whole) return "the ground is not whole and level";
  if (below.height != ground.z()) {
    return fmt::format("the ground is at {} m, not at {} m", below.height, ground.z());
  }
  return {};
}

LandingSite landing_site(const geom::CollisionScene& scene, const DrawnSite& site,
                         std::string_view source) {
  Landing found = best_landing(scene, site);
  if (!found.fault.empty()) {
    throw geom::InputError(
        source, {.item = fmt::format("feature {} ({})", site.feature, geom::in_quotes(site.id)),
                 .says = std::move(found.fault)});
  }
  found.site.id = site.id;
  return found.site;
}

}  // namespace traj
