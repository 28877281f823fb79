// roof_check FILE SLACK N [MOVED]: what the boxes of a city model's surfaces promise. N random
// points of the surfaces, and as many below them, must lie in boxes, in rational numbers; and of
// each box there is a proof that it reaches no further than the slack from what its object's
// surfaces make solid, nor from any surface that the corners may span where they lie in no plane.
// With MOVED, boxes are moved by so many metres before that, which must be seen.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

#include "geom/base/parallel.h"
#include "map/plane_fit.h"
#include "support/cover_oracle.h"
#include "support/exact_cover.h"
#include "support/exactly_held.h"
#include "support/projected_city.h"
#include "support/random_city.h"
#include "support/triangle_oracle.h"

namespace {

using geom::Aabb;
using geom::Footprint;
using geom::Vec2;
using geom::Vec3;
using oracle::ExactVec3;
using oracle::Q;
using oracle::Wide;

constexpr int kWhole = 1 << 20;
constexpr double kRounded = 1e-6;  // metres: what covers may reach further by rounding outward

using Ring = std::vector<Vec3>;

// The rings with their heights, the outer one first.
std::vector<Ring> rings_of(const Footprint& f) {
  std::vector<Ring> out;
  std::size_t next = 0;
  const auto add = [&](const std::vector<Vec2>& ring) {
    out.emplace_back();
    for (const Vec2& p : ring) {
      out.back().push_back({p.x(), p.y(), f.heights.empty() ? f.top : f.heights[next++]});
    }
  };
  add(f.polygon.outer);
  for (const auto& hole : f.polygon.holes) add(hole);
  return out;
}

// Newell's, twice as long as the area.
Vec3 normal_of(const Ring& ring) {
  Vec3 n = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    n += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
  }
  return n;
}

// A surface as one draws it: seen along the axis that it faces most.
class Surface {
 public:
  explicit Surface(const Footprint& f) : rings_(rings_of(f)) {
    const Vec3 normal = normal_of(rings_[0]);
    area_ = normal.norm() / 2;
    normal.cwiseAbs().maxCoeff(&axis_);
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      auto& ring = r == 0 ? drawn_.outer : drawn_.holes.emplace_back();
      for (const Vec3& p : rings_[r]) ring.push_back({p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]});
    }
  }

  double area() const { return area_; }

  // A point on triangles that its corners span; within its drawn outline, so none of a hole.
  ExactVec3 point(support::Random& random) const {
    const Ring& ring = rings_[0];
    const auto count = static_cast<int>(ring.size());
    for (int attempt = 0; attempt < 1000 && count >= 3; ++attempt) {
      const int apex = random.below(count);
      const int side = 1 + random.below(count - 2);
      const auto corner = [&](int i) { return ring[static_cast<std::size_t>((apex + i) % count)]; };
      int a = random.below(kWhole + 1);
      int b = random.below(kWhole + 1);
      if (a > b) std::swap(a, b);
      const ExactVec3 p =
          oracle::weighted({corner(0), corner(side), corner(side + 1)}, {a, b - a, kWhole - b});
      const auto at = [&](int i) { return p[static_cast<std::size_t>((axis_ + i) % 3)]; };
      if (oracle::exactly_inside(drawn_, {at(1), at(2)})) return p;
    }
    const int i = random.below(count);  // of slivers: on an edge, which is the surface's own
    const int a = random.below(kWhole + 1);
    const Vec3& from = ring[static_cast<std::size_t>(i)];
    return oracle::weighted({from, ring[static_cast<std::size_t>((i + 1) % count)], from},
                            {a, kWhole - a, 0});
  }

 private:
  std::vector<Ring> rings_;
  double area_ = 0;
  int axis_ = 2;
  geom::Polygon drawn_;
};

// What one surface makes solid, at the least: all below the lowest surface that its corners span,
// and below its edges, down to the bottom.
class Solid {
 public:
  Solid(const Footprint& f, double slack)
      : footprint_(f),
        inside_(f.polygon),
        low_(Vec3::Constant(1e30)),
        high_(Vec3::Constant(-1e30)) {
    plane_.base = plane_.low = f.top;
    if (!f.heights.empty()) {
      plane_ = geom::fit_plane(geom::corners_of(f));
      thin_ = geom::is_upright(plane_, slack);
      further_ = thin_ ? 0 : std::max(0.0, 2 * plane_.residual - slack / 2);
    }
    for (const Ring& ring : rings_of(f)) {
      for (std::size_t i = 0; i < ring.size(); ++i) add_below(ring[i], ring[(i + 1) % ring.size()]);
    }
  }

  // The largest distance of a corner from the plane, beyond what it says.
  double plane_error() const {
    double most = 0;
    if (thin_ || footprint_.heights.empty()) return most;
    for (const Ring& ring : rings_of(footprint_)) {
      for (const Vec3& p : ring) {
        most = std::max(most, std::abs(p.z() - plane_(p.head<2>())) - plane_.residual);
      }
    }
    return most;
  }

  bool may_be_near(const Aabb& box, double reach) const {
    const Vec3 more = Vec3::Constant(reach + further_);
    return (box.min.array() <= (high_ + more).array()).all() &&
           (box.max.array() >= (low_ - more).array()).all();
  }

  // Metres that a box may be beyond the slack where the corners lie in no plane.
  double further() const { return further_; }

  long double distance(const Wide& p) const {
    long double least = 1e30L;
    for (const Side& side : sides_) least = std::min(least, to_side(p, side));
    if (thin_) return least;
    if (inside_.signed_at(p.x(), p.y()) <= 0) {
      const long double above = p.z() - height(p.x(), p.y());
      if (p.z() < bottom()) return std::min(least, bottom() - p.z());
      if (above <= 0) return 0;
      least = std::min(least, above);
    }
    return std::min(least, to_top(p));
  }

  // Whether all corners of the box are within `reach` of one convex part of it: what is below an
  // edge, or below the plane, or level, over a rectangle that no edge crosses.
  bool has_convex_part_within(const Aabb& box, long double reach) const {
    std::array<Wide, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
      corners[i] = Wide((i & 1 ? box.max : box.min).x(), (i & 2 ? box.max : box.min).y(),
                        (i & 4 ? box.max : box.min).z());
    }
    for (const Side& side : sides_) {
      if (std::ranges::all_of(corners, [&](const Wide& c) { return to_side(c, side) <= reach; })) {
        return true;
      }
    }
    return !thin_ && (is_within(corners, reach, false) || is_within(corners, reach, true));
  }

 private:
  using Side = std::array<oracle::WideTriangle, 2>;  // an upright one, down to the bottom
  using Plan = Eigen::Matrix<long double, 2, 1>;

  static long double to_side(const Wide& p, const Side& side) {
    return std::min(oracle::distance(p, side[0]), oracle::distance(p, side[1]));
  }

  // By the feet of the corners on the plane, or on the level of the lowest corner.
  bool is_within(const std::array<Wide, 8>& corners, long double reach, bool level) const {
    Plan low = Plan::Constant(1e30L);
    Plan high = -low;
    for (const Wide& c : corners) {
      Wide foot = c;
      const long double above = c.z() - (level ? plane_.low : lowest(c.x(), c.y()));
      if (above > 0) {
        const Wide up(level ? 0 : -plane_.gradient.x(), level ? 0 : -plane_.gradient.y(), 1);
        foot -= above / up.squaredNorm() * up;
      }
      foot.z() = std::max(foot.z(), bottom());  // of a corner below the bottom
      if (foot.z() > (level ? plane_.low : lowest(foot.x(), foot.y())) + 1e-12L) return false;
      if ((foot - c).norm() > reach) return false;
      low = low.cwiseMin(foot.head<2>());
      high = high.cwiseMax(foot.head<2>());
    }
    const Plan middle = (low + high) / 2;
    return inside_.signed_at(middle.x(), middle.y()) <= 0 && !is_crossed(low, high);
  }

  // Whether an edge enters the open rectangle.
  bool is_crossed(const Plan& low, const Plan& high) const {
    return std::ranges::any_of(sides_, [&](const Side& side) {
      const Plan a = side[0][0].head<2>();
      const Plan step = side[0][1].head<2>() - a;
      long double first = 0;
      long double last = 1;
      for (int i = 0; i < 2; ++i) {
        if (step[i] == 0) {
          if (a[i] <= low[i] || a[i] >= high[i]) return false;
          continue;
        }
        const long double u = (low[i] - a[i]) / step[i];
        const long double v = (high[i] - a[i]) / step[i];
        first = std::max(first, std::min(u, v));
        last = std::min(last, std::max(u, v));
      }
      return first < last;
    });
  }

  long double bottom() const { return footprint_.bottom; }

  // No surface that the corners span is lower than the lowest of them either.
  long double height(long double x, long double y) const {
    return std::max<long double>(lowest(x, y), plane_.low);
  }
  long double lowest(long double x, long double y) const {
    return plane_.base + plane_.gradient.x() * (x - plane_.centre.x()) +
           plane_.gradient.y() * (y - plane_.centre.y()) - plane_.residual;
  }

  // To the foot on the lowest surface, where that is over the polygon and not below the bottom.
  long double to_top(const Wide& p) const {
    const Wide up(-plane_.gradient.x(), -plane_.gradient.y(), 1);
    const long double away = (p.z() - lowest(p.x(), p.y())) / up.squaredNorm();
    const Wide foot = p - away * up;
    if (foot.z() < bottom() || inside_.signed_at(foot.x(), foot.y()) > 0) return 1e30L;
    return std::abs(away) * up.norm();
  }

  void add_below(const Vec3& a, const Vec3& b) {
    const double down = footprint_.bottom;
    const Wide from = a.cast<long double>();
    const Wide to = b.cast<long double>();
    const Wide under_from(from.x(), from.y(), down);
    const Wide under_to(to.x(), to.y(), down);
    sides_.push_back(Side{oracle::WideTriangle{from, to, under_to},
                          oracle::WideTriangle{from, under_to, under_from}});
    for (const Vec3& p : {a, b, Vec3(a.x(), a.y(), down)}) {
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    }
  }

  const Footprint& footprint_;
  oracle::Distance inside_;
  geom::PlaneFit plane_;
  bool thin_ = false;
  double further_ = 0;
  std::vector<Side> sides_;
  Vec3 low_;
  Vec3 high_;
};

// Whether no point of the box is further from all of them than `reach`. Distance grows no faster
// than one goes, and that to what is convex is largest at a corner: a piece of which one of these
// says so is proved as a whole. `most` halvings.
bool all_within(const std::vector<const Solid*>& solids, const Aabb& box, double reach,
                int most = 60) {
  const Wide middle = (box.min.cast<long double>() + box.max.cast<long double>()) / 2;
  const long double half = (box.max - box.min).cast<long double>().norm() / 2;
  long double away = 1e30L;
  for (const Solid* s : solids) away = std::min(away, s->distance(middle) - s->further());
  if (away + half <= reach) return true;
  if (away > reach || most == 0) return false;
  for (const Solid* s : solids) {
    if (s->has_convex_part_within(box, reach + s->further())) return true;
  }
  int axis = 0;
  (box.max - box.min).maxCoeff(&axis);
  Aabb low = box;
  Aabb high = box;
  low.max[axis] = high.min[axis] = 0.5 * (box.min[axis] + box.max[axis]);
  return all_within(solids, low, reach, most - 1) && all_within(solids, high, reach, most - 1);
}

struct Object {
  std::vector<const Footprint*> surfaces;
  std::vector<Aabb> boxes;
};

std::map<std::uint64_t, Object> objects_of(const std::vector<Footprint>& footprints,
                                           const geom::BoxTable& table) {
  std::map<std::uint64_t, Object> out;
  for (const Footprint& f : footprints) out[f.id].surfaces.push_back(&f);
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    out.at(table.ids[i]).boxes.push_back(table.boxes[i]);
  }
  return out;
}

struct Tally {
  std::size_t points = 0;
  std::size_t outside = 0;
  std::size_t below = 0;  // those under them that are outside
};

// Points of one object's surfaces, by their areas; at least one of each.
Tally sample(const Object& object, double points_a_metre, std::uint64_t seed) {
  const oracle::ExactlyHeld held(object.boxes);
  support::Random random(seed);
  Tally tally;
  for (const Footprint* f : object.surfaces) {
    const Surface surface(*f);
    const double count = std::max(1.0, surface.area() * points_a_metre);
    for (double k = random.uniform(0, 1); k < count; ++k) {
      const ExactVec3 p = surface.point(random);
      const Q share = Q(random.below(kWhole + 1)) / Q(kWhole);
      const ExactVec3 under{p[0], p[1], p[2] + (Q(f->bottom) - p[2]) * share};
      ++tally.points;
      tally.outside += !held(p);
      tally.below += !held(under);
    }
  }
  return tally;
}

std::size_t boxes_too_far(const Object& object, double slack, double& plane_error) {
  std::vector<Solid> solids;
  for (const Footprint* f : object.surfaces) {
    solids.emplace_back(*f, slack);
    plane_error = std::max(plane_error, solids.back().plane_error());
  }
  std::size_t far = 0;
  for (const Aabb& box : object.boxes) {
    std::vector<const Solid*> near;
    for (const Solid& s : solids) {
      if (s.may_be_near(box, slack)) near.push_back(&s);
    }
    far += !all_within(near, box, slack + kRounded);
  }
  return far;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "roof_check MODEL SLACK [POINTS [MOVED]]\n");
    return 2;
  }
  const double slack = std::atof(argv[2]);
  const double wanted = argc > 3 ? std::atof(argv[3]) : 1e6;
  const std::vector<Footprint> footprints = support::projected_city(argv[1], slack);
  geom::BoxTable table = geom::boxes_of(footprints, slack, {2, {}});
  const Vec3 moved = Vec3::Constant(argc > 4 ? std::atof(argv[4]) : 0);
  for (Aabb& box : table.boxes) box = {box.min + moved, box.max + moved};
  const std::map<std::uint64_t, Object> objects = objects_of(footprints, table);
  std::vector<const Object*> all;
  for (const auto& [id, object] : objects) all.push_back(&object);
  double area = 0;
  double uneven = 0;
  std::size_t sloping = 0;
  for (const Footprint& f : footprints) {
    area += Surface(f).area();
    uneven = std::max(uneven, geom::uneven_by(f, slack));
    sloping += !f.heights.empty();
  }
  std::vector<Tally> tallies(all.size());
  std::vector<std::size_t> far(all.size());
  std::vector<double> error(all.size());
  geom::parallel_for(all.size(), {2, {}}, [&](std::size_t i) {
    tallies[i] = sample(*all[i], wanted / area, i + 1);
    far[i] = boxes_too_far(*all[i], slack, error[i]);
  });
  Tally sum;
  for (const Tally& t : tallies) {
    sum = {sum.points + t.points, sum.outside + t.outside, sum.below + t.below};
  }
  const std::size_t too_far = std::reduce(far.begin(), far.end());
  const double plane_error = *std::max_element(error.begin(), error.end());
  fmt::print("{} objects, {} surfaces ({} not level, uneven by {:.3g} m), {} boxes\n", all.size(),
             footprints.size(), sloping, uneven, table.boxes.size());
  fmt::print("of {} points outside the boxes: {}; of as many below them: {}\n", sum.points,
             sum.outside, sum.below);
  fmt::print("boxes beyond the slack of {} m: {}; planes beside their corners by {:.2g} m more\n",
             slack, too_far, plane_error);
  return sum.outside + sum.below + too_far > 0 || plane_error > kRounded;
}
