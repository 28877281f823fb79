// cover_check FILE SLACK N: what the boxes of a city's footprints promise. N random points inside
// the polygons, all corners and the middles of all edges must lie in boxes; no box may reach
// further than the slack outside its polygon; the former is also proved in rationals. And how many
// boxes there are beside a raster whose cells keep the slack.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <set>

#include "footprints/source.h"
#include "geom/cover.h"
#include "geom/io/city_json.h"
#include "geom/parallel.h"
#include "support/cover_oracle.h"
#include "support/exact_cover.h"
#include "support/random_city.h"

namespace {

using geom::Footprint;
using geom::Vec2;

footprints::Source read(const std::string& path) {
  if (path.ends_with(".pbf")) return footprints::read_osm(path, path, {});
  if (path.ends_with(".geojson")) return footprints::read_vector(path, path, {});
  std::ifstream in(path);
  geom::CityJson city = geom::read_city_json(in, path);
  return {std::move(city.footprints), city.crs, {}};
}

struct Extent {
  Vec2 low;
  Vec2 high;
};

Extent extent_of(const geom::Polygon& polygon) {
  Extent e{polygon.outer.front(), polygon.outer.front()};
  for (const Vec2& p : polygon.outer) e = {e.low.cwiseMin(p), e.high.cwiseMax(p)};
  return e;
}

// Cells of side slack / sqrt(2) that meet the polygon, and runs of them along rows.
std::pair<std::size_t, std::size_t> raster(const geom::Polygon& polygon, double slack) {
  const double side = slack / std::sqrt(2.0);
  std::set<std::pair<long, long>> cells;
  for (const geom::Rectangle& r : geom::cover(polygon, side / 50)) {  // as good as the polygon
    for (long j = std::lround(std::floor(r.min.y() / side)); j <= std::floor(r.max.y() / side); ++j)
      for (long i = std::lround(std::floor(r.min.x() / side)); i <= std::floor(r.max.x() / side);
           ++i)
        cells.insert({j, i});
  }
  std::size_t runs = 0;
  for (const auto& [j, i] : cells) runs += !cells.contains({j, i - 1});
  return {cells.size(), runs};
}

}  // namespace

int main(int argc, char** argv) {
  const std::string path = argv[1];
  const double slack = argc > 2 ? std::atof(argv[2]) : 0.5;
  const auto wanted = static_cast<std::size_t>(argc > 3 ? std::atof(argv[3]) : 1e6);
  footprints::Source source = read(path);
  const footprints::Projector projector(source, path, std::nullopt);
  for (Footprint& f : source.footprints) {
    for (Vec2& p : f.polygon.outer) p = projector(p);
    for (auto& hole : f.polygon.holes) {
      for (Vec2& p : hole) p = projector(p);
    }
  }
  // All boxes of a feature: a wall may lie in those of a roof.
  const geom::BoxTable table = geom::boxes_of(source.footprints, slack, {2, {}});
  std::map<std::uint64_t, std::vector<geom::Aabb>> boxes;
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    boxes[table.ids[i]].push_back(table.boxes[i]);
  }
  const auto covered = [&](const Footprint& f, const Vec2& p) {
    return std::ranges::any_of(boxes[f.id], [&](const geom::Aabb& box) {
      return p.x() >= box.min.x() && p.x() <= box.max.x() && p.y() >= box.min.y() &&
             p.y() <= box.max.y() && f.bottom >= box.min.z() && f.top <= box.max.z();
    });
  };
  std::size_t corners = 0;
  std::size_t outside = 0;
  double area = 0;
  for (const Footprint& f : source.footprints) {
    const Extent e = extent_of(f.polygon);
    area += (e.high - e.low).prod();
    const auto ring = [&](const std::vector<Vec2>& points) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 middle = 0.5 * (points[i] + points[(i + 1) % points.size()]);
        corners += 2;
        outside += !covered(f, points[i]) + !covered(f, middle);
      }
    };
    ring(f.polygon.outer);
    for (const auto& hole : f.polygon.holes) ring(hole);
  }
  support::Random random(1);
  std::size_t inside = 0;
  while (inside < wanted) {
    for (const Footprint& f : source.footprints) {
      const Extent e = extent_of(f.polygon);
      const oracle::Distance distance(f.polygon);
      const double share = (e.high - e.low).prod() / area * static_cast<double>(wanted);
      for (double k = random.uniform(0, 1); k < share; ++k) {
        const Vec2 p(random.uniform(e.low.x(), e.high.x()), random.uniform(e.low.y(), e.high.y()));
        if (distance(p.x(), p.y()) > 0) continue;
        ++inside;
        outside += !covered(f, p);
      }
    }
  }
  std::vector<double> reach(source.footprints.size());
  std::vector<std::size_t> rectangles(reach.size());
  std::vector<std::size_t> not_covered(reach.size());  // not proved to be, in rationals
  std::vector<std::pair<std::size_t, std::size_t>> cells(reach.size());
  geom::parallel_for(reach.size(), {2, {}}, [&](std::size_t i) {
    const geom::Polygon& polygon = source.footprints[i].polygon;
    const auto cover = geom::cover(polygon, slack);
    rectangles[i] = cover.size();
    not_covered[i] = !oracle::exactly_covered(polygon, cover);
    for (const geom::Rectangle& r : cover) {
      reach[i] = std::max(reach[i], oracle::furthest_outside(polygon, r, 1e-4 * slack));
    }
    cells[i] = raster(polygon, slack);
  });
  std::size_t all_cells = 0;
  std::size_t all_runs = 0;
  std::size_t all_rectangles = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    all_cells += cells[i].first;
    all_runs += cells[i].second;
    all_rectangles += rectangles[i];
  }
  const double furthest = *std::max_element(reach.begin(), reach.end());
  fmt::print("footprints {} boxes {}\n", source.footprints.size(), table.boxes.size());
  fmt::print("points inside {}, corners and middles {}: outside the boxes {}\n", inside, corners,
             outside);
  fmt::print("furthest outside a polygon {:.6f} m of {} (bound, 1e-4 of it loose)\n", furthest,
             slack);
  const std::size_t unproved =
      std::accumulate(not_covered.begin(), not_covered.end(), std::size_t{0});
  fmt::print("polygons not proved to be covered, in rationals: {}\n", unproved);
  fmt::print("rectangles {}; raster cells {} ({:.1f}%), runs of cells {} ({:.1f}%)\n",
             all_rectangles, all_cells, 100.0 * all_rectangles / all_cells, all_runs,
             100.0 * all_rectangles / all_runs);
  return outside + unproved > 0 || furthest > slack * 1.0002;
}
