#pragma once

// Edges of footprints that are straight in their source and bend on the map.

#include <span>
#include <vector>

#include "geom/gis/footprint_source.h"

namespace geom::gis {

// Metres that a straight edge of the source may lie beside the sides of a footprint on the map.
inline constexpr double kEdgeTolerance = 1e-4;

// Adds corners to footprints where their edges bend by more than `kEdgeTolerance`. Takes many
// footprints, and converts the points that it needs of all of them together. Edges of less than
// 25 m bend by less, within 80 degrees of the equator.
//
// Example:
//   EdgeFollower edges(projector);
//   edges.take(footprint, corners_in_the_source);  // the footprint's own are on the map already
//   edges.follow();
class EdgeFollower {
 public:
  explicit EdgeFollower(const Projector& projector) : projector_(projector) {}

  // `source`: the corners of the rings one after another. The footprint must outlive follow().
  void take(Footprint& footprint, std::span<const Vec2> source);

  // Throws InputError where PROJ cannot convert a point of an edge.
  void follow();

 private:
  // From a corner to the next one of its ring.
  struct Edge {
    Footprint* footprint;
    std::size_t corner;  // counted through the rings
    bool reversed;       // `from` is its second end
    Vec2 from;           // in the source
    Vec2 step;           // to the other end
    Vec2 a;              // its ends on the map
    Vec2 b;
    std::size_t pieces = 1;  // that it is cut into
    std::vector<Vec2> bend;  // the corners between these, on the map
    bool done = false;
  };

  void add(Footprint& footprint, std::size_t corner, const Vec2& a, const Vec2& b, const Vec2& from,
           const Vec2& to);
  void ask(const Edge& edge, std::vector<Vec2>& points) const;
  static void settle(Edge& edge, std::span<const Vec2> points);
  static void insert(std::span<const Edge> edges);

  const Projector& projector_;
  std::vector<Edge> edges_;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b);

}  // namespace geom::gis
