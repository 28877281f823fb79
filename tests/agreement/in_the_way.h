#pragma once

// Missions with an obstacle or a fence put into the way of them: what the programs have in common
// that make them.

#include <fmt/format.h>

#include <GeographicLib/TransverseMercatorExact.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include "geom/collision/collision.h"
#include "support/random_city.h"
#include "support/small_map.h"
#include "traj/mission/judge/judge.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace in_the_way {

using geom::Vec3;
using support::Random;

inline const Vec3 kHalf(0.3, 0.3, 0.2);  // of the vehicle

// By GeographicLib's exact projection about 47 N, 8 E.
inline Vec3 projected(double latitude, double longitude, double z) {
  static const GeographicLib::TransverseMercatorExact mercator(6378137, 1 / 298.257223563, 1);
  static const double north = [] {
    double x = 0;
    double y = 0;
    mercator.Forward(8, 47, 8, x, y);
    return y;
  }();
  double x = 0;
  double y = 0;
  mercator.Forward(8, latitude, longitude, x, y);
  return {x, y - north, z};
}

// Where the obstacle is put: a point of the way; or a fence.
struct Attack {
  std::string what;
  Vec3 point = Vec3::Zero();
  int fence = 0;  // 1: stay out of, 2: stay in
};

// A mission as text, what is attacked, and what the product makes of the text.
struct Trial {
  std::string text;
  Attack attack;
  traj::FlownMission flown;
};

// A box that once grown by the vehicle has the point `depth` inside it, and no deeper.
inline geom::Aabb box_around(Random& random, const Vec3& p, double depth) {
  const int axis = random.below(3);
  const bool high = random.below(2);
  geom::Aabb box;
  for (int i = 0; i < 3; ++i) {
    const double width = std::max(kHalf[i], depth) + random.uniform(0.01, 3);
    const double middle = i != axis ? p[i] : high ? p[i] + depth - width : p[i] - depth + width;
    box.min[i] = middle - (width - kHalf[i]);
    box.max[i] = middle + (width - kHalf[i]);
  }
  return box;
}

// Over flat ground at that z, which is the floor of the bounds.
inline geom::CollisionScene scene_of(const std::optional<geom::Aabb>& box, double ground) {
  const std::vector<geom::Aabb> boxes(box ? 1 : 0, box.value_or(geom::Aabb{}));
  return {support::map_of({{-1000, -1000, ground}, {1000, 1000, 200}}, boxes), {"box", kHalf}, 0};
}

// A square, or a circle about home, that the vehicle's box breaks by `depth` at the point.
inline traj::Fence fence_at(Random& random, const Attack& attack, double depth) {
  const double x = attack.point.x();
  const double y = attack.point.y();
  if (attack.fence == 1) {
    const double size = random.uniform(0.5, 5);
    const double left = x + kHalf.x() - depth;
    return {false,
            {{left, y - size}, {left + size, y - size}, {left + size, y + size}, {left, y + size}},
            0};
  }
  const double right = x + kHalf.x() - depth;
  return {true, {{-900, -900}, {right, -900}, {right, 900}, {-900, 900}}, 0};
}

inline bool accepted(const geom::CollisionScene& scene, const traj::FlownMission& mission) {
  return traj::judge(scene, {mission}, {}, traj::Clearance::left_out).ok;
}

// COUNT missions over the ground that `make(random, i)` gives, each without and with what is put
// into its way. The exit code: 1 where one passes with it, or does not without.
template <class Make>
int run(int argc, char** argv, double ground, const Make& make) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  Random random(argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1);
  const geom::CollisionScene empty = scene_of({}, ground);
  std::map<std::string, int> tried;
  int wrong = 0;
  int free = 0;
  for (int i = 0; i < count; ++i) {
    Trial trial = make(random, i);
    const Attack& attack = trial.attack;
    const double depth = std::pow(10, random.uniform(-6, 0));
    free += accepted(empty, trial.flown);
    ++tried[attack.what];
    if (attack.fence) trial.flown.fences.push_back(fence_at(random, attack, depth));
    const bool passed =
        attack.fence
            ? accepted(empty, trial.flown)
            : accepted(scene_of(box_around(random, attack.point, depth), ground), trial.flown);
    if (!passed) continue;
    if (++wrong <= 10) {
      fmt::print("wrong: {} {}: {} m deep\n{}", i, attack.what, depth, trial.text);
    }
  }
  for (const auto& [what, times] : tried) fmt::print("{}: {}\n", what, times);
  fmt::print("{} missions, {} of them free without the obstacle, {} accepted with it\n", count,
             free, wrong);
  return wrong != 0 || free != count;
}

}  // namespace in_the_way
