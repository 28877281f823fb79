#include "traj/mission/formats/flier.h"

#include <algorithm>

namespace traj {
namespace {

Vec3 box_of(const std::optional<Uncertainty>& value) {
  const Uncertainty u = value.value_or(Uncertainty{});
  return {u.across, u.across, u.vertical};
}

}  // namespace

MissionRules Flier::rules(MissionRules rules) const {
  rules.autopilots = autopilots;
  if (!exactly) return rules;
  if (!rules.acceptance) rules.acceptance = exactly->acceptance;
  if (!rules.speed) rules.speed = exactly->speed;
  rules.braking = std::min(rules.braking, exactly->acceleration);
  if (!rules.return_height) rules.return_height = exactly->return_height;
  return rules;
}

Vec3 Flier::allowance(bool tracks) const {
  return box_of(navigation) + (tracks ? box_of(tracking) : Vec3(Vec3::Zero()));
}

}  // namespace traj
