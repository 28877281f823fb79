#include "refused_end.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "geom/map/wider_bounds.h"
#include "plan/planner/snap_end.h"
#include "shown_point.h"

namespace plan {
namespace {

constexpr double kLookAround = 50;  // metres: how far a message looks for a free place

// A place that is free with a millimetre to spare is so as it is shown.
std::string to_millimetres(const Vec3& p) {
  return shown((p * 1e3).array().round().matrix() / 1e3);
}

// Where the reference point may be, rounded inward to millimetres.
std::string in_words(const geom::CollisionScene& scene) {
  const std::string vehicle =
      fmt::format("the vehicle {} with margin {} m", scene.vehicle().name, scene.margin());
  if (!scene.free_bounds()) return vehicle + " does not fit into them";
  const geom::Aabb& inner = *scene.free_bounds();
  const Vec3 min = (inner.min * 1e3).array().ceil() / 1e3;
  const Vec3 max = (inner.max * 1e3).array().floor() / 1e3;
  return fmt::format("{} may be from {} to {}", vehicle, shown(min), shown(max));
}

geom::WiderBounds wider_bounds(const geom::CollisionScene& scene, const Vec3& p) {
  geom::WiderBounds wider(scene.map().spec().bounds);
  if (p.allFinite()) wider.add({p - scene.half(), p + scene.half()});
  return wider;
}

std::string how_far_out(const geom::CollisionScene& scene, const Vec3& p) {
  const std::string out = wider_bounds(scene, p).in_words();
  return out.empty() ? out : out + "; ";
}

std::string advice(const geom::CollisionScene& scene, const Vec3& p) {
  const std::string out = wider_bounds(scene, p).advice();
  return out.empty() ? out : "; " + out;
}

}  // namespace

PlanResult refused_end(const geom::CollisionScene& scene, const Vec3& p, bool start) {
  PlanResult result;
  std::string what;
  if (!scene.inside_bounds(p)) {
    result.status = start ? PathStatus::start_outside : PathStatus::goal_outside;
    what = "outside the bounds: " + how_far_out(scene, p) + in_words(scene);
  } else {
    result.status = start ? PathStatus::start_blocked : PathStatus::goal_blocked;
    const auto boxes = scene.boxes_meeting({p, p});
    what = fmt::format("inside obstacle {}", scene.map().ids()[boxes.front()]);
  }
  result.message = fmt::format("{} {} is {}", start ? "start" : "goal", shown(p), what);
  if (!scene.free_bounds()) {
    result.message += advice(scene, p);
    return result;
  }
  const geom::Aabb& inner = *scene.free_bounds();
  const double away = (p.cwiseMax(inner.min).cwiseMin(inner.max) - p).norm();
  const double looked = std::ceil(away) + kLookAround;
  const auto free = nearest_free(scene, p, looked);
  result.message += free ? fmt::format("; the nearest free point is {}, {:.3f} m away",
                                       to_millimetres(*free), (*free - p).norm())
                         : fmt::format("; no free point within {:.0f} m", looked);
  result.message += advice(scene, p);
  return result;
}

}  // namespace plan
