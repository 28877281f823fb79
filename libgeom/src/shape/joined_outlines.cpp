#include "geom/shape/joined_outlines.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace geom {
namespace {

struct Node {  // of the grid
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Node&, const Node&) = default;
};

// A bit for each square of a rectangle, with an empty one around it.
class Squares {
 public:
  Squares(std::int64_t columns, std::int64_t rows)
      : words_((columns + 2 + 63) / 64), bits_(static_cast<std::size_t>(words_ * (rows + 2))) {}

  bool at(std::int64_t x, std::int64_t y) const { return bits_[word(x, y)] >> ((x + 1) & 63) & 1; }
  void set(std::int64_t x, std::int64_t y) {
    bits_[word(x, y)] |= std::uint64_t{1} << ((x + 1) & 63);
  }
  void set_row(std::int64_t from, std::int64_t to, std::int64_t y) {
    for (std::int64_t x = from; x < to;) {
      if (((x + 1) & 63) == 0 && to - x >= 64) {
        bits_[word(x, y)] = ~std::uint64_t{0};
        x += 64;
      } else {
        set(x++, y);
      }
    }
  }

 private:
  std::size_t word(std::int64_t x, std::int64_t y) const {
    return static_cast<std::size_t>((y + 1) * words_ + ((x + 1) >> 6));
  }
  std::int64_t words_;
  std::vector<std::uint64_t> bits_;
};

// Walks along the edges of squares that are set, which lie to the left.
class Walk {
 public:
  Walk(const Squares& squares, std::int64_t columns, std::int64_t rows)
      : squares_(squares), columns_(columns), rows_(rows), walked_(columns, rows) {}

  std::vector<std::vector<Node>> rings() {
    std::vector<std::vector<Node>> out;
    for (std::int64_t y = 0; y < rows_; ++y) {
      for (std::int64_t x = 0; x < columns_; ++x) {
        if (squares_.at(x, y) && !squares_.at(x, y - 1) && !walked_.at(x, y)) {
          out.push_back(ring_from({x, y}));
        }
      }
    }
    return out;
  }

 private:
  // Directions: 0 east, 1 north, 2 west, 3 south.
  static constexpr std::array<Node, 4> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  // The square ahead to the left and to the right of one who stands on a node.
  static constexpr std::array<Node, 4> kLeft = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  static constexpr std::array<Node, 4> kRight = {{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};

  bool set(const Node& at, const Node& side) const {
    return squares_.at(at.x + side.x, at.y + side.y);
  }

  // The corners of the ring that begins with the lower edge of this square.
  std::vector<Node> ring_from(const Node& first) {
    std::vector<Node> corners{first};
    Node at = first;
    std::size_t way = 0;
    do {
      if (way == 0) walked_.set(at.x, at.y);
      at = {at.x + kStep[way].x, at.y + kStep[way].y};
      const std::size_t before = way;
      if (set(at, kRight[way])) {
        way = (way + 3) % 4;
      } else if (!set(at, kLeft[way])) {
        way = (way + 1) % 4;
      }
      if (way != before) corners.push_back(at);
    } while (!(at == first && way == 0));
    if (corners.size() > 1 && corners.back() == first) corners.pop_back();
    return corners;
  }

  const Squares& squares_;
  std::int64_t columns_;
  std::int64_t rows_;
  Squares walked_;  // whose lower edges were walked along
};

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length = d.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(d) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

// Which points between `from` and `to` are kept (Douglas and Peucker, 1973).
void keep_between(const std::vector<Vec2>& ring, std::size_t from, std::size_t to, double tolerance,
                  std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{from, to}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t farthest = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double away = distance(ring[i], ring[a], ring[b % ring.size()]);
      if (away > most) most = away, farthest = i;
    }
    if (farthest == a) continue;
    kept[farthest] = true;
    open.emplace_back(a, farthest);
    open.emplace_back(farthest, b);
  }
}

std::vector<Vec2> simplified(const std::vector<Vec2>& ring, double tolerance) {
  std::size_t opposite = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if ((ring[i] - ring[0]).squaredNorm() > (ring[opposite] - ring[0]).squaredNorm()) opposite = i;
  }
  std::vector<bool> kept(ring.size());
  kept[0] = kept[opposite] = true;
  keep_between(ring, 0, opposite, tolerance, kept);
  keep_between(ring, opposite, ring.size(), tolerance, kept);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (kept[i]) out.push_back(ring[i]);
  }
  return out.size() < 3 ? ring : out;
}

}  // namespace

std::vector<std::vector<Vec2>> joined_outlines(std::span<const Aabb> boxes,
                                               const OutlineDetail& detail) {
  if (boxes.empty()) return {};
  // Outward, but by three quarters of a square at most, so that boxes that touch to rounding meet.
  const auto lower = [&](double at) {
    return static_cast<std::int64_t>(std::floor(at / detail.grid + 0.25));
  };
  const auto upper = [&](double at) {
    return static_cast<std::int64_t>(std::ceil(at / detail.grid - 0.25));
  };
  Node low{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max()};
  Node high{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min()};
  for (const Aabb& box : boxes) {
    low = {std::min(low.x, lower(box.min.x())), std::min(low.y, lower(box.min.y()))};
    high = {std::max({high.x, upper(box.max.x()), lower(box.min.x()) + 1}),
            std::max({high.y, upper(box.max.y()), lower(box.min.y()) + 1})};
  }
  const std::int64_t columns = high.x - low.x;
  const std::int64_t rows = high.y - low.y;
  assert(columns <= (std::int64_t{1} << 34) / rows);
  Squares squares(columns, rows);
  for (const Aabb& box : boxes) {
    const std::int64_t left = lower(box.min.x()) - low.x;
    const std::int64_t right = std::max(left + 1, upper(box.max.x()) - low.x);
    const std::int64_t bottom = lower(box.min.y()) - low.y;
    const std::int64_t top = std::max(bottom + 1, upper(box.max.y()) - low.y);
    for (std::int64_t y = bottom; y < top; ++y) squares.set_row(left, right, y);
  }
  std::vector<std::vector<Vec2>> out;
  for (const std::vector<Node>& corners : Walk(squares, columns, rows).rings()) {
    std::vector<Vec2> ring;
    for (const Node& c : corners) {
      ring.push_back(detail.grid *
                     Vec2(static_cast<double>(c.x + low.x), static_cast<double>(c.y + low.y)));
    }
    out.push_back(simplified(ring, detail.tolerance));
  }
  return out;
}

}  // namespace geom
