#include "geom/map/box_map_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <tuple>

#include "base/unchanged_file.h"
#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"
#include "map/box_map_data.h"

namespace geom {
namespace {

constexpr int kVersion = 1;
constexpr int kTimedVersion = 2;  // of maps of which some boxes are not always there
using Json = nlohmann::json;

std::string meta_of(const BoxMap& map) {
  const BoxMapSpec& spec = map.spec();
  JsonLine meta;
  meta.add("format", "skyway-boxmap")
      .add("version", map.timed().empty() ? kVersion : kTimedVersion);
  meta.add("hash", map.hash());
  meta.add("frame", name(spec.frame.axes));
  if (const auto& origin = spec.frame.origin) {
    meta.add("origin", std::tuple(origin->latitude, origin->longitude, origin->height));
  }
  meta.add("epoch", spec.epoch);
  meta.add("crs", spec.frame.crs).add("bounds", std::tuple(spec.bounds.min, spec.bounds.max));
  meta.add("bounds_from", spec.bounds_from).add("tile_size", spec.tile_size);
  meta.add("boxes", map.boxes().size()).add("labels", map.labels());
  meta.add_json("history", spec.history.empty() ? "[]" : spec.history);
  return meta.line();
}

[[noreturn]] void refuse(const ArrayArchive& archive, Fault fault) {
  throw InputError(archive.name(), std::move(fault));
}

JsonFields meta_fields(const ArrayArchive& archive) {
  return {archive.meta(), archive.name() + ": meta.json", 0};
}

void require_box_map(const JsonFields& meta) {
  const auto found = [&](const char* key) {
    return meta.has(key) ? shown(meta.value(key)) : std::string("none");
  };
  if (found("format") != "\"skyway-boxmap\"") {
    meta.refuse({.expected = "a box map (format \"skyway-boxmap\")",
                 .found = fmt::format("format {}", found("format"))});
  }
  if (found("version") != std::to_string(kVersion) &&
      found("version") != std::to_string(kTimedVersion)) {
    meta.refuse({.expected = fmt::format("box map version {} or {}", kVersion, kTimedVersion),
                 .found = std::string(found("version"))});
  }
}

std::vector<std::string> labels_of(const JsonFields& meta) {
  std::vector<std::string> labels;
  const Json listed = meta.has("labels") ? meta.value("labels") : Json();
  if (!listed.is_array())
    meta.refuse({.key = "labels", .expected = "a list", .found = shown(listed)});
  for (const Json& label : listed) {
    if (!label.is_string())
      meta.refuse({.key = "a label", .expected = "a string", .found = shown(label)});
    labels.push_back(label.get<std::string>());
  }
  if (labels.empty() || !labels.front().empty()) {
    meta.refuse({.key = "labels[0]", .expected = "\"\", the label of boxes without one"});
  }
  return labels;
}

BoxMapSpec spec_of(const JsonFields& meta) {
  BoxMapSpec spec;
  const auto axes = value_of(kAxesWords, meta.text("frame"));
  if (!axes) {
    meta.refuse(
        {.key = "frame", .expected = "\"enu\" or \"neu\"", .found = shown(meta.value("frame"))});
  }
  spec.frame.axes = *axes;
  if (meta.has("origin")) {
    const Vec3 origin = meta.point("origin");
    spec.frame.origin = GeodeticOrigin{origin[0], origin[1], origin[2]};
  }
  if (meta.has("epoch")) spec.epoch = meta.text("epoch");
  spec.frame.crs = meta.text("crs");
  const std::vector<Vec3> corners = meta.points("bounds");
  if (corners.size() != 2 || (corners[0].array() > corners[1].array()).any()) {
    meta.refuse({.key = "bounds",
                 .expected = "two corners, min <= max",
                 .found = shown(meta.value("bounds"))});
  }
  spec.bounds = {corners[0], corners[1]};
  spec.bounds_from = meta.text("bounds_from");
  spec.tile_size = meta.number("tile_size").value_or(0);
  if (!(spec.tile_size >= 1 && spec.tile_size <= kLargestCoordinate)) {
    meta.refuse({.key = "tile_size",
                 .expected = "from 1 m to 1e8 m",
                 .found = fmt::to_string(spec.tile_size)});
  }
  const Json steps = meta.has("history") ? meta.value("history") : Json();
  if (!steps.is_array())
    meta.refuse({.key = "history", .expected = "a list", .found = shown(steps)});
  spec.history = steps.dump();
  return spec;
}

// The first tile that is none, or out of order. All tiles are looked at to open a map, so this is
// done in few operations and without branches.
std::optional<std::size_t> wrong_tile(const TileTable::Columns& columns, std::size_t boxes) {
  std::size_t next = 0;  // no more than there are
  for (std::size_t t = 0; t < columns.large.size(); ++t) {
    const double* const e = &columns.extent[6 * t];
    bool ok = true;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      ok &= e[k] >= -kLargestCoordinate;  // false of what is not a number
      ok &= e[3 + k] <= kLargestCoordinate;
      ok &= e[k] <= e[3 + k];
    }
    const std::uint64_t first = columns.range[2 * t];
    const std::uint64_t count = columns.range[2 * t + 1];
    ok &= first == next;
    ok &= count - 1 < boxes - next;  // none would be the largest number
    if (t > 0) {
      const std::int32_t* const at = &columns.index[2 * t];  // column, row
      const bool later = at[1] > at[-1] || (at[1] == at[-1] && at[0] > at[-2]);
      ok &= columns.large[t] == 0 && (later || columns.large[t - 1] != 0);
    }
    if (!ok) return t;
    next += count;
  }
  return std::nullopt;
}

// The rows are looked at where they stand, and not copied.
void read_tiles(const ArrayArchive& archive, BoxMap::Data& data) {
  const TileTable::Columns columns{
      archive.array<std::int32_t>("tile_index", 2), archive.array<std::uint8_t>("tile_large"),
      archive.array<double>("tile_extent", 6), archive.array<std::uint64_t>("tile_range", 2)};
  const std::size_t n = columns.large.size();
  if (columns.index.size() != 2 * n || columns.extent.size() != 6 * n ||
      columns.range.size() != 2 * n) {
    refuse(archive, {.says = "the tile arrays must have one row a tile, and their lengths differ"});
  }
  data.tiles.set(columns);
  if (const auto wrong = wrong_tile(columns, data.boxes.size())) {
    refuse(archive,
           {.says = fmt::format("tile {} is out of order, empty, or beyond the boxes", *wrong)});
  }
  const std::size_t next = n == 0 ? 0 : columns.range[2 * n - 2] + columns.range[2 * n - 1];
  if (next != data.boxes.size()) {
    refuse(archive, {.says = fmt::format("the tiles must hold all {} boxes, and hold {}",
                                         data.boxes.size(), next)});
  }
}

// They are few, so all of them are looked at to open a map: whoever has it need not ask again.
void read_timed(const ArrayArchive& archive, const JsonFields& meta, BoxMap::Data& data) {
  const bool said = meta.number("version") == kTimedVersion;
  const bool there = archive.has("timed") || archive.has("times");
  if (said != there) {
    if (there) {
      meta.refuse({.key = "a map with the arrays timed and times",
                   .expected = "of version 2",
                   .found = "1"});
    }
    meta.refuse(
        {.says = "a map of version 2 must have the arrays timed and times", .found = "none"});
  }
  if (there) {
    const auto ends = archive.array<double>("times", 2);
    data.timed = {archive.array<std::uint64_t>("timed"),
                  {reinterpret_cast<const TimeSpan*>(ends.data()), ends.size() / 2}};
    if (data.timed.box.empty() && data.timed.time.empty()) {
      meta.refuse({.says = "a map of version 2 must have boxes that are there for a time",
                   .found = "none"});
    }
  }
  if (const auto fault = timed_fault(data.timed, data.boxes.size(), data.spec.epoch)) {
    meta.refuse(*fault);
  }
}

}  // namespace

void write_box_map(std::ostream& out, const BoxMap& map) {
  std::vector<std::int32_t> index;
  std::vector<std::uint8_t> large;
  std::vector<double> extent;
  std::vector<std::uint64_t> range;
  for (const Tile& tile : map.tiles()) {
    index.insert(index.end(), {tile.ix, tile.iy});
    large.push_back(tile.large);
    extent.insert(extent.end(), tile.extent.min.begin(), tile.extent.min.end());
    extent.insert(extent.end(), tile.extent.max.begin(), tile.extent.max.end());
    range.insert(range.end(), {tile.first, tile.count});
  }
  const std::span<const double> boxes(reinterpret_cast<const double*>(map.boxes().data()),
                                      6 * map.boxes().size());
  std::vector<NamedArray> arrays = {
      named_array<double>("boxes", boxes, 6),
      named_array<std::uint64_t>("ids", map.ids()),
      named_array<std::uint32_t>("label", map.label()),
      named_array<std::int32_t>("tile_index", index, 2),
      named_array<std::uint8_t>("tile_large", large),
      named_array<double>("tile_extent", extent, 6),
      named_array<std::uint64_t>("tile_range", range, 2),
  };
  if (!map.timed().empty()) {
    static_assert(sizeof(TimeSpan) == 2 * sizeof(double));
    const std::span<const double> times(reinterpret_cast<const double*>(map.times().data()),
                                        2 * map.times().size());
    arrays.push_back(named_array<std::uint64_t>("timed", map.timed()));
    arrays.push_back(named_array<double>("times", times, 2));
  }
  write_array_archive(out, meta_of(map), arrays);
}

bool is_box_map(const ArrayArchive& archive) {
  const JsonFields meta = meta_fields(archive);
  return meta.text("format", "") == "skyway-boxmap";
}

BoxMap read_box_map(const ArrayArchive& archive, Verified known) {
  auto data = std::make_shared<BoxMap::Data>();
  const JsonFields meta = meta_fields(archive);
  require_box_map(meta);
  data->spec = spec_of(meta);
  data->labels = labels_of(meta);
  data->hash = meta.text("hash");
  const auto boxes = archive.array<double>("boxes", 6);
  data->boxes = {reinterpret_cast<const Aabb*>(boxes.data()), boxes.size() / 6};
  data->ids = archive.array<std::uint64_t>("ids");
  data->label = archive.array<std::uint32_t>("label");
  if (meta.number("boxes") != static_cast<double>(data->boxes.size())) {
    meta.refuse({.key = "boxes",
                 .expected = fmt::format("{}, the number of rows", data->boxes.size()),
                 .found = fmt::to_string(meta.number("boxes").value_or(0))});
  }
  if (data->ids.size() != data->boxes.size() || data->label.size() != data->boxes.size()) {
    refuse(archive,
           {.says = fmt::format("ids and label must have {} entries, one a box, and have {} and {}",
                                data->boxes.size(), data->ids.size(), data->label.size())});
  }
  read_tiles(archive, *data);
  read_timed(archive, meta, *data);
  data->archive = archive;
  data->verified = known;
  return BoxMap(data);
}

void require_unchanged(const BoxMap& map) {
  const auto& archive = map.data().archive;
  if (archive && archive->file()) require_unchanged_at(archive->meta().data());
}

BoxMap open_map(const std::string& path) { return read_box_map(ArrayArchive::map(path)); }

}  // namespace geom
