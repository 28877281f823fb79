#pragma once

// The squares of the plan that the bends of a roadmap are kept in, and how an edge names a bend of
// one nearby.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geom/shape/aabb.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

struct Square {
  std::int32_t column = 0;
  std::int32_t row = 0;

  friend bool operator==(const Square&, const Square&) = default;
};

// The place of a square on a curve through all of them (Morton 1966), which is the order of tiles:
// column and row, counted from -2^31, bit by bit in turn.
std::uint64_t code_of(const Square& square);
Square square_at(std::uint64_t code);

// The squares of roadmaps of one reach: so wide that what is within reach of one is in the few
// around it.
class Squares {
 public:
  static constexpr int kLocalBits = 24;  // of an edge, for the bend in its tile; eight for the tile
  static constexpr std::uint32_t kLocalMask = (1u << kLocalBits) - 1;

  explicit Squares(double reach)
      : side_(std::max(100.0, reach / 6)),
        around_(static_cast<std::int32_t>(std::clamp(std::ceil(reach / side_), 1.0, 7.0))) {}

  double side() const { return side_; }  // metres
  std::int32_t around() const { return around_; }
  std::uint32_t slots() const { return static_cast<std::uint32_t>(across() * across()); }

  Square of(const Vec3& p) const { return {index(p.x()), index(p.y())}; }
  std::int32_t index(double coordinate) const {
    return static_cast<std::int32_t>(std::floor(coordinate / side_));
  }

  // All that may be in squares from `low` to `high`, with `pad` metres around it; as high as maps
  // may be.
  geom::Aabb box(const Square& low, const Square& high, double pad) const {
    constexpr double kHigh = 2 * geom::kLargestCoordinate;
    return {Vec3(low.column * side_ - pad, low.row * side_ - pad, -kHigh),
            Vec3((high.column + 1.0) * side_ + pad, (high.row + 1.0) * side_ + pad, kHigh)};
  }

  // Of an edge from a bend in `from`: where it leads to. They are near() each other.
  std::uint32_t slot(const Square& from, const Square& to) const {
    return static_cast<std::uint32_t>((to.row - from.row + around_) * across() +
                                      (to.column - from.column + around_));
  }
  Square beside(const Square& from, std::uint32_t slot) const {
    const auto n = static_cast<std::int64_t>(slot);
    return {static_cast<std::int32_t>(from.column + n % across() - around_),
            static_cast<std::int32_t>(from.row + n / across() - around_)};
  }

 private:
  std::int32_t across() const { return 2 * around_ + 1; }

  double side_;
  std::int32_t around_;
};

}  // namespace plan
