// cover_check FILE SLACK N: what the boxes of a city's footprints promise. N random points inside
// the level polygons, their corners and the middles of their edges must lie in boxes; no box may
// reach further than the slack outside its polygon; the former is also proved in rationals.

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>
#include <map>

#include "geom/base/parallel.h"
#include "geom/shape/cover.h"
#include "support/cover_oracle.h"
#include "support/exact_cover.h"
#include "support/projected_city.h"
#include "support/random_city.h"

namespace {

using geom::Footprint;
using geom::Vec2;

struct Extent {
  Vec2 low;
  Vec2 high;
};

Extent extent_of(const geom::Polygon& polygon) {
  Extent e{polygon.outer.front(), polygon.outer.front()};
  for (const Vec2& p : polygon.outer) e = {e.low.cwiseMin(p), e.high.cwiseMax(p)};
  return e;
}

// All boxes of each feature: a wall may lie in those of a roof.
class Boxes {
 public:
  explicit Boxes(const geom::BoxTable& table) {
    for (std::size_t i = 0; i < table.boxes.size(); ++i) {
      of_[table.ids[i]].push_back(table.boxes[i]);
    }
  }

  bool cover(const Footprint& f, const Vec2& p) const {
    const auto of = of_.find(f.id);
    return of != of_.end() && std::ranges::any_of(of->second, [&](const geom::Aabb& box) {
             return p.x() >= box.min.x() && p.x() <= box.max.x() && p.y() >= box.min.y() &&
                    p.y() <= box.max.y() && f.bottom >= box.min.z() && f.top <= box.max.z();
           });
  }

 private:
  std::map<std::uint64_t, std::vector<geom::Aabb>> of_;
};

struct Tally {
  std::size_t points = 0;
  std::size_t outside = 0;  // of all boxes
};

Tally check_corners(std::span<const Footprint> footprints, const Boxes& boxes) {
  Tally tally;
  for (const Footprint& f : footprints) {
    const auto ring = [&](const std::vector<Vec2>& points) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 middle = 0.5 * (points[i] + points[(i + 1) % points.size()]);
        tally.points += 2;
        tally.outside += !boxes.cover(f, points[i]) + !boxes.cover(f, middle);
      }
    };
    ring(f.polygon.outer);
    for (const auto& hole : f.polygon.holes) ring(hole);
  }
  return tally;
}

// At least `wanted` random points, spread as the rectangles around the polygons.
Tally check_inside(std::span<const Footprint> footprints, const Boxes& boxes, std::size_t wanted) {
  double area = 0;
  for (const Footprint& f : footprints) {
    const Extent e = extent_of(f.polygon);
    area += (e.high - e.low).prod();
  }
  support::Random random(1);
  Tally tally;
  while (tally.points < wanted) {
    for (const Footprint& f : footprints) {
      const Extent e = extent_of(f.polygon);
      const oracle::Distance distance(f.polygon);
      const double share = (e.high - e.low).prod() / area * static_cast<double>(wanted);
      for (double k = random.uniform(0, 1); k < share; ++k) {
        const Vec2 p(random.uniform(e.low.x(), e.high.x()), random.uniform(e.low.y(), e.high.y()));
        if (distance(p.x(), p.y()) > 0) continue;
        ++tally.points;
        tally.outside += !boxes.cover(f, p);
      }
    }
  }
  return tally;
}

// What becomes of one polygon, or of all.
struct Cover {
  std::size_t unproved = 0;  // not proved to be covered, in rationals
  double furthest = 0;       // metres outside
};

Cover cover_of(const geom::Polygon& polygon, double slack) {
  const auto rectangles = geom::cover(polygon, slack);
  Cover out;
  out.unproved = !oracle::exactly_covered(polygon, rectangles);
  for (const geom::Rectangle& r : rectangles) {
    out.furthest = std::max(out.furthest, oracle::furthest_outside(polygon, r, 1e-4 * slack));
  }
  return out;
}

Cover cover_all(std::span<const Footprint> footprints, double slack) {
  std::vector<Cover> covers(footprints.size());
  geom::parallel_for(covers.size(), {2, {}},
                     [&](std::size_t i) { covers[i] = cover_of(footprints[i].polygon, slack); });
  Cover all;
  for (const Cover& c : covers) {
    all.unproved += c.unproved;
    all.furthest = std::max(all.furthest, c.furthest);
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string path = argv[1];
  const double slack = argc > 2 ? std::atof(argv[2]) : 0.5;
  const auto wanted = static_cast<std::size_t>(argc > 3 ? std::atof(argv[3]) : 1e6);
  const std::vector<Footprint> footprints = support::projected_city(path, slack);
  const geom::BoxTable table = geom::boxes_of(footprints, slack, {2, {}});
  const Boxes boxes(table);
  std::vector<Footprint> level;  // of the others roof_check says more
  std::ranges::copy_if(footprints, std::back_inserter(level),
                       [](const Footprint& f) { return f.heights.empty(); });
  const Tally corners = check_corners(level, boxes);
  const Tally inside = check_inside(level, boxes, wanted);
  const std::size_t outside = corners.outside + inside.outside;
  const Cover all = cover_all(footprints, slack);
  fmt::print("footprints {}, level {}, boxes {}\n", footprints.size(), level.size(),
             table.boxes.size());
  fmt::print("points inside {}, corners and middles {}: outside the boxes {}\n", inside.points,
             corners.points, outside);
  fmt::print("furthest outside a polygon {:.6f} m of {} (bound, 1e-4 of it loose)\n", all.furthest,
             slack);
  fmt::print("polygons not proved to be covered, in rationals: {}\n", all.unproved);
  return outside + all.unproved > 0 || all.furthest > slack * 1.0002;
}
