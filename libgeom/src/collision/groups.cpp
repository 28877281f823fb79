#include "groups.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <utility>

#include "geom/base/mapped_file.h"
#include "geom/base/precondition.h"
#include "geom/base/rounding.h"
#include "map/box_map_data.h"
#include "packed_tree.h"
#include "split_tree.h"
#include "tree_bytes.h"

namespace geom {
namespace {

constexpr double kBoxesPerGroup = 128;        // as many as two levels of nodes find
constexpr std::size_t kMostInOneTree = 8192;  // of a map that fits the budget twice

constexpr double kMostSharedPad = 0.25;  // metres; of larger maps, groups have frames of their own
constexpr std::size_t kManyBuilt = 32;   // groups: more than one question touches
constexpr std::size_t kReadBetweenTrims = std::size_t{1} << 22;  // bytes

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
  group_tiles(options.boxes_per_group > 0 ? static_cast<double>(options.boxes_per_group)
                                          : kBoxesPerGroup);
  counts.groups = groups.size();
  keeps_all = groups.size() <= 1 || most_tree_bytes(map.size(), groups.size()) <= budget;
  is_small = options.boxes_per_group == 0 &&
             map.size() <= std::min(kMostInOneTree, budget / (2 * kMostBytesPerBox));
}

void CollisionScene::Impl::group_tiles(double wanted) {
  tiles = tile_groups(map.data().tiles, map.size(), wanted);
  for (Aabb& extent : tiles.extent) extent = grow(extent, half);
  groups = std::vector<Group>(tiles.extent.size());
  if (groups.empty()) return;
  reach = *bounds(tiles.extent);
  if (groups.size() > 1) {
    BuiltTree built = packed_tree(tiles.extent);
    top = std::move(built.tree);
    order = std::move(built.order);
  } else {
    top.frame = TreeFrame(reach);
    order = {0};
  }
  one_frame = top.frame.pad <= kMostSharedPad;
}

// Where memory runs out, half of what there is makes room once.
const GroupTree& CollisionScene::Impl::build_group(std::size_t g) {
  const std::lock_guard lock(building[g % kLocks]);
  if (const GroupTree* tree = kept_tree(groups[g])) return *tree;
  OwnedGroup tree;
  try {
    tree = made_tree(g);
  } catch (const std::bad_alloc&) {
    if (!make_room()) throw;
    tree = made_tree(g);
  }
  const GroupTree& made = *tree;
  keep(g, std::move(tree));
  return made;
}

OwnedGroup CollisionScene::Impl::made_tree(std::size_t g) {
  std::vector<std::uint32_t> names;
  const std::uint32_t head = tiles.head[order[g]];
  std::size_t count = 0;
  const auto each_run = [&](const auto& f) {
    for (std::uint32_t r = head; r != TileGroups::kEnd; r = tiles.runs[r].next) f(tiles.runs[r]);
  };
  each_run([&](const TileGroups::Run& run) { count += run.count; });
  names.reserve(count);
  const std::size_t first = tiles.runs[head].first;
  each_run([&](const TileGroups::Run& run) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      names.push_back(static_cast<std::uint32_t>(i - first));
    }
  });
  return tree_of(first, names, groups.size() == 1);
}

// The tree of the boxes whose index in the map is `first` plus one of `names`.
OwnedGroup CollisionScene::Impl::tree_of(std::size_t first, std::span<const std::uint32_t> names,
                                         bool all) {
  std::vector<Aabb> grown;
  grown.reserve(names.size());
  for (const std::uint32_t name : names) grown.push_back(grow(boxes[first + name], half));
  const Aabb extent = *bounds(grown);
  std::unique_ptr<FirstLooks> looks;
  if (all) {
    looks.reset(new FirstLooks{NearestHints(extent, grown.size()), Skyline(grown, extent)});
  }
  const BuiltTree built = split_tree(grown, one_frame ? top.frame : TreeFrame(extent));
  return group_tree({.built = built,
                     .grown = grown,
                     .boxes = boxes.subspan(first),
                     .by_vehicle = margin > 0 ? std::optional(vehicle.half) : std::nullopt,
                     .names = names,
                     .first = first,
                     .looks = std::move(looks)},
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
  bool many = false;
  bool most = false;
  const std::size_t count = tree->count;
  {
    const std::lock_guard lock(keeping);
    kept.push_back(static_cast<std::uint32_t>(g));
    bytes += tree->bytes;
    ++(groups[g].built ? counts.built_again : counts.built);
    groups[g].built = true;
    groups[g].tree.store(tree.release());
    if (!keeps_all && bytes > budget) give_up(g);
    counts.most_bytes = std::max(counts.most_bytes, bytes);
    read += count * sizeof(Aabb);
    trim = read >= kReadBetweenTrims;
    if (trim) read = 0;
    many = keeps_all && !is_small && counts.built == kManyBuilt;
    // To build the other groups would take about as long as one tree of all boxes.
    most = keeps_all && is_small && groups.size() > 1 && 2 * built_boxes < boxes.size() &&
           2 * (built_boxes + count) >= boxes.size();
    built_boxes += count;
  }
  if (most) make_whole();
  if (many) make_cells();
  if (trim) trim_mapped_files();
}

// The next two only make later questions faster. Without memory they do nothing.
void CollisionScene::Impl::make_whole() noexcept {
  try {
    std::vector<std::uint32_t> names(boxes.size());
    std::iota(names.begin(), names.end(), 0);
    whole = tree_of(0, names, true);
    known_whole.store(whole.get(), std::memory_order_release);
  } catch (const std::bad_alloc&) {
  }
}

void CollisionScene::Impl::make_cells() noexcept {
  try {
    std::vector<Aabb> extents;
    extents.reserve(order.size());
    for (const std::uint32_t k : order) extents.push_back(tiles.extent[k]);
    cells = std::make_unique<const TopCells>(extents, top.frame, arena);
    known_cells.store(cells.get(), std::memory_order_release);
  } catch (const std::bad_alloc&) {
  }
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
