#include "traj/home/return_places.h"

#include <algorithm>
#include <limits>

#include "traj/home/prism.h"

namespace traj {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<std::size_t> likely_places(const ReturnModel& model, const FlightStage& stage,
                                       const std::vector<ReturnPlace>& places) {
  const std::vector<Vec2> plan = prism_around(stage.where).plan;
  const double off = 2 * model.around.head<2>().norm();
  const std::size_t home = places.size() - 1;
  const auto ground = [&](std::size_t i) -> Vec2 { return places[i].ground.head<2>(); };
  const auto counts = [&](std::size_t i) {  // whether it is surely one of those it looks at
    if (i == home) return model.home_is_a_place;
    if (model.fence_excludes) return false;
    return model.rally_apart == 0 || (ground(i) - ground(home)).norm() > model.rally_apart + off;
  };
  double sure = kNone;   // m: it goes no further than that
  double rally = kNone;  // m: a rally point is no further than that
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!counts(i)) continue;
    const double most = furthest(plan, ground(i));
    sure = std::min(sure, most);
    if (i != home) rally = std::min(rally, most);
  }
  const double limit = model.rally_limit > 0 ? model.rally_limit : kNone;
  const bool last_resort = !model.home_is_a_place || limit < kNone;
  const bool none_near = last_resort && (rally == kNone || rally + off > limit);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool near = distance(plan, ground(i)) <= sure + model.nearer + off;
    const bool is_one = i != home || model.home_is_a_place;
    if (model.any_place || (is_one && near) || (i == home && none_near)) out.push_back(i);
  }
  return out;
}

}  // namespace traj
