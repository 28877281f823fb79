#pragma once

// A town, a flight through it, and an autopilot, for the tests of ways home.

#include <vector>

#include "geom/record/record.h"
#include "support/small_map.h"
#include "traj/home/home_flight.h"
#include "traj/home/landing_site.h"
#include "traj/home/return_model.h"
#include "traj/home/ways_home.h"

namespace traj::testing {

inline ReturnModel plain_model() {
  ReturnModel model;
  model.autopilot = "plain";
  model.reaction = 0.3;
  model.deceleration = 3;
  model.jerk = 6;
  model.ramp = 0.25;
  model.overshoot_time = 0.2;
  model.overshoot = 0.3;
  model.speed = 8;
  model.climb = 3;
  model.descent = 2;
  return model;
}

inline geom::CollisionScene small_vehicle(geom::BoxMap map, double margin = 0.2) {
  return {std::move(map), geom::Vehicle{"small", Vec3(0.4, 0.4, 0.3)}, margin};
}

// 100 m of level ground with these blocks, up to 60 m.
inline geom::BoxMap town(std::vector<geom::Aabb> blocks) {
  return support::map_of({{0, 0, 0}, {100, 100, 60}}, std::move(blocks));
}

inline DrawnSite drawn_at(double x, double y, std::optional<double> ground = {}) {
  DrawnSite site;
  site.id = "pad";
  site.feature = 1;
  site.outline.outer = {{x, y}};
  site.ground = ground;
  return site;
}

inline WaysTask task_of(const geom::CollisionScene& scene, const std::vector<geom::Vec2>& pads) {
  WaysTask task;
  task.models = {plain_model()};
  for (const geom::Vec2& pad : pads) {
    task.sites.push_back(landing_site(scene, drawn_at(pad.x(), pad.y()), "sites"));
    task.sites.back().id = "pad-" + std::to_string(task.sites.size());
  }
  return task;
}

inline geom::PathRecord path_of(geom::Polyline points) {
  geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found};
  record.points = std::move(points);
  return record;
}

// A flight past a block; the ways home go over the block.
struct FlightPastABlock {
  geom::CollisionScene scene = small_vehicle(town({{{40, 0, 0}, {45, 70, 30}}}));
  std::vector<FlightStage> stages =
      stages_of(path_of({{10, 50, 10}, {25, 50, 10}, {25, 80, 10}, {80, 80, 10}}), 5);
  WaysTask task = task_of(scene, {{90, 50}, {10, 20}});
};

}  // namespace traj::testing
