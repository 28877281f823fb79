#include "few_rectangles.h"

#include <algorithm>
#include <cmath>

#include "cover_edge.h"

namespace geom {
namespace {

bool is_convex(const std::vector<Vec2>& ring) {
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& b = ring[(i + 1) % ring.size()];
    const int turn = orientation(ring[i].x(), ring[i].y(), b.x(), b.y(),
                                 ring[(i + 2) % ring.size()].x(), ring[(i + 2) % ring.size()].y());
    ++(turn > 0 ? left : right);
    if (turn == 0) return false;
  }
  return left == 0 || right == 0;
}

// Whether the corners of a rectangle are within the slack of a convex ring, to which the distance
// is largest at one of them.
bool corners_near(const std::vector<Vec2>& ring, const Rectangle& r, double slack) {
  const double size = r.min.cwiseAbs().cwiseMax(r.max.cwiseAbs()).maxCoeff();
  const double surely = slack - 4e-9 - 1e-14 * size;  // more than distances are rounded
  for (int i = 0; i < 4; ++i) {
    const Vec2 p(i % 2 ? r.max.x() : r.min.x(), i / 2 ? r.max.y() : r.min.y());
    bool near = false;
    for (std::size_t k = 0; k < ring.size() && !near; ++k) {
      const Vec2& a = ring[k];
      const Vec2 step = ring[k + 1 < ring.size() ? k + 1 : 0] - a;
      const double t = std::clamp((p - a).dot(step) / step.squaredNorm(), 0.0, 1.0);
      near = (a + t * step - p).norm() <= surely;
    }
    if (!near) return false;
  }
  return true;
}

}  // namespace

// Each edge lies within a frame inside of its sides: one that is rather level by the lower side or
// the upper, others by the left or the right. So no edge enters what the frame leaves free, which
// lies inside the polygon as its middle does, and no corner of the rectangle is further from it
// than the frame is wide. Of a convex quadrilateral with a frame that is not much wider, the
// corners themselves tell.
std::optional<Rectangle> one_rectangle(const Polygon& polygon, double slack) {
  const std::vector<Vec2>& ring = polygon.outer;
  if (ring.size() < 3 || !polygon.holes.empty()) return std::nullopt;
  Vec2 low = ring.front();
  Vec2 high = low;
  for (const Vec2& p : ring) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Vec2 frame = Vec2::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (a == b) continue;
    const int axis = std::abs(b.x() - a.x()) >= std::abs(b.y() - a.y()) ? 1 : 0;
    const double aside =
        std::min(std::max(a[axis], b[axis]) - low[axis], high[axis] - std::min(a[axis], b[axis]));
    frame[axis] = std::max(frame[axis], aside);
  }
  const Rectangle out{{outward(low.x(), -1), outward(low.y(), -1)},
                      {outward(high.x(), 1), outward(high.y(), 1)}};
  // What sides are rounded by, and more than sums are.
  frame += 2 * (low - out.min).cwiseMax(out.max - high);
  if (!(2 * frame.x() < high.x() - low.x()) || !(2 * frame.y() < high.y() - low.y())) {
    return std::nullopt;
  }
  if (frame.norm() <= slack) {
    if (contains(polygon, 0.5 * (low + high))) return out;
  } else if (ring.size() == 4 && frame.maxCoeff() <= 1.1 * slack && is_convex(ring) &&
             corners_near(ring, out, slack)) {
    return out;
  }
  return std::nullopt;
}

namespace {

// What of a convex ring has x between the two, which both cross it or bound it.
std::vector<Vec2> stretch(const std::vector<Vec2>& ring, double from, double to) {
  std::vector<Vec2> out;
  out.reserve(ring.size() + 4);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (a.x() >= from && a.x() <= to) out.push_back(a);
    const auto cross = [&](double x) {
      if ((a.x() < x && b.x() > x) || (a.x() > x && b.x() < x)) {
        out.push_back({x, a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y())});
      }
    };
    cross(a.x() < b.x() ? from : to);
    cross(a.x() < b.x() ? to : from);
  }
  return out;
}

// Of a convex quadrilateral along x, pieces of one length that are a rectangle each; none where a
// few more than its sides lean by are not enough.
std::vector<Rectangle> pieces_along_x(const Polygon& polygon, double slack) {
  const std::vector<Vec2>& ring = polygon.outer;
  double from = ring[0].x();
  double to = from;
  double lean = 0;  // of the longer sides
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 side = (ring[(i + 1) % ring.size()] - ring[i]).cwiseAbs();
    from = std::min(from, ring[i].x());
    to = std::max(to, ring[i].x());
    if (side.x() > side.y()) lean = std::max(lean, side.y());
  }
  constexpr double kMostPieces = 1e5;
  const double least = std::max(2.0, std::ceil(lean / slack));
  std::vector<Rectangle> out;
  for (double count = least; count <= std::min(least + 2, kMostPieces); ++count) {
    out.clear();
    double begin = from;
    for (double i = 1; i <= count; ++i) {
      const double end = i < count ? from + i / count * (to - from) : to;
      const auto one = one_rectangle({stretch(ring, begin, end), {}}, slack);
      if (!one) break;
      out.push_back(*one);
      begin = end;
    }
    if (static_cast<double>(out.size()) == count) return out;
  }
  return {};
}

}  // namespace

std::vector<Rectangle> long_pieces(const Polygon& polygon, const Polygon& turned, double slack) {
  const std::vector<Vec2>& ring = polygon.outer;
  if (ring.size() != 4 || !polygon.holes.empty() || !is_convex(ring)) return {};
  const Vec2 sides = (ring[0] - ring[1]).cwiseAbs() + (ring[1] - ring[2]).cwiseAbs();
  if (sides.x() >= sides.y()) return pieces_along_x(polygon, slack);
  std::vector<Rectangle> out = pieces_along_x(turned, slack);
  for (Rectangle& r : out) {
    std::swap(r.min.x(), r.min.y());
    std::swap(r.max.x(), r.max.y());
  }
  return out;
}

}  // namespace geom
