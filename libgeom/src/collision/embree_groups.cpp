#include "embree_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "embree_queries.h"
#include "geom/base/mapped_file.h"
#include "geom/base/precondition.h"
#include "geom/base/rounding.h"

namespace geom {
namespace {

constexpr std::size_t kEmbreeBytesPerBox = 80;  // measured: 78

// The tiles by squares of so many tiles that a square has about `wanted` boxes; the tile of large
// boxes is a group of its own unless the whole map is one group.
std::vector<std::vector<std::size_t>> grouped(const BoxMap& map, double wanted) {
  const auto tiles = map.tiles();
  if (tiles.empty()) return {};
  const double per_tile = static_cast<double>(map.size()) / static_cast<double>(tiles.size());
  const bool one = static_cast<double>(map.size()) <= 2 * wanted;
  const auto side = static_cast<std::int32_t>(std::ceil(std::sqrt(wanted / per_tile)));
  const auto square = [&](std::int32_t i) {
    return one ? 0 : i >= 0 ? i / side : -1 - (-1 - i) / side;
  };
  std::map<std::tuple<bool, std::int32_t, std::int32_t>, std::vector<std::size_t>> groups;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    groups[{!one && tiles[t].large, square(tiles[t].iy), square(tiles[t].ix)}].push_back(t);
  }
  std::vector<std::vector<std::size_t>> out;
  for (auto& [key, members] : groups) out.push_back(std::move(members));
  return out;
}

}  // namespace

void GroupScene::remember(std::size_t map_box, std::atomic<std::uint32_t>& hint) const {
  const auto at = std::lower_bound(box.begin(), box.end(), map_box);
  if (at == box.end() || *at != map_box) return;
  hint.store(static_cast<std::uint32_t>(at - box.begin()), std::memory_order_relaxed);
}

std::size_t GroupScene::bytes() const {
  return box.size() * (sizeof(std::size_t) + kEmbreeBytesPerBox) +
         (grown.size() + by_vehicle.size()) * sizeof(Aabb) + hints.bytes() + (1 << 15);
}

CollisionScene::Impl::Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options)
    : map(std::move(m)), vehicle(std::move(v)), margin(mg), budget(options.budget) {
  for (const double size : vehicle.half) require_length("vehicle", size, kLargestCoordinate);
  require_length("margin", margin, kLargestCoordinate);
  for (const Tile& tile :
       map.tiles()) {  // Embree leaves out what is further away than a float goes
    require_point("box map", tile.extent.min);
    require_point("box map", tile.extent.max);
  }
  map.require(Verified::extents);  // one that lies would hide boxes from every query
  for (int i = 0; i < 3; ++i) {
    half[i] = vehicle.half[i] + margin;
    if (margin > 0) half[i] = next_up(half[i]);
  }
  free_bounds = shrink(map.spec().bounds, half);
  auto members = grouped(map, std::max(1.0, static_cast<double>(options.boxes_per_group)));
  groups = std::vector<Group>(members.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].tiles = std::move(members[g]);
    Aabb extent = map.tiles()[groups[g].tiles.front()].extent;
    for (const std::size_t t : groups[g].tiles) extent = merged(extent, map.tiles()[t].extent);
    group_extent.push_back(grow(extent, half));
  }
  if (const auto all = bounds(group_extent)) reach = *all;
  if (groups.size() > 1) {
    top = build(group_extent, segment_against_group, visit_candidate);
  }
}

const GroupScene& CollisionScene::Impl::build_group(std::size_t g) {
  const std::lock_guard lock(building);
  if (const GroupScene* scene = groups[g].scene.load()) return *scene;
  auto scene = std::make_unique<GroupScene>();
  std::size_t count = 0;
  for (const std::size_t t : groups[g].tiles) count += map.tiles()[t].count;
  scene->box.reserve(count);
  scene->grown.reserve(count);
  if (margin > 0) scene->by_vehicle.reserve(count);
  for (const std::size_t t : groups[g].tiles) {
    std::size_t i = map.tiles()[t].first;
    for (const Aabb& box : map.boxes_of(t)) {
      scene->box.push_back(i++);
      scene->grown.push_back(grow(box, half));
      if (margin > 0) scene->by_vehicle.push_back(grow(box, vehicle.half));
    }
  }
  scene->embree = build(scene->grown, segment_against_box, visit_candidate);
  scene->skyline = Skyline(scene->grown, scene->embree.extent);
  scene->hints = NearestHints(scene->embree.extent, scene->grown.size());
  built.push_back(g);  // the last that can fail: from here on the group has its scene
  bytes += scene->bytes();
  const GroupScene& made = *scene.release();
  groups[g].scene.store(&made);
  if (bytes > budget) give_up_oldest(g);
  trim_mapped_files();
  return made;
}

// A query counts itself among the users before it reads `scene`, and here `scene` is taken away
// before the users are counted, so one of the two always sees the other.
void CollisionScene::Impl::give_up_oldest(std::size_t keep) noexcept {
  for (std::size_t tries = built.size(); tries > 0 && bytes > budget; --tries) {
    const std::size_t g = built.front();
    const GroupScene* scene = groups[g].scene.exchange(nullptr);
    if (g == keep || groups[g].users.load() > 0) {
      groups[g].scene.store(scene);
      built.splice(built.end(), built, built.begin());
      continue;
    }
    built.pop_front();
    bytes -= scene->bytes();
    delete scene;
  }
}

}  // namespace geom
