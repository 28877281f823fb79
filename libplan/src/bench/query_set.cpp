#include "plan/bench/query_set.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace plan::bench {
namespace {

using geom::Vec3;

constexpr double kStreet = 30;           // metres above the floor
constexpr std::size_t kDraws = 1000000;  // in a row, then it gives up

}  // namespace

QuerySet::QuerySet(const geom::CollisionScene& scene, const RandomSpec& spec)
    : scene_(&scene), spec_(spec), generator_(spec.seed) {
  if (!scene.free_bounds()) {
    throw geom::InputError("map",
                           {.says = "the vehicle does not fit between the bounds of the map"});
  }
  region_ = *scene.free_bounds();
  if (spec.ends == Ends::uniform) return;
  const double roof = scene.map().spec().bounds.min.z() + kStreet;
  if (region_.min.z() > roof) {
    throw geom::InputError("map",
                           {.says = fmt::format("the vehicle cannot be within {} m of the floor, "
                                                "as --set street and street-blocked ask",
                                                kStreet)});
  }
  region_.max.z() = std::min(region_.max.z(), roof);
}

std::optional<std::size_t> QuerySet::size() const {
  if (scene_) return std::nullopt;
  return queries_.size();
}

// Not std::uniform_real_distribution, whose numbers differ from library to library.
double QuerySet::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
}

Vec3 QuerySet::point_in_region() {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = uniform(region_.min[k], region_.max[k]);
  return p;
}

Vec3 QuerySet::goal_from(const Vec3& start) {
  if (!spec_.length) return point_in_region();
  Vec3 direction;
  double norm = 0;
  do {  // uniform in the ball, so its direction on the sphere
    for (int k = 0; k < 3; ++k) direction[k] = uniform(-1, 1);
    norm = direction.norm();
  } while (norm > 1 || norm < 1e-3);
  return start + direction * (uniform(spec_.length->first, spec_.length->second) / norm);
}

bool QuerySet::draw(geom::PlanQuery& query) {
  query.from = point_in_region();
  query.to = goal_from(query.from);
  if (!geom::contains(region_, query.to)) {
    ++rejected_.outside;
    return false;
  }
  if (!scene_->free(query.from) || !scene_->free(query.to)) {
    ++rejected_.blocked;
    return false;
  }
  if (spec_.ends == Ends::street_blocked && scene_->free(query.from, query.to)) {
    ++rejected_.line_free;
    return false;
  }
  return true;
}

const geom::PlanQuery& QuerySet::at(std::size_t i) {
  while (scene_ && queries_.size() <= i) {
    const Rejected before = rejected_;
    geom::PlanQuery query;
    query.id = fmt::format("q{}", queries_.size() + 1);
    std::size_t draws = 0;
    while (!draw(query)) {
      if (++draws < kDraws) continue;
      throw geom::InputError(
          "map", {.says = fmt::format(
                      "no random query was found in {} tries: {} times the goal was outside the "
                      "bounds or above street level, {} times an end was inside an obstacle, and "
                      "{} times the straight line was free; try another --set or --length",
                      kDraws, rejected_.outside - before.outside,
                      rejected_.blocked - before.blocked, rejected_.line_free - before.line_free)});
    }
    queries_.push_back(std::move(query));
  }
  return queries_.at(i);
}

}  // namespace plan::bench
