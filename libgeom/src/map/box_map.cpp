#include "geom/map/box_map.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>
#include <tuple>

#include "box_map_data.h"
#include "hash.h"
#include "tile_order.h"
#include "verify.h"

namespace geom {
namespace {

std::shared_ptr<BoxMap::Data> sorted_into_tiles(BoxMapSpec spec, const BoxTable& table) {
  static_assert(sizeof(Aabb) == 6 * sizeof(double) && std::endian::native == std::endian::little);
  const std::size_t n = table.boxes.size();
  std::vector<Place> place(n);
  for (std::size_t i = 0; i < n; ++i) place[i] = place_of(table.boxes[i], spec.tile_size);
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (place[a] != place[b]) return place[a] < place[b];
    if (!(table.boxes[a] == table.boxes[b])) return comes_before(table.boxes[a], table.boxes[b]);
    return std::tie(table.ids[a], a) < std::tie(table.ids[b], b);
  });

  auto data = std::make_shared<BoxMap::Data>();
  auto own = std::make_shared<BoxMap::Data::Owned>();
  for (const std::size_t i : order) {
    const bool new_tile = own->boxes.empty() || place[i] != place[order[own->boxes.size() - 1]];
    const Aabb box = canonical(table.boxes[i]);
    if (new_tile) {
      const auto [small, iy, ix] = place[i];
      data->tiles.push_back({ix, iy, !small, box, own->boxes.size(), 0});
    }
    Tile& tile = data->tiles.back();
    tile.extent = merged(tile.extent, box);
    ++tile.count;
    own->boxes.push_back(box);
    own->ids.push_back(table.ids[i]);
    own->label.push_back(table.label[i]);
  }
  spec.bounds = canonical(spec.bounds);
  data->spec = std::move(spec);
  data->labels = table.labels;
  data->boxes = own->boxes;
  data->ids = own->ids;
  data->label = own->label;
  data->hash = hash_of(data->spec, data->tiles, data->boxes, {});
  data->owned = std::move(own);
  return data;
}

}  // namespace

BoxMap::BoxMap(BoxMapSpec spec, const BoxTable& table)
    : data_(sorted_into_tiles(std::move(spec), table)) {}
BoxMap::BoxMap(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

const BoxMapSpec& BoxMap::spec() const { return data_->spec; }
std::size_t BoxMap::size() const { return data_->boxes.size(); }
std::size_t BoxMap::tile_count() const { return data_->tiles.size(); }
std::span<const Aabb> BoxMap::boxes() const {
  require(Verified::extents);
  return data_->boxes;
}
std::span<const Aabb> BoxMap::boxes_of(std::size_t tile) const {
  require(Verified::extents);
  return data_->boxes.subspan(data_->tiles[tile].first, data_->tiles[tile].count);
}
const Aabb& BoxMap::box(std::size_t i) const {
  assert(verified() >= Verified::extents);
  return data_->boxes[i];
}
std::span<const std::uint64_t> BoxMap::ids() const { return data_->ids; }
std::span<const std::uint32_t> BoxMap::label() const {
  require(Verified::extents);
  return data_->label;
}
const std::vector<std::string>& BoxMap::labels() const { return data_->labels; }
std::span<const Tile> BoxMap::tiles() const {
  require(Verified::extents);
  return data_->tiles;
}
const std::string& BoxMap::hash() const { return data_->hash; }

Verified BoxMap::verified() const { return data_->verified.load(std::memory_order_acquire); }

void BoxMap::require(Verified level, const Execution& run) const {
  if (verified() >= level) return;
  const std::lock_guard lock(data_->verifying);
  if (verified() < Verified::extents) {
    verify_extents(*data_, run);
    data_->verified.store(Verified::extents, std::memory_order_release);
  }
  if (verified() < level) {
    verify_contents(*data_, run);
    data_->verified.store(Verified::contents, std::memory_order_release);
  }
}

}  // namespace geom
