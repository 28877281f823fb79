#pragma once

// The way home from one place, chosen among the sites.

#include <optional>

#include "home/braking.h"
#include "home/way_room.h"
#include "traj/home/ways_home.h"

namespace traj {

// A way that is known: its points, and m from the first to the last.
struct ChosenWay {
  std::size_t site = 0;
  geom::Polyline points;
  double rest = 0;
};

// Metres of a way from the furthest place of the region.
double length_from(const Braking& from, const ChosenWay& way);

// Looks for ways from regions that are clear themselves to the sites of a task.
class WayChoice {
 public:
  // Both must outlive this.
  WayChoice(const geom::CollisionScene& scene, const WaysTask& task)
      : scene_(scene), task_(task), room_(scene, task.models) {}

  // The shortest that was found. It can be joined straight from every place of the region.
  std::optional<ChosenWay> choose(const Braking& from) const;

  // Whether every straight way from the region to a place is clear.
  bool joins(const Braking& from, const Vec3& to) const { return room_.joins(from, to); }

  // Metres straight to the nearest site and down.
  double straight(const Vec3& from) const;

 private:
  double straight(const Vec3& from, const LandingSite& site) const;
  std::optional<ChosenWay> level_way(const Braking& from, std::size_t site) const;
  std::optional<geom::Polyline> at_height(const Braking& from, const LandingSite& site,
                                          double z) const;
  std::optional<ChosenWay> planned(const Braking& from, std::size_t site) const;
  bool each_leg_free(const geom::Polyline& path) const;

  const geom::CollisionScene& scene_;
  const WaysTask& task_;
  WayRoom room_;
};

}  // namespace traj
