#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/map/buildings.h"
#include "geom/map/detail_levels.h"
#include "geom/map/label_colour.h"
#include "geom/map/outer_walls.h"
#include "layers.h"

namespace view {
namespace {

constexpr std::size_t kFew = 20000;  // boxes that are drawn as they are
constexpr unsigned kZone = 128;      // the trait of air to keep out of
constexpr double kStep = 0.001;      // metres: to this, corners of many boxes are rounded

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
    const unsigned zone = geom::is_keep_out(map.labels()[map.label()[i]]) ? kZone : 0;
    out.push_back(static_cast<std::uint8_t>(buildings.covered[i] | side << 4 | zone));
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

template <class T>
std::vector<T> in_order(const std::vector<T>& list, const std::vector<std::uint32_t>& order) {
  std::vector<T> out;
  if (list.empty()) return out;
  for (const std::uint32_t i : order) out.push_back(list[i]);
  return out;
}

// `look` has columns: a box of each block, its building, and whether it is air to keep out of.
Json far_json(const geom::FarLevel& level, const BoxArrays& arrays, Bundle& bundle) {
  std::vector<std::vector<std::uint32_t>> look{level.of, {}, {}};
  for (const std::uint32_t box : level.of) {
    look[1].push_back(arrays.buildings.of[box]);
    look[2].push_back(arrays.traits[box] & kZone);
  }
  return {{"cell", level.cell},
          {"count", level.blocks.size()},
          {"corners", packed_boxes(level.blocks, bundle)},
          {"look", bundle.add_packed(look)},
          {"first", packed(level.first, bundle)}};
}

// Of things that stand there the lowest top, that of 98 of 100, and the highest.
Json tops(const BoxArrays& arrays) {
  std::vector<float> all;
  for (std::size_t i = 0; i < arrays.boxes.size(); ++i) {
    if (!(arrays.traits[i] & kZone)) all.push_back(static_cast<float>(arrays.boxes[i].max.z()));
  }
  if (all.empty()) return {0, 1, 1};
  std::sort(all.begin(), all.end());
  return {all.front(), all[all.size() * 98 / 100], all.back()};
}

Json large_layer(BoxArrays arrays, Bundle& bundle) {
  std::vector<std::uint32_t> group;  // air that is kept out of apart from buildings
  for (std::size_t i = 0; i < arrays.boxes.size(); ++i) {
    group.push_back(2 * arrays.buildings.of[i] + ((arrays.traits[i] & kZone) != 0));
  }
  const geom::DetailLevels tiles = geom::detail_levels(arrays.boxes, group);
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
  for (const geom::FarLevel& level : tiles.far)
    out["far"].push_back(far_json(level, arrays, bundle));
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
