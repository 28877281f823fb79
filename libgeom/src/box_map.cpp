#include "geom/box_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

#include "box_map_data.h"
#include "geom/sha256.h"

namespace geom {
namespace {

// Cell indices stay exact in a double and in 32 bits for kLargestCoordinate and tiles of 1 m.
std::int32_t cell(double coordinate, double size) {
  return static_cast<std::int32_t>(std::floor(coordinate / size));
}

struct Place {
  bool small;  // false sorts first: the large tile opens the map
  std::int32_t iy;
  std::int32_t ix;

  friend auto operator<=>(const Place&, const Place&) = default;
};

Place place_of(const Aabb& box, double size) {
  const std::int32_t ix = cell(box.min.x(), size);
  const std::int32_t iy = cell(box.min.y(), size);
  const std::int64_t across = static_cast<std::int64_t>(cell(box.max.x(), size)) - ix + 1;
  const std::int64_t along = static_cast<std::int64_t>(cell(box.max.y(), size)) - iy + 1;
  if (across > 4 || along > 4 || across * along > 4) return {false, 0, 0};
  return {true, iy, ix};
}

bool comes_before(const Aabb& a, const Aabb& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.min[i] != b.min[i]) return a.min[i] < b.min[i];
  }
  for (int i = 0; i < 3; ++i) {
    if (a.max[i] != b.max[i]) return a.max[i] < b.max[i];
  }
  return false;
}

void add_bytes(Sha256& sum, const void* data, std::size_t size) {
  sum.update({static_cast<const std::byte*>(data), size});
}

std::string hash_of(const BoxMapSpec& spec, std::span<const Aabb> boxes) {
  // Tiles sort by position, so the sorted boxes are put in one order that no tile size changes.
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return comes_before(boxes[a], boxes[b]); });
  Sha256 sum;
  std::string head(name(spec.frame.axes));
  head += '\n' + spec.frame.crs + '\n';
  add_bytes(sum, head.data(), head.size());
  if (spec.frame.origin) {
    const double origin[] = {spec.frame.origin->latitude, spec.frame.origin->longitude,
                             spec.frame.origin->height};
    add_bytes(sum, origin, sizeof origin);
  }
  add_bytes(sum, &spec.bounds, sizeof spec.bounds);
  for (const std::size_t i : order) add_bytes(sum, &boxes[i], sizeof boxes[i]);
  return "sha256:" + sum.hex();
}

// -0 and 0 are one value and must be one byte pattern.
Aabb canonical(Aabb box) {
  box.min.array() += 0.0;
  box.max.array() += 0.0;
  return box;
}

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
  data->hash = hash_of(data->spec, data->boxes);
  data->keep_alive = std::move(own);
  return data;
}

}  // namespace

void BoxMap::Data::look_at(std::size_t tile) const {
  if (!check || looked_at[tile].load(std::memory_order_acquire)) return;
  check(tile);
  looked_at[tile].store(true, std::memory_order_release);
}

void BoxMap::Data::look_at_all() const {
  if (!check || all_looked_at.load(std::memory_order_acquire)) return;
  for (std::size_t t = 0; t < tiles.size(); ++t) look_at(t);
  all_looked_at.store(true, std::memory_order_release);
}

BoxMap::BoxMap(BoxMapSpec spec, const BoxTable& table)
    : data_(sorted_into_tiles(std::move(spec), table)) {}
BoxMap::BoxMap(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

const BoxMapSpec& BoxMap::spec() const { return data_->spec; }
std::size_t BoxMap::size() const { return data_->boxes.size(); }
std::span<const Aabb> BoxMap::boxes() const {
  data_->look_at_all();
  return data_->boxes;
}
std::span<const Aabb> BoxMap::boxes_of(std::size_t tile) const {
  data_->look_at(tile);
  return data_->boxes.subspan(data_->tiles[tile].first, data_->tiles[tile].count);
}
const Aabb& BoxMap::box(std::size_t i) const { return data_->boxes[i]; }
std::span<const std::uint64_t> BoxMap::ids() const { return data_->ids; }
std::span<const std::uint32_t> BoxMap::label() const {
  data_->look_at_all();
  return data_->label;
}
const std::vector<std::string>& BoxMap::labels() const { return data_->labels; }
std::span<const Tile> BoxMap::tiles() const { return data_->tiles; }
const std::string& BoxMap::hash() const { return data_->hash; }

}  // namespace geom
