#pragma once

// The edges of a polygon that decide about the points of a small region.

#include <algorithm>
#include <span>
#include <vector>

#include "cover_edge.h"

namespace geom {

// Many points of one region are asked about, and few edges come near it. The others are to one side
// of all of its points, so they are counted once.
class NearEdges {
 public:
  explicit NearEdges(std::size_t rings) : winding_(rings) {}

  // `near`: all edges that points of the region can be within `reach` of. `meeting`: all of them
  // that have a point at the height of one of the region's.
  void gather(std::span<const CoverEdge* const> near, std::span<const CoverEdge* const> meeting,
              const Rectangle& region, double reach) {
    const Rectangle r{region.min.array() - kPad, region.max.array() + kPad};
    // Every edge is written, and kept or written over: which it will be is hard to predict.
    near_.resize(std::max(near_.size(), near.size()));
    count_near_ = 0;
    for (const CoverEdge* edge : near) {
      near_[count_near_] = edge;
      count_near_ += (edge->left <= r.max.x() + reach) & (edge->right >= r.min.x() - reach) &
                     (edge->low.y() <= r.max.y() + reach) & (edge->high.y() >= r.min.y() - reach);
    }
    beside_.resize(std::max(beside_.size(), meeting.size()));
    count_beside_ = 0;
    winding_.clear();
    odd_ = false;
    for (const CoverEdge* edge : meeting) {
      beside_[count_beside_] = edge;
      const bool across = (edge->low.y() < r.min.y()) & (edge->high.y() > r.max.y());
      if ((edge->left > r.max.x()) & across) {
        winding_.count(*edge);
        odd_ = !odd_;
        continue;
      }
      count_beside_ +=
          (edge->right >= r.min.x()) & (edge->low.y() <= r.max.y()) & (edge->high.y() >= r.min.y());
    }
  }

  // In the order in which they were given.
  std::span<const CoverEdge* const> near() const { return {near_.data(), count_near_}; }
  // Those that points of the region may be left or right of. All that meet the region are there.
  std::span<const CoverEdge* const> beside() const { return {beside_.data(), count_beside_}; }

  // Of a point of the region: whether it is inside the polygon, or where rings overlap.
  bool is_inside(const Vec2& p) {
    bool odd = odd_;
    counted_.clear();
    for (const CoverEdge* edge : beside()) {
      if (!edge->is_right_of(p)) continue;
      winding_.count(*edge);
      counted_.push_back(edge);
      odd = !odd;
    }
    const bool inside = odd || winding_.inside();
    for (const CoverEdge* edge : counted_) winding_.take_back(*edge);
    return inside;
  }

  bool is_near(double squared_reach, const Vec2& p) const {
    for (const CoverEdge* edge : near()) {
      if (edge->is_within(squared_reach, p)) return true;
    }
    return false;
  }

 private:
  static constexpr double kPad = 1e-6;  // metres: more than points are rounded out of the region

  std::vector<const CoverEdge*> near_;
  std::vector<const CoverEdge*> beside_;
  std::size_t count_near_ = 0;
  std::size_t count_beside_ = 0;
  std::vector<const CoverEdge*> counted_;
  Winding winding_;  // of the edges that are to the right of all points
  bool odd_ = false;
};

}  // namespace geom
