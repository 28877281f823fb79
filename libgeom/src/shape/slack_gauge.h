#pragma once

// Whether rectangles reach no further outside a polygon than a slack.

#include <optional>
#include <span>
#include <vector>

#include "near_edges.h"

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

  // The corner that refused a slab last. It refuses the next most often.
  struct Refusal {
    const CoverEdge* edge = nullptr;
    std::size_t corner = 0;
  };
  const Refusal& refusal() const { return refusal_; }
  void set_refusal(const Refusal& refusal) { refusal_ = refusal; }

  // Whether the corner that refused a slab last surely refuses this one.
  bool refuses_again();

  // Prepares corner_refuses() for slabs that go up to `least` or more, and no further than this
  // one.
  void follow_corner(double least);
  // The same as refuses_again() of the slab up to y1.
  bool corner_refuses(double y1);

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
  bool meets(const CoverEdge& edge) const { return meets_up_to(edge, y1_); }
  bool meets_up_to(const CoverEdge& edge, double y1) const {
    return edge.high.y() > y0_ && edge.low.y() < y1;
  }
  // Whether the point is surely too far from it. By comparisons alone.
  bool out_of_reach(const CoverEdge& edge, const Vec2& p) const {
    return p.x() < edge.left - reach_ || p.x() > edge.right + reach_ ||
           p.y() < edge.low.y() - reach_ || p.y() > edge.high.y() + reach_;
  }
  // The edges that meet the slab or touch it: all that its points can be right or left of.
  std::span<const CoverEdge* const> meeting() const {
    return std::span(edges_).subspan(first_meeting_, end_meeting_ - first_meeting_);
  }
  Rectangle around(const CoverEdge& edge, double y1) const;
  Vec2 refusing_corner(double y1) const;
  bool is_steep(const CoverEdge& edge) const;
  bool look_at(const CoverEdge& edge);
  void add_unclear(const Rectangle& r, const CoverEdge& edge);
  void keep_unclear(const Rectangle& place);
  bool settle(const Rectangle& place);
  bool settle_part(const Rectangle& r);
  bool is_near(double squared_reach, const Vec2& p);
  bool beside(const Rectangle& r, const CoverEdge& edge) const;
  bool beside_any(const Rectangle& r) const;
  bool within_halves(const Rectangle& r, bool middle_inside);
  void gather(const Rectangle& place) { place_.gather(edges_, meeting(), place, reach_); }
  bool within_bands(const Rectangle& r);
  bool touches_unclear(const Rectangle& r) const;
  bool is_inside(const Vec2& p);
  bool clear_of_edges(const Rectangle& r) const;
  bool allows_part(const Rectangle& r);

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
  Refusal refusal_;
  Winding winding_;
  NearEdges place_;   // what a place asks about while it is halved
  NearEdges corner_;  // and the corner that refused, while it is followed
};

}  // namespace geom
