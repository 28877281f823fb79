#include "edge_follower.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geom::gis {
namespace {

constexpr double kShort = 25;            // metres, on the map
constexpr std::size_t kMost = 1U << 16;  // pieces: of thousands of kilometres, off by a millimetre

bool is_before(const Vec2& a, const Vec2& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

// Calls f(ring, number of its first corner).
template <class F>
void for_each_ring(Footprint& footprint, const F& f) {
  std::size_t first = 0;
  const auto next = [&](std::vector<Vec2>& ring) {
    const std::size_t size = ring.size();
    f(ring, first);
    first += size;
  };
  next(footprint.polygon.outer);
  for (auto& hole : footprint.polygon.holes) next(hole);
}

}  // namespace

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 step = b - a;
  const double squared = step.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(step) / squared, 0.0, 1.0) : 0;
  return (a + t * step - p).norm();
}

void EdgeFollower::take(Footprint& footprint, std::span<const Vec2> source) {
  if (projector_.frame().crs.empty()) return;  // the source is in metres of the map
  for_each_ring(footprint, [&](const std::vector<Vec2>& ring, std::size_t first) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = i + 1 < ring.size() ? i + 1 : 0;
      if ((ring[j] - ring[i]).squaredNorm() <= kShort * kShort) continue;
      add(footprint, first + i, ring[i], ring[j], source[first + i], source[first + j]);
    }
  });
}

// From one end whichever way the ring goes, so that neighbours get the same corners.
void EdgeFollower::add(Footprint& footprint, std::size_t corner, const Vec2& a, const Vec2& b,
                       const Vec2& from, const Vec2& to) {
  Edge edge{.footprint = &footprint,
            .corner = corner,
            .reversed = is_before(to, from),
            .from = from,
            .step = to - from,
            .a = a,
            .b = b,
            .bend = {}};
  if (edge.reversed) {
    edge.from = to;
    edge.step = from - to;
  }
  const double turn = projector_.turn();  // an edge goes the short way around the Earth
  if (turn > 0 && edge.step.x() > turn / 2) edge.step.x() -= turn;
  edges_.push_back(std::move(edge));
}

// The ends of its pieces, and two points within each.
void EdgeFollower::ask(const Edge& edge, std::vector<Vec2>& points) const {
  const std::size_t parts = 4 * edge.pieces;
  for (std::size_t i = 1; i < parts; ++i) {
    if (i % 4 == 2) continue;
    const std::size_t at = edge.reversed ? parts - i : i;
    points.push_back(edge.from +
                     edge.step * (static_cast<double>(at) / static_cast<double>(parts)));
  }
}

// Whether the pieces are short enough; else how many it needs. The points are a quarter and three
// quarters along each piece, and then its end. There a curve is at least seven tenths as far from
// its chord as anywhere, whether it bends to one side or changes sides in the middle.
void EdgeFollower::settle(Edge& edge, std::span<const Vec2> points) {
  double furthest = 0;
  std::vector<Vec2> ends;
  Vec2 a = edge.a;
  for (std::size_t i = 0; i < edge.pieces; ++i) {
    const Vec2& b = i + 1 < edge.pieces ? points[3 * i + 2] : edge.b;
    for (const Vec2& p : points.subspan(3 * i, 2)) {
      furthest = std::max(furthest, distance_to_segment(p, a, b) / 0.7);
    }
    if (i + 1 < edge.pieces) ends.push_back(b);
    a = b;
  }
  edge.done = furthest <= kEdgeTolerance || edge.pieces == kMost;
  if (edge.done) {
    edge.bend = std::move(ends);
  } else {
    const double times = std::ceil(1.1 * std::sqrt(furthest / kEdgeTolerance));
    edge.pieces = static_cast<std::size_t>(
        std::min(static_cast<double>(kMost), static_cast<double>(edge.pieces) * times));
  }
}

void EdgeFollower::follow() {
  std::vector<Vec2> points;
  for (bool again = !edges_.empty(); again;) {
    points.clear();
    for (const Edge& edge : edges_) {
      if (!edge.done) ask(edge, points);
    }
    projector_.convert(points);
    again = false;
    std::size_t next = 0;
    for (Edge& edge : edges_) {
      if (edge.done) continue;
      const std::size_t count = 3 * edge.pieces - 1;
      settle(edge, std::span(points).subspan(next, count));
      next += count;
      again |= !edge.done;
    }
  }
  std::erase_if(edges_, [](const Edge& edge) { return edge.bend.empty(); });
  for (std::size_t i = 0; i < edges_.size();) {
    std::size_t end = i + 1;
    while (end < edges_.size() && edges_[end].footprint == edges_[i].footprint) ++end;
    insert(std::span(edges_).subspan(i, end - i));
    i = end;
  }
  edges_.clear();
}

// `edges`: those of one footprint, in their order. New corners of a sloping roof lie on its edge.
void EdgeFollower::insert(std::span<const Edge> edges) {
  Footprint& footprint = *edges.front().footprint;
  std::vector<double> heights;
  std::size_t next = 0;
  for_each_ring(footprint, [&](std::vector<Vec2>& ring, std::size_t first) {
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      corners.push_back(ring[i]);
      const std::size_t j = i + 1 < ring.size() ? i + 1 : 0;
      const bool slopes = !footprint.heights.empty();
      const double low = slopes ? footprint.heights[first + i] : 0;
      const double rise = slopes ? footprint.heights[first + j] - low : 0;
      if (slopes) heights.push_back(low);
      if (next == edges.size() || edges[next].corner != first + i) continue;
      const auto& bend = edges[next++].bend;
      corners.insert(corners.end(), bend.begin(), bend.end());
      for (std::size_t k = 1; slopes && k <= bend.size(); ++k) {
        heights.push_back(low +
                          rise * static_cast<double>(k) / static_cast<double>(bend.size() + 1));
      }
    }
    ring = std::move(corners);
  });
  footprint.heights = std::move(heights);
}

}  // namespace geom::gis
