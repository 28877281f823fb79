#pragma once

// The way home from one place, chosen among the sites.

#include <optional>
#include <span>
#include <vector>

#include "traj/home/ways_home.h"

namespace traj {

// A way that is known: its points, and m from the first to the last.
struct ChosenWay {
  std::size_t site = 0;
  geom::Polyline points;
  double rest = 0;
};

// Metres of a way from the furthest of the places from which it is joined.
double length_from(std::span<const Vec3> hull, const ChosenWay& way);

// The middle of places: in their hull.
Vec3 mean(std::span<const Vec3> hull);

// Looks for ways from places (a hull that is clear itself) to the sites of a task.
class WayChoice {
 public:
  // Both must outlive this.
  WayChoice(const geom::CollisionScene& scene, const WaysTask& task) : scene_(scene), task_(task) {}

  // The shortest that was found. It can be joined straight from every place of the hull.
  std::optional<ChosenWay> choose(std::span<const Vec3> hull) const;

  // Metres straight to the nearest site and down.
  double straight(const Vec3& from) const;

 private:
  double straight(const Vec3& from, const LandingSite& site) const;
  std::optional<ChosenWay> level_way(std::span<const Vec3> hull, std::size_t site) const;
  std::optional<geom::Polyline> at_height(std::span<const Vec3> hull, const LandingSite& site,
                                          double z) const;
  std::optional<ChosenWay> planned(std::span<const Vec3> hull, std::size_t site) const;
  bool each_leg_free(const geom::Polyline& path) const;

  const geom::CollisionScene& scene_;
  const WaysTask& task_;
};

}  // namespace traj
