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
  // A share of the slack: what is nearer, or further than a little more than 1, is no close
  // decision, however it is rounded.
  static constexpr double kSurelyNear = 0.978;

  SlackGauge(double slack, std::size_t rings);

  // Forgets the edges of the slab before.
  void begin(double y0, double y1);
  void add(const CoverEdge& edge) { near_.push_back(&edge); }
  void take_back() { near_.pop_back(); }  // the edge that was added last
  // The slab from the same height up to another one; the edges stay.
  void reach_to(double y1) { y1_ = y1; }
  std::span<const CoverEdge* const> edges() const { return near_; }

  // Whether the corner that refused the slab surely refuses it wherever it is moved up by as much
  // or less. Asks the edges that were added, which must be all near any of those slabs.
  bool refuses_further(double rise);

  // What allows() would say of all rectangles of the slab, where that is no close decision. Their
  // points are within the ranges of edges, or inside.
  std::optional<bool> clear_case();

  // Whether the rectangle, one that covers a part of the slab, stays within the slack of the
  // polygon. After clear_case().
  bool allows(const Rectangle& r);

 private:
  // What is not surely within the slack of an edge: where one corner alone of what the edge bounds
  // is further, a place there.
  struct Unclear {
    Rectangle place;
    const CoverEdge* edge = nullptr;
    std::size_t corner = 0;  // where there is an edge
    bool close = false;      // the corner is near no other edge surely, and not inside
  };

  bool meets(const CoverEdge& edge) const { return edge.high.y() > y0_ && edge.low.y() < y1_; }
  // Whether what has this x is surely too far from it. By a comparison alone.
  bool out_of_reach(const CoverEdge& edge, double x) const {
    return x < edge.left - reach_ || x > edge.right + reach_;
  }
  Rectangle around(const CoverEdge& edge) const;
  bool refuses_again();
  bool look_at(const CoverEdge& edge);
  void add_unclear(const Rectangle& r, const CoverEdge& edge, unsigned close);
  void keep_unclear(const Unclear& unclear);
  bool settle(const Rectangle& r);
  bool is_near(double squared_reach, const Vec2& p) const;
  bool beside(const Rectangle& r, const CoverEdge& edge) const;
  bool beside_any(const Rectangle& r) const;
  bool within_halves(const Rectangle& r, bool middle_inside);
  bool within_bands(const Rectangle& r);
  bool touches_unclear(const Rectangle& r) const;
  void settle_corners(const Rectangle& r);
  bool is_settled(const Unclear& unclear, const Rectangle& r) const;
  bool allows_parts(const Rectangle& r);
  double to_edge(const Vec2& p, double enough) const;
  bool is_inside(const Vec2& p);
  bool clear_of_edges(const Rectangle& r) const;

  double slack_;
  double near_squared_;
  double far_squared_;
  double reach_;  // more than that of what is surely far
  double y0_ = 0;
  double y1_ = 0;
  std::vector<const CoverEdge*> near_;
  std::vector<Unclear> unclear_;
  std::vector<Unclear> found_;  // of the slab that is looked at, before some are settled
  double unclear_size_ = 0;     // the longest side of one of them
  // The corner that refused the last slab refuses the next most often.
  const CoverEdge* refusing_ = nullptr;
  std::size_t refusing_corner_ = 0;
  Winding winding_;
};

}  // namespace geom
