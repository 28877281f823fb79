#include "convex_edges.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "roadmap/uncovered.h"

namespace plan {
namespace {

using geom::Aabb;

// Whether the box holds what is just beside `at` on the side of `sign`.
bool beside(double min, double max, double at, int sign) {
  return sign > 0 ? min <= at && at < max : min < at && at <= max;
}

class Finder {
 public:
  explicit Finder(const geom::CollisionScene& scene)
      : scene_(scene), bounds_(*scene.free_bounds()) {}

  std::vector<EdgePart> found() {
    for (std::size_t i = 0; i < scene_.map().size(); ++i) {
      const Aabb box = scene_.grown(i);
      if (geom::overlap(box, bounds_) && !inside_another(i, box)) add_box(i, box);
    }
    add_corners();
    return std::move(out_);
  }

 private:
  bool inside_another(std::size_t i, const Aabb& box) const {
    for (const std::size_t other : scene_.boxes_meeting({box.min, box.min})) {
      if (other == i) continue;
      const Aabb o = scene_.grown(other);
      if (geom::contains(o, box.max) && (o != box || other < i)) return true;
    }
    return false;
  }

  void add_box(std::size_t i, const Aabb& box) {
    for (std::uint8_t k = 0; k < 3; ++k) {
      for (int corner = 0; corner < 4; ++corner) {
        add_edge(i, box, k,
                 {static_cast<std::int8_t>(corner & 1 ? 1 : -1),
                  static_cast<std::int8_t>(corner & 2 ? 1 : -1)});
      }
    }
  }

  void add_edge(std::size_t i, const Aabb& box, std::uint8_t k,
                std::array<std::int8_t, 2> outward) {
    const int i1 = (k + 1) % 3;
    const int i2 = (k + 2) % 3;
    Vec3 a;
    a[i1] = outward[0] > 0 ? box.max[i1] : box.min[i1];
    a[i2] = outward[1] > 0 ? box.max[i2] : box.min[i2];
    if (!(bounds_.min[i1] < a[i1] && a[i1] < bounds_.max[i1]) ||
        !(bounds_.min[i2] < a[i2] && a[i2] < bounds_.max[i2])) {
      return;
    }
    Vec3 b = a;
    a[k] = std::max(box.min[k], bounds_.min[k]);
    b[k] = std::min(box.max[k], bounds_.max[k]);
    if (!(a[k] < b[k])) return;
    corners_.push_back(a);
    corners_.push_back(b);
    std::vector<Interval> covered;
    for (const std::size_t other : scene_.boxes_meeting({a, b})) {
      if (other == i) continue;
      const Aabb o = scene_.grown(other);
      for (const double end : {o.min[k], o.max[k]}) {
        if (!(a[k] < end && end < b[k])) continue;
        corners_.push_back(a);
        corners_.back()[k] = end;
      }
      for (const int side : {0, 1}) {
        if (beside(o.min[i1], o.max[i1], a[i1], side ? -outward[0] : outward[0]) &&
            beside(o.min[i2], o.max[i2], a[i2], side ? outward[1] : -outward[1])) {
          covered.push_back({o.min[k], o.max[k]});
        }
      }
    }
    for (const auto& [low, high] : uncovered(a[k], b[k], std::move(covered))) {
      EdgePart part{a, a, k, outward};
      part.low[k] = low;
      part.high[k] = high;
      out_.push_back(part);
    }
  }

  unsigned octants(const Vec3& p) const {
    unsigned out = 0;
    const auto meeting = scene_.boxes_meeting({p, p});
    for (unsigned octant = 0; octant < 8; ++octant) {
      const int sign[3] = {octant & 4 ? 1 : -1, octant & 2 ? 1 : -1, octant & 1 ? 1 : -1};
      const auto in = [&](const Aabb& box) {
        return beside(box.min[0], box.max[0], p[0], sign[0]) &&
               beside(box.min[1], box.max[1], p[1], sign[1]) &&
               beside(box.min[2], box.max[2], p[2], sign[2]);
      };
      const bool blocked = !in(bounds_) || std::any_of(meeting.begin(), meeting.end(),
                                                       [&](auto i) { return in(scene_.grown(i)); });
      out |= static_cast<unsigned>(blocked) << octant;
    }
    return out;
  }

  void add_corners() {
    const auto place = [](const Vec3& p) { return std::tie(p[0], p[1], p[2]); };
    std::sort(corners_.begin(), corners_.end(),
              [&](const Vec3& a, const Vec3& b) { return place(a) < place(b); });
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    for (const Vec3& p : corners_) {
      if (!plain(octants(p))) out_.push_back({p, p, kCorner, {}});
    }
  }

  const geom::CollisionScene& scene_;
  const Aabb bounds_;
  std::vector<EdgePart> out_;
  std::vector<Vec3> corners_;
};

}  // namespace

bool plain(unsigned octants) {
  if (octants == 0 || octants == 255 || (octants & (octants - 1)) == 0) return true;
  constexpr unsigned kHigh[] = {0xf0, 0xcc, 0xaa};  // octants of larger x, y, z
  constexpr int kStep[] = {4, 2, 1};
  for (int k = 0; k < 3; ++k) {
    const unsigned high = (octants & kHigh[k]) >> kStep[k];
    const unsigned low = octants & (255 & ~kHigh[k]);
    const unsigned all = 255 & ~kHigh[k];
    if (high == low || high == all || low == all) return true;
  }
  return false;
}

std::vector<EdgePart> convex_edges(const geom::CollisionScene& scene) {
  return Finder(scene).found();
}

void cut(const EdgePart& edge, std::size_t parts, std::vector<EdgePart>& out) {
  if (edge.is_corner() || parts == 1) {
    out.push_back(edge);
    return;
  }
  EdgePart part = edge;
  const double length = edge.length();
  for (std::size_t n = 1; n <= parts; ++n) {
    double to = edge.high[edge.axis];
    if (n < parts) {
      to = edge.low[edge.axis] + length * (static_cast<double>(n) / static_cast<double>(parts));
      to = std::clamp(to, part.low[edge.axis], edge.high[edge.axis]);
    }
    part.high[edge.axis] = to;
    out.push_back(part);
    part.low[edge.axis] = to;
  }
}

std::vector<EdgePart> parts_of(const std::vector<EdgePart>& edges, double most) {
  std::vector<EdgePart> out;
  for (const EdgePart& edge : edges) {
    cut(edge, static_cast<std::size_t>(std::max(1.0, std::ceil(edge.length() / most))), out);
  }
  return out;
}

}  // namespace plan
