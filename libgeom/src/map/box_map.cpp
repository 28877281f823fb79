#include "geom/map/box_map.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "box_map_data.h"
#include "geom/base/error.h"
#include "hash.h"
#include "tile_order.h"
#include "tile_sort.h"
#include "verify.h"

namespace geom {
namespace {

std::size_t timed_in(const BoxTable& table) {
  return static_cast<std::size_t>(
      std::count_if(table.times.begin(), table.times.end(),
                    [](const TimeSpan& time) { return !canonical(time).always(); }));
}

std::shared_ptr<BoxMap::Data> sorted_into_tiles(BoxMapSpec spec, const BoxTable& table,
                                                const Execution& run) {
  static_assert(sizeof(Aabb) == 6 * sizeof(double) && std::endian::native == std::endian::little);
  for (const TimeSpan& span : table.times) {
    if (const auto fault = span_fault(span)) throw InputError("the map", *fault);
  }
  spec.bounds = canonical(spec.bounds);
  MapHash sum(spec, timed_in(table));
  SortedBoxes sorted = sorted_by_tile(table, spec.tile_size, run,
                                      [&](std::span<const Aabb> boxes) { sum.add(boxes); });
  auto data = std::make_shared<BoxMap::Data>();
  data->spec = std::move(spec);
  data->labels = table.labels;
  data->owned = std::move(sorted.boxes);
  data->boxes = data->owned->boxes.all();
  data->ids = data->owned->ids.all();
  data->label = data->owned->label.all();
  data->timed = {data->owned->timed, data->owned->times};
  if (const auto fault = timed_fault(data->timed, data->boxes.size(), data->spec.epoch)) {
    throw InputError("the map", *fault);
  }
  data->hash = sum.text(data->boxes, data->timed);
  data->tiles.set(std::move(sorted.tiles));
  return data;
}

}  // namespace

BoxMap::BoxMap(BoxMapSpec spec, const BoxTable& table)
    : data_(sorted_into_tiles(std::move(spec), table, {})) {}
BoxMap::BoxMap(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
BoxMap box_map_of(BoxMapSpec spec, const BoxTable& table, const Execution& run) {
  return BoxMap(sorted_into_tiles(std::move(spec), table, run));
}

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
