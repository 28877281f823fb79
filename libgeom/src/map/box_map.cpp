#include "geom/map/box_map.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "box_map_data.h"
#include "geom/base/error.h"
#include "hash.h"
#include "tile_order.h"
#include "verify.h"

namespace geom {
namespace {

struct Placed {
  Place place;
  std::size_t box;  // of the table
};

// By tile first, and the boxes of each tile among themselves: these are few, where a comparison of
// any two boxes would look for both all over the table.
std::vector<Placed> in_order(double tile_size, const BoxTable& table) {
  std::vector<Placed> order;
  order.reserve(table.boxes.size());
  for (const Aabb& box : table.boxes) order.push_back({place_of(box, tile_size), order.size()});
  std::sort(order.begin(), order.end(), [](const Placed& a, const Placed& b) {
    return a.place != b.place ? a.place < b.place : a.box < b.box;
  });
  const auto comes_first = [&](const Placed& one, const Placed& other) {
    const std::size_t a = one.box;
    const std::size_t b = other.box;
    if (!(table.boxes[a] == table.boxes[b])) return comes_before(table.boxes[a], table.boxes[b]);
    if (table.ids[a] != table.ids[b]) return table.ids[a] < table.ids[b];
    if (const auto times = table.time(a) <=> table.time(b); times != 0) return times < 0;
    return a < b;
  };
  for (auto first = order.begin(); first != order.end();) {
    const auto last =
        std::find_if(first, order.end(), [&](const Placed& p) { return p.place != first->place; });
    std::sort(first, last, comes_first);
    first = last;
  }
  return order;
}

std::shared_ptr<BoxMap::Data> sorted_into_tiles(BoxMapSpec spec, const BoxTable& table) {
  static_assert(sizeof(Aabb) == 6 * sizeof(double) && std::endian::native == std::endian::little);
  for (const TimeSpan& span : table.times) {
    if (const auto fault = span_fault(span)) throw InputError("the map", *fault);
  }
  const std::vector<Placed> order = in_order(spec.tile_size, table);
  auto data = std::make_shared<BoxMap::Data>();
  auto own = std::make_shared<BoxMap::Data::Owned>();
  std::vector<Tile> tiles;
  own->boxes.reserve(order.size());
  own->ids.reserve(order.size());
  own->label.reserve(order.size());
  for (const auto& [place, i] : order) {
    const bool new_tile = own->boxes.empty() || place != order[own->boxes.size() - 1].place;
    const Aabb box = canonical(table.boxes[i]);
    if (new_tile) {
      tiles.push_back({place.ix, place.iy, !place.small, box, own->boxes.size(), 0});
    }
    Tile& tile = tiles.back();
    tile.extent = merged(tile.extent, box);
    ++tile.count;
    if (const TimeSpan time = canonical(table.time(i)); !time.always()) {
      own->timed.push_back(own->boxes.size());
      own->times.push_back(time);
    }
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
  data->timed = {own->timed, own->times};
  if (const auto fault = timed_fault(data->timed, data->boxes.size(), data->spec.epoch)) {
    throw InputError("the map", *fault);
  }
  data->hash = hash_of(data->spec, tiles, data->boxes, data->timed, {});
  data->tiles.set(std::move(tiles));
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
  const Tile at = data_->tiles[tile];
  return data_->boxes.subspan(at.first, at.count);
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
  return data_->tiles.all();
}
std::span<const std::uint64_t> BoxMap::timed() const { return data_->timed.box; }
std::span<const TimeSpan> BoxMap::times() const { return data_->timed.time; }
TimeSpan BoxMap::time(std::size_t i) const { return data_->timed.of(i); }
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
