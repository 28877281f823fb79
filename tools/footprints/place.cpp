#include "place.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"

namespace footprints {
namespace {

// The rectangle around a ring.
struct Reach {
  geom::Vec2 low;
  geom::Vec2 high;

  explicit Reach(const std::vector<geom::Vec2>& ring) : low(ring.front()), high(low) { add(ring); }
  void add(const std::vector<geom::Vec2>& ring) {
    for (const geom::Vec2& p : ring) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
};

}  // namespace

void project(std::vector<geom::Footprint>& footprints, const Projector& projector) {
  for (geom::Footprint& f : footprints) {
    for (geom::Vec2& p : f.polygon.outer) p = projector(p);
    for (auto& hole : f.polygon.holes) {
      for (geom::Vec2& p : hole) p = projector(p);
    }
  }
}

void lift(Source& source, const Terrain& terrain, const std::string& crs) {
  for (geom::Footprint& f : source.footprints) {
    const Reach reach(f.polygon.outer);
    const auto ground = terrain.range(reach.low, reach.high, crs);
    if (!ground) {
      ++source.counts["footprints_without_terrain"];
      source.skipped.add("footprint without ground under it", fmt::format("feature {}", f.id));
      continue;
    }
    f.bottom += ground->low;
    f.top += ground->high;
    for (double& height : f.heights) height += ground->high;
  }
}

void sink_ground(std::vector<geom::Footprint>& footprints, std::optional<double> floor) {
  double lowest = floor.value_or(geom::kLargestCoordinate);
  for (const geom::Footprint& f : footprints) lowest = std::min(lowest, f.bottom);
  for (geom::Footprint& f : footprints) {
    if (f.ground) f.bottom = lowest;
  }
}

void keep_shard(std::vector<geom::Footprint>& footprints, const geom::Shard& shard) {
  std::vector<std::size_t> first;  // of each feature
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (i == 0 || footprints[i].id != footprints[i - 1].id) first.push_back(i);
  }
  const std::size_t features = first.size();
  first.push_back(footprints.size());
  const auto at = [&](std::size_t feature) {
    return footprints.begin() + static_cast<std::ptrdiff_t>(first[feature]);
  };
  footprints.erase(at(shard.end(features)), footprints.end());
  footprints.erase(footprints.begin(), at(shard.begin(features)));
}

void check_sizes(const Source& source, double slack, const std::string& name) {
  constexpr double kMostSlabs = 1e6;
  const double reach = std::min(geom::kLargestCoordinate, 1e9 * slack);
  for (const geom::Footprint& f : source.footprints) {
    Reach around(f.polygon.outer);
    for (const auto& hole : f.polygon.holes) around.add(hole);
    const auto& [low, high] = around;
    const double size = (high - low).maxCoeff();
    if (low.minCoeff() < -reach || high.maxCoeff() > reach || size > kMostSlabs * slack) {
      throw geom::InputError(
          name, fmt::format("feature {}: expected a footprint within {} m of the origin and no "
                            "longer than {} m (1e6 times --slack), found [{}, {}] to [{}, {}]",
                            f.id, reach, kMostSlabs * slack, low.x(), low.y(), high.x(), high.y()));
    }
  }
}

}  // namespace footprints
