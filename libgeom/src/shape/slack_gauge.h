#pragma once

// Whether rectangles reach no further outside a polygon than a slack.

#include <optional>
#include <span>
#include <vector>

#include "cover_edge.h"

namespace geom {

// The distance to the polygon grows by no more than one goes, so a piece of a rectangle whose
// centre is near enough for its corners is settled, and others are halved. Most slabs are settled
// before, at the corners of what each of their edges bounds: the distance to an edge is convex. A
// point of a slab is asked about with the edges alone that come within 1.5 slacks of the slab's
// heights: those that it can be near, and all that it can be inside of.
class SlackGauge {
 public:
  // Doubles tell how near a point is to an edge. At most this near, the rectangle that is rounded
  // outward around the point stays within the slack. A slack is at least 1e-6 m and 1e-9 of the
  // coordinates, so distances are rounded by less than 1e-5 of it, and rectangles by 1e-9 m and
  // 2e-6 of it.
  static double surely_near(double slack) { return (1 - 2e-5) * slack - 2e-9; }

  SlackGauge(double slack, std::size_t rings);

  // A slab from y0, with the edges that begin there or below, instead of those of the slab before.
  void begin(double y0, std::span<const CoverEdge* const> begun);
  // Those that begin above, the lowest first.
  void add(const CoverEdge& edge) { edges_.push_back(&edge); }
  void take_back() { edges_.pop_back(); }  // the edge that was added last
  // How far up the slab goes; after the edges near it were added.
  void reach_to(double y1);
  std::span<const CoverEdge* const> edges() const { return edges_; }

  // Whether the corner that refused a slab last surely refuses this one.
  bool refuses_again();

  // Whether the corner that refused the slab surely refuses it wherever it is moved up by as much
  // or less. Asks the edges that were added, which must be all near any of those slabs.
  bool refuses_further(double rise);

  // Whether all rectangles of the slab stay within the slack; nothing where allows() must look at
  // each. Their points are within the ranges of edges, or inside.
  std::optional<bool> clear_case();

  // Whether the rectangle, one that covers a part of the slab, stays within the slack of the
  // polygon. After clear_case().
  bool allows(const Rectangle& r);

 private:
  bool meets(const CoverEdge& edge) const { return edge.high.y() > y0_ && edge.low.y() < y1_; }
  // Whether the point is surely too far from it. By comparisons alone.
  bool out_of_reach(const CoverEdge& edge, const Vec2& p) const {
    return p.x() < edge.left - reach_ || p.x() > edge.right + reach_ ||
           p.y() < edge.low.y() - reach_ || p.y() > edge.high.y() + reach_;
  }
  // The edges that meet the slab or touch it: all that its points can be right or left of.
  std::span<const CoverEdge* const> meeting() const {
    return std::span(edges_).subspan(first_meeting_, end_meeting_ - first_meeting_);
  }
  Rectangle around(const CoverEdge& edge) const;
  bool is_steep(const CoverEdge& edge) const;
  bool look_at(const CoverEdge& edge);
  void add_unclear(const Rectangle& r, const CoverEdge& edge);
  void keep_unclear(const Rectangle& place);
  bool settle(const Rectangle& r);
  bool is_near(double squared_reach, const Vec2& p);
  bool beside(const Rectangle& r, const CoverEdge& edge) const;
  bool beside_any(const Rectangle& r) const;
  bool within_halves(const Rectangle& r, bool middle_inside);
  bool within_bands(const Rectangle& r);
  bool touches_unclear(const Rectangle& r) const;
  bool is_inside(const Vec2& p);
  bool clear_of_edges(const Rectangle& r) const;

  double slack_;
  double near_;
  double near_squared_;
  double reach_;  // more than the slack
  double y0_ = 0;
  double y1_ = 0;
  double touching_;  // more than rectangles are rounded outward
  // Those that end below the slab, others that begin below it, and the rest by their lower end.
  std::vector<const CoverEdge*> edges_;
  std::size_t first_meeting_ = 0;
  std::size_t end_meeting_ = 0;
  std::size_t nearest_ = 0;         // one that was near the last point, and mostly is near the next
  std::vector<Rectangle> found_;    // places that may be far from the edge that bounds them
  std::vector<Rectangle> unclear_;  // what is not settled of them
  double unclear_size_ = 0;         // the longest side of one of them
  // The corner that refused the last slab refuses the next most often.
  const CoverEdge* refusing_ = nullptr;
  std::size_t refusing_corner_ = 0;
  Winding winding_;
};

}  // namespace geom
