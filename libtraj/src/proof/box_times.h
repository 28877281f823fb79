#pragma once

// When boxes are there, in seconds from the begin of a flight.

#include <cstddef>
#include <optional>

#include "curve/curve_piece.h"
#include "geom/map/box_map.h"

namespace traj {

// Longer than any time of a box is from any begin of a flight, in seconds.
inline constexpr double kEver = 4e9;

// Of a flight that begins at `start`, seconds after the map's epoch; where that is nothing, every
// box is always there. Times are rounded outward, and so much more that a piece of a curve of
// `pieces` segments and `duration` seconds, halved 60 times or fewer, shares an instant with a box
// wherever it does in real numbers. The map must outlive it.
class BoxTimes {
 public:
  BoxTimes() = default;  // every box is always there
  BoxTimes(const geom::BoxMap& map, const std::optional<double>& start, std::size_t pieces,
           double duration);

  bool count() const { return map_ != nullptr; }  // false: every box is always there
  geom::TimeSpan of(std::size_t box) const;

 private:
  const geom::BoxMap* map_ = nullptr;  // where times count
  double start_ = 0;
  double slack_ = 0;
};

inline geom::TimeSpan time_of(const Piece& piece) { return {piece.begin, piece.end}; }

// A box near a curve, and when it is there.
struct BoxInTime {
  geom::Aabb box;
  geom::TimeSpan time;
};

}  // namespace traj
