#pragma once

// A map's file taken apart, to be put together again with other contents and the right checksums.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "geom/archive/array_archive.h"
#include "geom/map/box_map.h"
#include "geom/map/box_map_file.h"

namespace support {

inline std::vector<std::byte> bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

inline std::vector<std::byte> file_of(const geom::BoxMap& map) {
  std::ostringstream out;
  geom::write_box_map(out, map);
  return bytes_of(out.str());
}

struct EditedMap {
  nlohmann::json meta;
  std::vector<double> boxes;
  std::vector<std::uint64_t> ids;
  std::vector<std::uint32_t> label;
  std::vector<std::int32_t> tile_index;
  std::vector<std::uint8_t> tile_large;
  std::vector<double> tile_extent;
  std::vector<std::uint64_t> tile_range;
  std::vector<std::uint64_t> timed;
  std::vector<double> times;

  explicit EditedMap(const geom::BoxMap& map) {
    const auto archive = geom::ArrayArchive::from_bytes(file_of(map), "map");
    const auto copy = [](auto& to, auto from) { to.assign(from.begin(), from.end()); };
    meta = nlohmann::json::parse(archive.meta());
    copy(boxes, archive.array<double>("boxes", 6));
    copy(ids, archive.array<std::uint64_t>("ids"));
    copy(label, archive.array<std::uint32_t>("label"));
    copy(tile_index, archive.array<std::int32_t>("tile_index", 2));
    copy(tile_large, archive.array<std::uint8_t>("tile_large"));
    copy(tile_extent, archive.array<double>("tile_extent", 6));
    copy(tile_range, archive.array<std::uint64_t>("tile_range", 2));
    if (!archive.has("timed")) return;
    copy(timed, archive.array<std::uint64_t>("timed"));
    copy(times, archive.array<double>("times", 2));
  }

  std::size_t tiles() const { return tile_large.size(); }
  std::size_t size() const { return ids.size(); }

  // Leaves box i out, and what the tiles and the meta say of their numbers as it then is.
  void remove(std::size_t i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    boxes.erase(boxes.begin() + 6 * at, boxes.begin() + 6 * at + 6);
    ids.erase(ids.begin() + at);
    label.erase(label.begin() + at);
    meta["boxes"] = ids.size();
    for (std::size_t t = 0; t < tiles(); ++t) {
      std::uint64_t& first = tile_range[2 * t];
      std::uint64_t& count = tile_range[2 * t + 1];
      if (first > i) {
        --first;
      } else if (first + count > i) {
        --count;
      }
    }
  }

  std::vector<std::byte> file() const {
    using geom::named_array;
    const auto view = [](const auto& v) { return std::span(v); };
    std::vector<geom::NamedArray> arrays = {
        named_array<double>("boxes", view(boxes), 6),
        named_array<std::uint64_t>("ids", view(ids)),
        named_array<std::uint32_t>("label", view(label)),
        named_array<std::int32_t>("tile_index", view(tile_index), 2),
        named_array<std::uint8_t>("tile_large", view(tile_large)),
        named_array<double>("tile_extent", view(tile_extent), 6),
        named_array<std::uint64_t>("tile_range", view(tile_range), 2),
    };
    if (!timed.empty()) arrays.push_back(named_array<std::uint64_t>("timed", view(timed)));
    if (!times.empty()) arrays.push_back(named_array<double>("times", view(times), 2));
    std::ostringstream out;
    geom::write_array_archive(out, meta.dump(), arrays);
    return bytes_of(out.str());
  }

  geom::ArrayArchive archive() const { return geom::ArrayArchive::from_bytes(file(), "map"); }
  geom::BoxMap map() const { return geom::read_box_map(archive()); }
};

}  // namespace support
