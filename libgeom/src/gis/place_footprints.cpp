#include "geom/gis/place_footprints.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "edge_follower.h"
#include "geom/base/error.h"
#include "required_reference.h"

namespace geom::gis {
namespace {

// The rectangle around a ring.
struct Reach {
  Vec2 low;
  Vec2 high;

  explicit Reach(const std::vector<Vec2>& ring) : low(ring.front()), high(low) { add(ring); }
  void add(const std::vector<Vec2>& ring) {
    for (const Vec2& p : ring) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
};

// How far corners are from the straight sides between those at `ends`, the first of which is 0.
double bulge_of(std::span<const Vec2> ring, const std::array<std::size_t, 4>& ends) {
  double bulge = 0;
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t end = side < 3 ? ends[side + 1] : ring.size();
    const Vec2& a = ring[ends[side]];
    const Vec2& b = ring[end < ring.size() ? end : 0];
    for (std::size_t i = ends[side] + 1; i < end; ++i) {
      bulge = std::max(bulge, distance_to_segment(ring[i], a, b));
    }
  }
  return bulge > 0 ? bulge + 1e-9 : 0;  // more than sums are rounded
}

// A footprint's corners among those that are converted together.
class Corners {
 public:
  // Takes them.
  Corners(Footprint& footprint, const std::optional<CellGrid>& grid, std::vector<Vec2>& all)
      : footprint_(&footprint), first_(all.size()) {
    if (grid) {
      const CellGrid::Cells& cells = grid->of[footprint.id];
      const auto columns = static_cast<std::size_t>(cells.last_column - cells.first_column);
      const auto rows = static_cast<std::size_t>(cells.last_row - cells.first_row);
      ends_ = {0, columns, columns + rows, 2 * columns + rows};
      grid->for_each_corner(cells, [&](const Vec2& corner) { all.push_back(corner); });
    } else {
      for_each_ring([&](const auto& ring) { all.insert(all.end(), ring.begin(), ring.end()); });
    }
  }

  // Puts them back, converted; `source`: as they were.
  void place(std::span<const Vec2> all, std::span<const Vec2> source, double slack,
             EdgeFollower& edges) const {
    if (!ends_) {
      std::size_t next = first_;
      for_each_ring([&](auto& ring) {
        for (Vec2& p : ring) p = all[next++];
      });
      edges.take(*footprint_, source.subspan(first_, next - first_));
      return;
    }
    const auto& ends = *ends_;
    const std::span ring = all.subspan(first_, 2 * ends[2]);
    const double bulge = bulge_of(ring, ends);
    if (bulge <= slack / 100) {
      footprint_->bulge = bulge;
      for (std::size_t i = 0; i < 4; ++i) footprint_->polygon.outer[i] = ring[ends[i]];
    } else {
      footprint_->polygon.outer.assign(ring.begin(), ring.end());
    }
  }

 private:
  template <class F>
  void for_each_ring(const F& f) const {
    f(footprint_->polygon.outer);
    for (auto& hole : footprint_->polygon.holes) f(hole);
  }

  Footprint* footprint_;
  std::size_t first_;
  std::optional<std::array<std::size_t, 4>> ends_;  // of the sides of a rectangle of cells
};

// The bulge of a footprint in the source's units, as metres on the map: nowhere less.
double bulge_on_map(const Footprint& f, const Projector& projector) {
  if (projector.frame().crs.empty()) return f.bulge;
  const Reach reach(f.polygon.outer);
  const double step = (reach.high - reach.low).maxCoeff() / 100;
  const Vec2& at = f.polygon.outer.front();
  std::vector<Vec2> points{at, at + Vec2(step, 0), at + Vec2(0, step)};
  projector.convert(points);
  const double metres = std::hypot((points[1] - points[0]).norm(), (points[2] - points[0]).norm());
  return 1.01 * metres / step * f.bulge;  // scales differ little within a footprint
}

}  // namespace

void project(Source& source, const Projector& projector, double slack) {
  constexpr std::size_t kTogether = 1U << 16;  // points, and those of one footprint
  std::vector<Vec2> all;
  std::vector<Corners> taken;
  for (std::size_t i = 0; i < source.footprints.size(); ++i) {
    Footprint& f = source.footprints[i];
    if (f.bulge > 0) f.bulge = bulge_on_map(f, projector);
    taken.emplace_back(f, source.grid, all);
    if (all.size() < kTogether && i + 1 < source.footprints.size()) continue;
    const std::vector<Vec2> corners_before = all;
    projector.convert(all);
    EdgeFollower edges(projector);
    for (const Corners& corners : taken) corners.place(all, corners_before, slack, edges);
    edges.follow();
    all.clear();
    taken.clear();
  }
}

void lift(Source& source, const Terrain& terrain, const Frame& frame) {
  std::optional<ProjWay> way;
  if (!frame.crs.empty() && terrain.crs()) {
    way = required_way(ProjWay::to_plane(*terrain.crs(), *frame.origin), *terrain.crs(),
                       terrain.name());
  }
  std::vector<Footprint> lifted;
  for (Footprint& f : source.footprints) {
    const Reach reach(f.polygon.outer);
    const auto ground = terrain.range(reach.low, reach.high, way);
    const std::string which = fmt::format("feature {}", f.id);
    if (!ground) {
      ++source.counts["footprints_without_terrain"];
      source.skipped.add("footprint without ground under it", which);
      continue;
    }
    if (!ground->whole) {
      ++source.counts["footprints_partly_without_terrain"];
      source.skipped.add("footprint with unknown ground under a part of it", which);
    }
    f.bottom += ground->low;
    f.top += ground->high;
    for (double& height : f.heights) height += ground->high;
    lifted.push_back(std::move(f));
  }
  source.footprints = std::move(lifted);
}

void sink_ground(std::vector<Footprint>& footprints, std::optional<double> floor) {
  double lowest = floor.value_or(kLargestCoordinate);
  for (const Footprint& f : footprints) lowest = std::min(lowest, f.bottom);
  for (Footprint& f : footprints) {
    if (f.ground) f.bottom = lowest;
  }
}

void check_sizes(const Source& source, double slack, const std::string& name) {
  constexpr double kMostSlabs = 1e6;
  constexpr double kPlane = 2e6;  // metres from the origin: further away it means nothing any more
  const double most = std::min(kLargestCoordinate, 1e9 * slack);
  const double reach = source.crs ? std::min(most, kPlane) : most;
  for (const Footprint& f : source.footprints) {
    Reach around(f.polygon.outer);
    for (const auto& hole : f.polygon.holes) around.add(hole);
    const auto& [low, high] = around;
    const double size = (high - low).maxCoeff();
    if (low.minCoeff() < -reach || high.maxCoeff() > reach || size > kMostSlabs * slack) {
      throw InputError(
          name,
          {.item = fmt::format("feature {}", f.id),
           .expected = fmt::format(
               "a footprint within {} m of the origin and no longer than {} m (1e6 times --slack)",
               reach, kMostSlabs * slack),
           .found = fmt::format("[{}, {}] to [{}, {}]", low.x(), low.y(), high.x(), high.y())});
    }
  }
}

}  // namespace geom::gis
