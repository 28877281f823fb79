#pragma once

// What leaves a map's bounds, and the map that would hold it, for people.

#include <string_view>

#include "cli/option/common.h"
#include "geom/map/box_map.h"
#include "geom/map/wider_bounds.h"
#include "geom/record/record.h"

namespace cli {

// Of all records that a run refused for it.
class BeyondBounds {
 public:
  explicit BeyondBounds(const geom::BoxMap& map) : wider_(map.spec().bounds) {}

  // The vehicle of `made_for`, with its margin, is at `place` there, and reaches `out` metres
  // beyond.
  void add(const geom::Provenance& made_for, const geom::Vec3& place, double out);

  // Says on stderr, unless -q, how far all of them reach and what to do. Nothing where none does.
  void tell(const Common& common, std::string_view tool) const;

 private:
  geom::WiderBounds wider_;
};

}  // namespace cli
