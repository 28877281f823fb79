#pragma once

// How much higher than at home an autopilot takes the terrain to be.

#include <string_view>

#include "traj/mission/flown/terrain_rules.h"

namespace traj {

// A closed range of metres.
struct TerrainRange {
  double low = 0;
  double high = 0;

  // Both, and all between.
  TerrainRange with(const TerrainRange& other) const {
    return {std::min(low, other.low), std::max(high, other.high)};
  }
  bool operator==(const TerrainRange&) const = default;
};

// ArduPilot's AP_Terrain::height_above_terrain: its terrain at a place less its terrain where it
// armed. Each of the two is interpolated between posts that are up to `spacing` metres away along
// each axis, and whose heights may be of places that are further away.
class TerrainDifference {
 public:
  // `home` and all regions are east and north; `latitude` is home's, in degrees. `reach`: metres
  // around a place whose terrain counts there, beside the posts around it. Throws
  // geom::InputError(source, …) where the model does not know the ground around home, and further
  // than 84 degrees from the equator.
  TerrainDifference(const TerrainRules& rules, const geom::Vec2& home, double latitude,
                    double spacing, double reach, std::string_view source);

  // Over all of a closed region. Throws geom::InputError(source, …) where the model does not know
  // the ground there and around it.
  TerrainRange over(const geom::Rectangle& region) const;

  // Metres from home to the furthest point of the region, along the axes.
  double furthest(const geom::Rectangle& region) const;

 private:
  geom::GroundRange ground(const geom::Rectangle& region, double around) const;

  TerrainRules rules_;
  double error_ = 0;  // m that its terrain may be off at a post
  geom::Vec2 home_;
  double spacing_;  // m from a place to the posts around it, along each axis,
  double far_;      // and to the places whose heights these have
  double reach_;
  std::string source_;
  geom::GroundRange at_home_;
  double slope_;  // metres of height per metre along an axis, at most, around home
};

}  // namespace traj
