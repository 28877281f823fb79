#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "geom/map/buildings.h"
#include "geom/map/far_blocks.h"
#include "geom/map/label_colour.h"
#include "geom/map/outer_walls.h"
#include "layers.h"

namespace view {
namespace {

constexpr std::size_t kFew = 20000;   // boxes that are drawn as they are
constexpr std::size_t kATile = 600;   // boxes, about
constexpr double kFinest = 1.0 / 96;  // the cell of the finest blocks, of a tile
constexpr double kCoarser = 2.2;      // from each level to the next
constexpr double kFewer = 0.8;   // a level has so many of the blocks of the one before, at most
constexpr double kStep = 0.001;  // metres: to this, corners of many boxes are rounded

struct BoxArrays {
  std::vector<geom::Aabb> boxes;  // local, east, north, up
  std::vector<std::uint8_t>
      traits;  // bits 0 to 3: covered walls; 4 to 6: the side of a room; 7: keep-out
  std::vector<std::uint32_t> ids;  // empty where one needs more than 32 bits
  std::vector<std::uint32_t> labels;
  geom::Buildings buildings;
};

std::vector<std::uint8_t> traits_of(const geom::BoxMap& map, std::span<const geom::Aabb> boxes,
                                    const LocalFrame& frame, const geom::Buildings& buildings) {
  const geom::Aabb enu = geom::to_enu(map.spec().frame.axes, map.spec().bounds);
  const geom::Aabb bounds{enu.min - frame.origin, enu.max - frame.origin};
  const bool room = map.spec().bounds_from != "obstacles";
  const auto sides = geom::outer_walls(boxes, bounds);
  std::vector<std::uint8_t> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const unsigned side = room ? static_cast<unsigned>(sides[i]) : 0;
    const unsigned zone = geom::is_keep_out(map.labels()[map.label()[i]]);
    out.push_back(static_cast<std::uint8_t>(buildings.covered[i] | side << 4 | zone << 7));
  }
  return out;
}

BoxArrays arrays_of(const geom::BoxMap& map, const LocalFrame& frame) {
  BoxArrays out;
  for (const geom::Aabb& box : map.boxes()) {
    const geom::Aabb enu = geom::to_enu(map.spec().frame.axes, box);
    out.boxes.push_back({enu.min - frame.origin, enu.max - frame.origin});
  }
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  const auto ids = map.ids();
  if (std::all_of(ids.begin(), ids.end(), [](std::uint64_t id) { return id <= kMost; })) {
    out.ids.assign(ids.begin(), ids.end());
  }
  if (map.labels().size() > 1) out.labels.assign(map.label().begin(), map.label().end());
  out.buildings = geom::buildings_of({.boxes = out.boxes, .ids = ids, .labels = out.labels});
  out.traits = traits_of(map, out.boxes, frame, out.buildings);
  return out;
}

Json small_layer(const BoxArrays& arrays, Bundle& bundle) {
  std::vector<float> corners;
  for (const geom::Aabb& box : arrays.boxes) {
    for (const geom::Vec3& corner : {box.min, box.max}) {
      for (int k = 0; k < 3; ++k) corners.push_back(static_cast<float>(corner[k]));
    }
  }
  const auto add = [&](const auto& list) { return bundle.add(std::span(list)); };
  Json out = {{"corners", add(std::as_const(corners))}};
  if (!arrays.labels.empty()) out["label"] = add(arrays.labels);
  if (!arrays.ids.empty()) out["ids"] = add(arrays.ids);
  out["building"] = add(arrays.buildings.of);
  out["traits"] = add(arrays.traits);
  return out;
}

// Corners in steps, as columns: low x, y, z, and then how far the box reaches.
Json packed_boxes(std::span<const geom::Aabb> boxes, Bundle& bundle) {
  std::vector<std::vector<std::uint32_t>> columns(6);
  const auto steps = [](double metres) {
    return static_cast<std::int32_t>(std::lround(metres / kStep));
  };
  for (const geom::Aabb& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t low = steps(box.min[k]);
      columns[static_cast<std::size_t>(k)].push_back(static_cast<std::uint32_t>(low));
      columns[static_cast<std::size_t>(k) + 3].push_back(
          static_cast<std::uint32_t>(steps(box.max[k]) - low));
    }
  }
  return bundle.add_packed(columns);
}

Json packed(const std::vector<std::uint32_t>& column, Bundle& bundle) {
  return bundle.add_packed(std::span(&column, 1));
}

// Boxes in the order of their tiles and buildings, and where each tile begins; at the end how many
// boxes there are.
struct Tiles {
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> first;
  double side = 0;  // metres
};

Tiles tiles_of(const BoxArrays& arrays) {
  geom::Aabb around = arrays.boxes.front();
  for (const geom::Aabb& box : arrays.boxes) {
    around = {around.min.cwiseMin(box.min), around.max.cwiseMax(box.max)};
  }
  const geom::Vec3 size = around.max - around.min;
  const double tiles = static_cast<double>(arrays.boxes.size() / kATile);
  Tiles out;
  out.side = std::max(std::sqrt(size.x() * size.y() / tiles), size.head<2>().maxCoeff() / tiles);
  const auto tile = [&](std::uint32_t i) {
    const geom::Vec3 at = 0.5 * (arrays.boxes[i].min + arrays.boxes[i].max) - around.min;
    return std::pair(std::floor(at.y() / out.side), std::floor(at.x() / out.side));
  };
  const auto key = [&](std::uint32_t i) {
    return std::tuple(tile(i), arrays.traits[i] >= 128, arrays.buildings.of[i], i);
  };
  out.order.resize(arrays.boxes.size());
  std::iota(out.order.begin(), out.order.end(), 0u);
  std::sort(out.order.begin(), out.order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::uint32_t i = 0; i < out.order.size(); ++i) {
    if (i == 0 || tile(out.order[i]) != tile(out.order[i - 1])) out.first.push_back(i);
  }
  out.first.push_back(static_cast<std::uint32_t>(out.order.size()));
  return out;
}

template <class T>
std::vector<T> in_order(const std::vector<T>& list, const std::vector<std::uint32_t>& order) {
  std::vector<T> out;
  if (list.empty()) return out;
  for (const std::uint32_t i : order) out.push_back(list[i]);
  return out;
}

// What is drawn from afar: in each tile and building blocks instead of boxes.
struct FarLevel {
  double cell = 0;
  std::vector<geom::Aabb> blocks;
  std::vector<std::uint32_t> of;     // of each block the first box of its tile and building
  std::vector<std::uint32_t> first;  // of each tile; at the end how many blocks there are
};

FarLevel far_level(const BoxArrays& arrays, const Tiles& tiles, double cell) {
  FarLevel out{cell, {}, {}, {}};
  for (std::size_t t = 0; t + 1 < tiles.first.size(); ++t) {
    out.first.push_back(static_cast<std::uint32_t>(out.blocks.size()));
    for (std::uint32_t i = tiles.first[t]; i < tiles.first[t + 1];) {
      std::uint32_t end = i + 1;
      const auto same = [&](std::uint32_t k) {
        return arrays.buildings.of[k] == arrays.buildings.of[i] &&
               (arrays.traits[k] >= 128) == (arrays.traits[i] >= 128);
      };
      while (end < tiles.first[t + 1] && same(end)) ++end;
      for (const geom::Aabb& block :
           geom::far_blocks(std::span(arrays.boxes).subspan(i, end - i), cell)) {
        out.blocks.push_back(block);
        out.of.push_back(i);
      }
      i = end;
    }
  }
  out.first.push_back(static_cast<std::uint32_t>(out.blocks.size()));
  return out;
}

Json far_json(const FarLevel& level, Bundle& bundle) {
  return {{"cell", level.cell},
          {"count", level.blocks.size()},
          {"corners", packed_boxes(level.blocks, bundle)},
          {"of", packed(level.of, bundle)},
          {"first", packed(level.first, bundle)}};
}

// Of things that stand there the lowest top, that of 98 of 100, and the highest.
Json tops(const BoxArrays& arrays) {
  std::vector<float> all;
  for (std::size_t i = 0; i < arrays.boxes.size(); ++i) {
    if (arrays.traits[i] < 128) all.push_back(static_cast<float>(arrays.boxes[i].max.z()));
  }
  if (all.empty()) return {0, 1, 1};
  std::sort(all.begin(), all.end());
  return {all.front(), all[all.size() * 98 / 100], all.back()};
}

Json large_layer(BoxArrays arrays, Bundle& bundle) {
  const Tiles tiles = tiles_of(arrays);
  arrays.boxes = in_order(arrays.boxes, tiles.order);
  arrays.ids = in_order(arrays.ids, tiles.order);
  arrays.labels = in_order(arrays.labels, tiles.order);
  arrays.buildings.of = in_order(arrays.buildings.of, tiles.order);
  arrays.traits = in_order(arrays.traits, tiles.order);
  const std::vector<std::uint32_t> traits(arrays.traits.begin(), arrays.traits.end());
  Json out = {{"step", kStep}, {"corners", packed_boxes(arrays.boxes, bundle)}};
  if (!arrays.labels.empty()) out["label"] = packed(arrays.labels, bundle);
  if (!arrays.ids.empty()) out["ids"] = packed(arrays.ids, bundle);
  out["building"] = packed(arrays.buildings.of, bundle);
  out["traits"] = packed(traits, bundle);
  out["tiles"] = packed(tiles.first, bundle);
  out["far"] = Json::array();
  double most = static_cast<double>(arrays.boxes.size());
  for (double cell = tiles.side * kFinest; cell < tiles.side; cell *= kCoarser) {
    const FarLevel level = far_level(arrays, tiles, cell);
    const auto count = static_cast<double>(level.blocks.size());
    if (count > kFewer * most && !out["far"].empty()) break;
    out["far"].push_back(far_json(level, bundle));
    most = count;
  }
  return out;
}

// Whether the corners in steps fit into 31 bits.
bool within_reach(std::span<const geom::Aabb> boxes) {
  return std::all_of(boxes.begin(), boxes.end(), [](const geom::Aabb& box) {
    return box.min.minCoeff() > -1e6 && box.max.maxCoeff() < 1e6;
  });
}

}  // namespace

Json box_layer(const geom::BoxMap& map, const LocalFrame& frame, Bundle& bundle) {
  BoxArrays arrays = arrays_of(map, frame);
  const Json buildings = {{"buildings", arrays.buildings.count},
                          {"typical", arrays.buildings.typical},
                          {"tops", tops(arrays)}};
  const bool few = arrays.boxes.size() <= kFew || !within_reach(arrays.boxes);
  Json out = few ? small_layer(arrays, bundle) : large_layer(std::move(arrays), bundle);
  out.update(buildings);
  return out;
}

}  // namespace view
