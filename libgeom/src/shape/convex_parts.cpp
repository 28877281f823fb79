#include "shape/convex_parts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace geom {
namespace {

using Triangle = std::array<std::size_t, 3>;

// Twice the area to the left of a to b to c.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double twice_area(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += turn(ring[0], ring[i], ring[i + 1]);
  return sum;
}

// Without corners that repeat the one before, in the direction asked for.
std::vector<Vec2> tidied(const std::vector<Vec2>& ring, bool left) {
  std::vector<Vec2> out;
  for (const Vec2& p : ring) {
    if (out.empty() || p != out.back()) out.push_back(p);
  }
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  if ((twice_area(out) > 0) != left) std::reverse(out.begin(), out.end());
  return out;
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

// Cuts a ring of indices of `points` into triangles.
class Ears {
 public:
  Ears(const std::vector<Vec2>& points, std::vector<std::size_t> ring)
      : points_(points), ring_(std::move(ring)) {}

  std::vector<Triangle> cut() {
    std::vector<Triangle> out;
    std::size_t at = 0;
    std::size_t refused = 0;  // in a row
    while (ring_.size() > 2) {
      at %= ring_.size();
      const Triangle ear = corner(at);
      if (refused < ring_.size() && !is_ear(ear)) {
        ++refused;
        ++at;
        continue;
      }
      out.push_back(ear);
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
      refused = 0;
      at = at == 0 ? ring_.size() - 1 : at - 1;
    }
    return out;
  }

 private:
  Triangle corner(std::size_t at) const {
    const std::size_t n = ring_.size();
    return {ring_[(at + n - 1) % n], ring_[at], ring_[(at + 1) % n]};
  }

  bool is_ear(const Triangle& t) const {
    const Vec2& a = points_[t[0]];
    const Vec2& b = points_[t[1]];
    const Vec2& c = points_[t[2]];
    const double area = turn(a, b, c);
    if (area == 0) return a == c || (b - a).dot(c - b) >= 0 || (c - b).dot(a - c) >= 0;
    if (area < 0) return false;
    return std::none_of(ring_.begin(), ring_.end(), [&](std::size_t i) {
      const Vec2& p = points_[i];
      if (p == a || p == b || p == c) return false;
      return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }

  const std::vector<Vec2>& points_;
  std::vector<std::size_t> ring_;
};

// One ring of all rings: each hole is entered from a corner that sees one of its own, and left the
// same way.
class Bridges {
 public:
  explicit Bridges(const Polygon& polygon) {
    add(tidied(polygon.outer, true));
    ring_ = std::move(loops_.front());
    loops_.erase(loops_.begin());
    for (const auto& hole : polygon.holes) {
      if (!hole.empty()) add(tidied(hole, false));
    }
    std::stable_sort(loops_.begin(), loops_.end(),
                     [&](const auto& a, const auto& b) { return rightmost(a) > rightmost(b); });
    while (!loops_.empty()) {
      join(loops_.front());
      loops_.erase(loops_.begin());
    }
  }

  std::vector<Vec2> points;
  const std::vector<std::size_t>& ring() const { return ring_; }

 private:
  void add(const std::vector<Vec2>& ring) {
    loops_.emplace_back();
    for (const Vec2& p : ring) {
      loops_.back().push_back(points.size());
      points.push_back(p);
    }
  }

  double rightmost(const std::vector<std::size_t>& loop) const {
    double out = -std::numeric_limits<double>::infinity();
    for (const std::size_t i : loop) out = std::max(out, points[i].x());
    return out;
  }

  bool sees(const Vec2& a, const Vec2& b, const std::vector<std::size_t>& loop) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (cross(a, b, points[loop[i]], points[loop[(i + 1) % loop.size()]])) return false;
    }
    return true;
  }

  // From the hole's rightmost corner to the nearest of the ring that no edge hides; where all are
  // hidden, to the nearest of all.
  void join(const std::vector<std::size_t>& hole) {
    const std::size_t from =
        static_cast<std::size_t>(std::max_element(hole.begin(), hole.end(),
                                                  [&](std::size_t a, std::size_t b) {
                                                    return points[a].x() < points[b].x();
                                                  }) -
                                 hole.begin());
    const Vec2& start = points[hole[from]];
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      near.emplace_back((points[ring_[i]] - start).squaredNorm(), i);
    }
    std::sort(near.begin(), near.end());
    std::size_t to = near.front().second;
    for (const auto& [squared, i] : near) {
      const Vec2& end = points[ring_[i]];
      const bool hidden = !sees(start, end, ring_) || !sees(start, end, hole) ||
                          std::any_of(loops_.begin(), loops_.end(),
                                      [&](const auto& l) { return !sees(start, end, l); });
      if (hidden || !opens(i, start)) continue;
      to = i;
      break;
    }
    std::vector<std::size_t> joined(ring_.begin(),
                                    ring_.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    for (std::size_t i = 0; i <= hole.size(); ++i) joined.push_back(hole[(from + i) % hole.size()]);
    joined.insert(joined.end(), ring_.begin() + static_cast<std::ptrdiff_t>(to), ring_.end());
    ring_ = std::move(joined);
  }

  // Whether the inside of the ring at its corner i is where p is.
  bool opens(std::size_t i, const Vec2& p) const {
    const std::size_t n = ring_.size();
    const Vec2& a = points[ring_[(i + n - 1) % n]];
    const Vec2& b = points[ring_[i]];
    const Vec2& c = points[ring_[(i + 1) % n]];
    if (turn(a, b, c) > 0) return turn(a, b, p) >= 0 && turn(b, c, p) >= 0;
    return turn(a, b, p) >= 0 || turn(b, c, p) >= 0;
  }

  std::vector<std::size_t> ring_;
  std::vector<std::vector<std::size_t>> loops_;  // holes that are not joined yet
};

// Pieces that grow by taking in their neighbours across the diagonals.
class Pieces {
 public:
  Pieces(const std::vector<Vec2>& points, const std::vector<Triangle>& triangles)
      : points_(points) {
    for (const Triangle& t : triangles) {
      std::vector<std::size_t> ring(t.begin(), t.end());
      if (turn(points[t[0]], points[t[1]], points[t[2]]) < 0)
        std::reverse(ring.begin(), ring.end());
      rings_.push_back(std::move(ring));
      own(rings_.size() - 1);
    }
  }

  std::vector<std::vector<Vec2>> merged() {
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      bool grown = !rings_[i].empty();
      while (grown) {
        grown = false;
        for (std::size_t k = 0; k < rings_[i].size() && !grown; ++k) grown = take(i, k);
      }
    }
    std::vector<std::vector<Vec2>> out;
    for (const auto& ring : rings_) {
      if (ring.empty()) continue;
      out.emplace_back();
      for (const std::size_t p : ring) out.back().push_back(points_[p]);
    }
    return out;
  }

 private:
  void own(std::size_t piece) {
    const auto& ring = rings_[piece];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      owner_[{ring[k], ring[(k + 1) % ring.size()]}] = piece;
    }
  }

  // Takes in the piece beyond edge k where both are convex together.
  bool take(std::size_t piece, std::size_t k) {
    const auto& ring = rings_[piece];
    const std::size_t a = ring[k];
    const std::size_t b = ring[(k + 1) % ring.size()];
    const auto at = owner_.find({b, a});
    if (at == owner_.end() || at->second == piece) return false;
    const auto& other = rings_[at->second];
    const auto found = std::find(other.begin(), other.end(), a);
    const std::size_t begin = static_cast<std::size_t>(found - other.begin());
    if (found == other.end() || other[(begin + other.size() - 1) % other.size()] != b) return false;
    std::vector<std::size_t> joined;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      joined.push_back(ring[i]);
      if (i != k) continue;
      for (std::size_t j = 1; j + 1 < other.size(); ++j) {
        joined.push_back(other[(begin + j) % other.size()]);
      }
    }
    if (!is_convex(joined)) return false;
    rings_[at->second].clear();
    rings_[piece] = std::move(joined);
    own(piece);
    return true;
  }

  bool is_convex(const std::vector<std::size_t>& ring) const {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (turn(points_[ring[i]], points_[ring[(i + 1) % n]], points_[ring[(i + 2) % n]]) < 0) {
        return false;
      }
    }
    return true;
  }

  const std::vector<Vec2>& points_;
  std::vector<std::vector<std::size_t>> rings_;  // empty: taken in by another
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> owner_;
};

}  // namespace

std::vector<std::vector<Vec2>> convex_parts(const Polygon& polygon) {
  if (polygon.outer.empty()) return {};
  const Bridges bridges(polygon);
  if (bridges.ring().size() < 3) {
    std::vector<Vec2> spur;
    for (const std::size_t i : bridges.ring()) spur.push_back(bridges.points[i]);
    return {spur};
  }
  return Pieces(bridges.points, Ears(bridges.points, bridges.ring()).cut()).merged();
}

}  // namespace geom
