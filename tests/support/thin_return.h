#pragma once

// The return of a vehicle as the autopilots' documents tell it: it brakes along its velocity, rises
// straight up, goes straight across, and sinks straight down to the ground. One way of all that the
// product must hold, worked out here once more, without the product's regions.

#include <algorithm>
#include <vector>

#include "support/random_city.h"
#include "traj/home/return_proof.h"

namespace support {

using geom::Vec3;

// What a vehicle may choose, each 0 to 1.
struct Choice {
  double braking = 1;     // share of its way to rest
  bool low = false;       // its distance is measured at once; it stays low in a circle about home
  double under = 0;       // share of what it may be below its height
  double acceptance = 0;  // share of the radius in which it may begin to sink
  double overshot = 0;    // share of what it may go beyond its place
};

inline Choice any_choice(Random& random) {
  const auto share = [&] {
    const int kind = random.below(3);
    return kind == 0 ? 0.0 : kind == 1 ? 1.0 : random.uniform(0, 1);
  };
  return {share(), random.below(2) == 1, share(), share(), share()};
}

inline Vec3 level(const Vec3& v) { return {v.x(), v.y(), 0}; }
inline double across(const Vec3& a, const Vec3& b) { return level(b - a).norm(); }

// The point where it rests: it slows down evenly, or aims at a point that is a little further.
inline Vec3 rest(const traj::ReturnModel& model, const Vec3& at, const Vec3& velocity,
                 double share) {
  const Vec3 v = level(velocity);
  if (v.isZero(0)) return at;
  const double seconds = model.reaction + v.norm() / (2 * model.deceleration);
  return at + share * (seconds * v + model.stop_length * v.normalized());
}

// Places where it may land: home, or rally points, by their distances in plan.
inline std::vector<Vec3> nearest(const traj::ReturnModel& model, const traj::ReturnTask& task,
                                 const Vec3& from) {
  std::vector<Vec3> places = task.rally;
  const bool home = model.home_is_a_place || places.empty() || model.any_place;
  if (home) places.push_back(task.home);
  if (model.any_place) return places;
  double least = across(from, places.front());
  for (const Vec3& place : places) least = std::min(least, across(from, place));
  if (model.rally_limit > 0 && least > model.rally_limit) return {task.home};
  std::vector<Vec3> out;
  for (const Vec3& place : places) {
    if (across(from, place) <= least + model.nearer) out.push_back(place);
  }
  return out;
}

// Metres above its place to which a return climbs that is `away` metres from it: ArduPilot's
// ModeRTL::compute_return_target, or PX4's calculate_return_alt_from_cone_half_angle since 1.12.
inline double return_height(const traj::ReturnModel& model, double full, double away) {
  const bool any_distance = !model.cone.px4_1_11 && !model.cone.px4_1_12;
  if (any_distance && model.slope >= 0.5) return std::min(full, model.slope * away);
  if (!model.cone.px4_1_12) return full;
  if (away <= model.acceptance) return std::min(full, 2 * away);
  double height = full;
  if (model.slope > 0 && away <= model.cone.near) height = std::min(full, model.slope * away);
  return std::min(full, std::max(height, 2 * model.acceptance));
}

// The height, z, at which it goes across.
inline double cruise(const traj::ReturnModel& model, const traj::ReturnTask& task, const Vec3& at,
                     const Vec3& resting, const Vec3& place, const Choice& choice) {
  const double ground = task.home.z();
  const double above = place.z() - ground;
  const double full = model.rally_adds ? model.height : std::max(model.height, above);
  const double base = model.rally_adds ? place.z() : ground;
  const Vec3& told = choice.low ? at : resting;  // where it measures its distance
  const double away = across(told, place);
  const double asked = base + return_height(model, full, away);
  double z = std::max(asked, resting.z() + model.least_climb);
  if (choice.low && model.low_within > 0 && across(resting, place) < model.low_within) {
    z = resting.z();
  }
  if (model.ceiling) z = std::max(resting.z(), std::min(z, ground + *model.ceiling));
  return z;
}

// From the instant when it leaves its flight until it stands; of these points, straight ways.
inline std::vector<Vec3> way_home(const traj::ReturnModel& model, const traj::ReturnTask& task,
                                  const Vec3& at, const Vec3& velocity, const Vec3& place,
                                  const Choice& choice) {
  const Vec3 resting = rest(model, at, velocity, choice.braking);
  const double ground = task.home.z();
  double z = cruise(model, task, at, resting, place, choice);
  const Vec3 top(resting.x(), resting.y(), z);
  z = std::max(z - choice.under * model.under, std::min(z, resting.z()));
  Vec3 end(place.x(), place.y(), z);
  const Vec3 toward = level(end - top);
  const double length = toward.norm();
  const Vec3 along = length > 0 ? Vec3(toward / length) : Vec3(Vec3::Zero());
  const Vec3 begin = end - std::min(length, choice.acceptance * model.acceptance) * along;
  end += choice.overshot * (model.overshoot_time * model.speed + model.overshoot) * along;
  if (choice.acceptance > 0) end.z() = std::min(z, std::max(ground, z - model.fall));
  return {at, resting, top, begin, end, {end.x(), end.y(), ground}};
}

// Brakes, and sinks where it rests.
inline std::vector<Vec3> way_down(const traj::ReturnModel& model, const traj::ReturnTask& task,
                                  const Vec3& at, const Vec3& velocity, const Choice& choice) {
  const Vec3 resting = rest(model, at, velocity, choice.braking);
  return {at, resting, {resting.x(), resting.y(), task.home.z()}};
}

inline std::vector<Vec3> way_of(const traj::ReturnModel& model, const traj::ReturnTask& task,
                                const Vec3& at, const Vec3& velocity, const Vec3& place,
                                const Choice& choice) {
  if (task.action == traj::ReturnAction::land) {
    return way_down(model, task, at, velocity, choice);
  }
  if (task.action == traj::ReturnAction::hold) {
    return {at, rest(model, at, velocity, choice.braking)};
  }
  return way_home(model, task, at, velocity, place, choice);
}

// Metres along each axis from the vehicle's reference point that its box takes: with its margin, or
// what the model may be off its way and wrong about its place, if that is more.
inline Vec3 reach(const geom::CollisionScene& scene, const traj::ReturnModel& model,
                  const traj::ReturnTask& task) {
  const Vec3 margin = scene.half() - scene.vehicle().half;
  return scene.vehicle().half + margin.cwiseMax(model.around + task.room);
}

// A model without any room: what it does is the thin way itself. And others.
inline traj::ReturnModel thin_return_model(Random& random) {
  traj::ReturnModel model;
  model.autopilot = "thin";
  model.height = random.stepped(20, 80, 0.25);
  model.deceleration = random.stepped(1, 5, 0.25);
  model.jerk = 1e9;
  model.speed = 10;
  model.climb = 3;
  model.descent = 1.5;
  return model;
}

inline traj::ReturnModel any_return_model(Random& random) {
  switch (random.below(6)) {
    case 0:
    case 1:
      return thin_return_model(random);
    case 2:
      return traj::return_model(traj::px4());
    case 3:
      return traj::return_model(traj::ardupilot());
    case 4:
      return traj::dji_return_model(random.stepped(20, 80, 0.25));
    default:
      break;
  }
  traj::ReturnModel model = thin_return_model(random);
  model.autopilot = "any";
  model.jerk = random.uniform(1, 8);
  model.reaction = random.uniform(0, 1);
  model.overshoot_time = random.uniform(0, 0.3);
  model.overshoot = random.below(2) * random.uniform(0, 0.5);
  model.least_climb = random.below(2) * random.uniform(0, 20);
  model.stop_length = random.below(2) * random.uniform(0, 2);
  model.cone.px4_1_12 = random.below(2);
  model.cone.near = random.uniform(5, 60);
  model.slope = random.below(2) * random.uniform(0.5, 3);
  model.under = random.uniform(0, 2);
  model.acceptance = random.uniform(0, 10);
  model.fall = random.uniform(0, 10);
  model.rally_adds = random.below(2);
  model.nearer = random.below(2) * random.uniform(0, 5);
  model.any_place = random.below(4) == 0;
  for (int axis = 0; axis < 3; ++axis) model.around[axis] = random.uniform(0, 1);
  return model;
}

}  // namespace support
