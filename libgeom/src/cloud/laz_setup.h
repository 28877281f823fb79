#pragma once

// How a LAZ file is compressed: the record "laszip encoded" before its points.

#include <cstdint>
#include <string_view>
#include <vector>

namespace geom {

// A part of each point that is compressed by itself.
struct LazItem {
  // The numbers are those of the file. Those from point14 on come with LAS 1.4.
  enum class Kind : std::uint16_t {
    byte = 0,
    point10 = 6,
    gps_time = 7,
    rgb = 8,
    wave_packet = 9,
    point14 = 10,
    rgb14 = 11,
    rgb_nir14 = 12,
    wave_packet14 = 13,
    byte14 = 14,
  };
  Kind kind = Kind::point10;
  std::uint16_t size = 20;  // bytes a point
  std::uint16_t version = 2;
};

struct LazSetup {
  enum class Layout { one_stream, chunks, layers };
  static constexpr std::uint32_t kVaries = 0xFFFFFFFF;

  Layout layout = Layout::chunks;
  std::uint32_t chunk_points = kVaries;  // points a chunk, but for the last
  std::vector<LazItem> items;
  std::size_t point_bytes = 0;  // of all items

  bool chunks_vary() const { return chunk_points == kVaries; }
};

// Reads the record's data. Throws InputError(source, …) where it is cut short, does not fit points
// of `point_bytes` bytes and this format, or names what is not read.
LazSetup parse_laz_setup(std::string_view data, unsigned format, std::size_t point_bytes,
                         std::string_view source);

}  // namespace geom
