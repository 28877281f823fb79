#include "groups.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <utility>

#include "embree_tree.h"
#include "geom/base/mapped_file.h"
#include "geom/base/precondition.h"
#include "geom/base/rounding.h"
#include "map/box_map_data.h"
#include "packed_tree.h"

namespace geom {
namespace {

constexpr double kBoxesPerGroup = 512;  // where the whole map fits the budget,
constexpr double kFewerPerGroup = 128;  // and where groups are built again and again

constexpr double kOneGroup = 16;         // times as many boxes as wanted are one group still
constexpr double kMostSharedPad = 0.25;  // metres; of larger maps, groups have frames of their own
constexpr std::size_t kMostBytesPerBox = 256;
constexpr std::size_t kMostBytesPerGroup = 1024;
constexpr std::size_t kReadBetweenTrims = std::size_t{1} << 22;  // bytes

// What shares a group: a square of so many tiles a side, and the tile of large boxes for itself;
// everything where `side` is 0.
struct Square {
  bool small;
  std::int32_t y;
  std::int32_t x;

  friend auto operator<=>(const Square&, const Square&) = default;
};

// Which group each tile belongs to.
class Grouping {
 public:
  Grouping(const BoxMap& map, double wanted) {
    const auto tiles = static_cast<double>(map.tile_count());
    const auto boxes = static_cast<double>(map.size());
    if (boxes > kOneGroup * wanted) {
      side_ =
          static_cast<std::int32_t>(std::max(1.0, std::ceil(std::sqrt(wanted * tiles / boxes))));
    }
  }

  // Tiles come in the order of the map: row after row, and in a row from left to right.
  std::size_t group_of(const Tile& tile) {
    const Square square = square_of(tile);
    if (first_.empty() || square.y != band_y_ || square.small != band_small_) {
      band_.clear();
      band_y_ = square.y;
      band_small_ = square.small;
      next_ = 0;
    } else if (tile.iy != row_) {
      next_ = 0;
    }
    row_ = tile.iy;
    while (next_ < band_.size() && band_[next_].first < square.x) ++next_;
    if (next_ == band_.size() || band_[next_].first != square.x) {
      band_.insert(band_.begin() + static_cast<std::ptrdiff_t>(next_), {square.x, first_.size()});
      first_.push_back(tile.first);
    } else if (tile.first + tile.count - first_[band_[next_].second] >= BoxNode::kBox - 1) {
      band_[next_].second = first_.size();  // names are below 2^31 - 1
      first_.push_back(tile.first);
    }
    return band_[next_].second;
  }

 private:
  Square square_of(const Tile& tile) const {
    if (side_ == 0) return {true, 0, 0};
    if (tile.large) return {false, 0, 0};
    const auto square = [&](std::int32_t i) { return i >= 0 ? i / side_ : -1 - (-1 - i) / side_; };
    return {true, square(tile.iy), square(tile.ix)};
  }

  std::int32_t side_ = 0;                                   // tiles; 0: one group
  std::vector<std::pair<std::int32_t, std::size_t>> band_;  // the groups of this row of squares
  std::size_t next_ = 0;                                    // in band_
  std::int32_t band_y_ = 0;
  bool band_small_ = false;
  std::int32_t row_ = 0;
  std::vector<std::size_t> first_;  // box of each group
};

}  // namespace

CollisionScene::Impl::Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options)
    : map(std::move(m)), vehicle(std::move(v)), margin(mg), budget(options.budget) {
  for (const double size : vehicle.half) require_length("vehicle", size, kLargestCoordinate);
  require_length("margin", margin, kLargestCoordinate);
  map.require(Verified::extents);  // one that lies would hide boxes from every query
  boxes = map.boxes();
  for (int i = 0; i < 3; ++i) {
    half[i] = vehicle.half[i] + margin;
    if (margin > 0) half[i] = next_up(half[i]);
  }
  free_bounds = shrink(map.spec().bounds, half);
  const bool fits = map.size() <= budget / kMostBytesPerBox;
  group_tiles(options.boxes_per_group > 0 ? static_cast<double>(options.boxes_per_group)
              : fits                      ? kBoxesPerGroup
                                          : kFewerPerGroup);
  counts.groups = groups.size();
  keeps_all = groups.size() <= 1 ||
              map.size() * kMostBytesPerBox + groups.size() * kMostBytesPerGroup <= budget;
  if (groups.size() > 1) start_embree();  // here rather than in a query
}

void CollisionScene::Impl::group_tiles(double wanted) {
  const TileTable& tiles = map.data().tiles;
  std::vector<Member> members;
  Grouping grouping(map, wanted);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const Tile tile = tiles[t];
    require_point("box map", tile.extent.min);
    require_point("box map", tile.extent.max);
    const std::size_t g = grouping.group_of(tile);
    if (g == group_extent.size()) {
      group_extent.push_back(tile.extent);
    } else {
      group_extent[g] = merged(group_extent[g], tile.extent);
    }
    if (!members.empty() && members.back().group == g) {
      members.back().run.count += tile.count;  // the next tile's boxes come next
    } else {
      members.push_back({{tile.first, tile.count}, g});
    }
  }
  for (Aabb& extent : group_extent) extent = grow(extent, half);
  order_groups(members);
  groups = std::vector<Group>(group_extent.size());
  std::vector<std::size_t> place(groups.size() + 1);  // of the runs of each group
  for (const Member& member : members) ++place[member.group + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  runs.resize(members.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].runs = std::span(runs).subspan(place[g], place[g + 1] - place[g]);
  }
  for (const Member& member : members) {
    runs[place[member.group]++] = member.run;
    groups[member.group].count += member.run.count;
  }
}

// The tree over groups, and groups in the order of its leaves.
void CollisionScene::Impl::order_groups(std::vector<Member>& members) {
  const auto all = bounds(group_extent);
  if (!all) return;
  reach = *all;
  top.frame = TreeFrame(reach);
  one_frame = top.frame.pad <= kMostSharedPad;
  if (group_extent.size() == 1) return;
  BuiltTree built = packed_tree(group_extent);
  top = std::move(built.tree);
  std::vector<std::size_t> place(built.order.size());
  std::vector<Aabb> extents(built.order.size());
  for (std::size_t k = 0; k < built.order.size(); ++k) {
    place[built.order[k]] = k;
    extents[k] = group_extent[built.order[k]];
  }
  group_extent = std::move(extents);
  for (Member& member : members) member.group = place[member.group];
}

// Where memory runs out, half of what there is makes room once.
const GroupTree& CollisionScene::Impl::build_group(std::size_t g) {
  const std::lock_guard lock(building[g % kLocks]);
  if (const GroupTree* tree = kept_tree(groups[g])) return *tree;
  OwnedGroup tree;
  try {
    tree = made_tree(groups[g]);
  } catch (const std::bad_alloc&) {
    if (!make_room()) throw;
    tree = made_tree(groups[g]);
  }
  const GroupTree& made = *tree;
  keep(g, std::move(tree));
  return made;
}

OwnedGroup CollisionScene::Impl::made_tree(const Group& group) {
  std::vector<Aabb> grown;
  std::vector<Aabb> by_vehicle;
  std::vector<std::uint32_t> names;
  grown.reserve(group.count);
  names.reserve(group.count);
  if (margin > 0) by_vehicle.reserve(group.count);
  const std::size_t first = group.runs.front().first;
  for (const BoxRun& run : group.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      grown.push_back(grow(boxes[i], half));
      if (margin > 0) by_vehicle.push_back(grow(boxes[i], vehicle.half));
      names.push_back(static_cast<std::uint32_t>(i - first));
    }
  }
  const Aabb extent = *bounds(grown);
  std::unique_ptr<FirstLooks> looks;
  if (groups.size() == 1) {
    looks.reset(new FirstLooks{NearestHints(extent, group.count), Skyline(grown, extent)});
  }
  const BuiltTree built = embree_tree(grown, one_frame ? top.frame : TreeFrame(extent));
  return group_tree({built, grown, by_vehicle, names, first, std::move(looks)},
                    keeps_all ? &arena : nullptr);
}

bool CollisionScene::Impl::make_room() noexcept {
  if (keeps_all) return false;
  const std::lock_guard lock(keeping);
  const std::size_t before = bytes;
  budget = std::min(budget, bytes / 2);
  give_up(groups.size());
  return bytes < before;
}

// Not while it is taken away to see whether somebody uses it.
const GroupTree* CollisionScene::Impl::kept_tree(const Group& group) {
  const std::lock_guard lock(keeping);
  return group.tree.load();
}

// The group's tree is there once nothing can fail any more.
void CollisionScene::Impl::keep(std::size_t g, OwnedGroup tree) {
  bool trim = false;
  {
    const std::lock_guard lock(keeping);
    kept.push_back(static_cast<std::uint32_t>(g));
    bytes += tree->bytes;
    ++(groups[g].built ? counts.built_again : counts.built);
    groups[g].built = true;
    groups[g].tree.store(tree.release());
    if (!keeps_all && bytes > budget) give_up(g);
    counts.most_bytes = std::max(counts.most_bytes, bytes);
    read += groups[g].count * sizeof(Aabb);
    trim = read >= kReadBetweenTrims;
    if (trim) read = 0;
  }
  if (trim) trim_mapped_files();
}

// Second chance (Corbato 1968): the hand goes around, passes what was touched since it last came
// by, and gives up the rest. A query counts itself among the users before it reads `tree`, and
// here `tree` is taken away before the users are counted, so one of the two always sees the other.
void CollisionScene::Impl::give_up(std::size_t but) noexcept {
  for (std::size_t tries = 2 * kept.size(); tries > 0 && bytes > budget; --tries) {
    hand = hand < kept.size() ? hand : 0;
    const std::size_t g = kept[hand];
    if (g == but || groups[g].touched.exchange(false)) {
      ++hand;
      continue;
    }
    const GroupTree* tree = groups[g].tree.exchange(nullptr);
    if (groups[g].users.load() > 0) {
      groups[g].tree.store(tree);
      ++hand;
      continue;
    }
    kept[hand] = kept.back();
    kept.pop_back();
    bytes -= tree->bytes;
    ReleaseGroup()(tree);
  }
}

}  // namespace geom
