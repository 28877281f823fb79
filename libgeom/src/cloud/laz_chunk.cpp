#include "laz_chunk.h"

#include <fmt/format.h>

#include <algorithm>

#include "laz_items.h"

namespace geom {
namespace {

constexpr std::uint64_t kUsual = 50000;        // points that most writers put into a chunk
constexpr std::uint64_t kMostHeld = 1U << 18;  // points; of more a chunk is decoded as it is taken

}  // namespace

LazChunk LazChunk::of_layers(ByteSource& bytes, const LazSetup& setup, std::uint64_t at_most) {
  LazChunk out;
  out.at_ = bytes.position();
  LazLayers layers = read_laz_layers(bytes, setup, at_most);
  out.end_ = bytes.position();
  out.points_ = layers.points;
  out.code_ = std::move(layers);
  return out;
}

LazChunk LazChunk::of_items(ByteSource& bytes, std::uint64_t points, std::uint64_t size) {
  LazChunk out;
  out.at_ = bytes.position();
  std::vector<unsigned char> code;
  bytes.read(size, code);
  out.end_ = bytes.position();
  out.points_ = points;
  out.code_ = std::move(code);
  return out;
}

void LazChunk::decode(const LazSetup& setup, std::string_view source) {
  if (points_ > kMostHeld) return;
  std::vector<LazPoint> points;
  for_each(setup, source, [&](const LazPoint& p) { points.push_back(p); });
  decoded_ = std::move(points);
  code_ = {};
}

void LazChunk::for_each(const LazSetup& setup, std::string_view source,
                        const LazPointSink& sink) const {
  if (!decoded_.empty()) {
    for (const LazPoint& p : decoded_) sink(p);
    return;
  }
  if (const auto* layers = std::get_if<LazLayers>(&code_)) {
    return decode_laz_layers(*layers, setup, source, sink);
  }
  ByteSource from(std::get<std::vector<unsigned char>>(code_), at_, source);
  read_laz_items(from, setup, points_, sink);
  if (from.position() == end_) return;
  from.refuse({.says = fmt::format("its table of chunks says that a chunk of {} points at byte {} "
                                   "has {} bytes, and it has {}",
                                   points_, at_, bytes(), from.position() - at_)});
}

void read_laz_items(ByteSource& bytes, const LazSetup& setup, std::uint64_t points,
                    const LazPointSink& sink) {
  std::vector<unsigned char> first;
  bytes.read(setup.point_bytes, first);
  const auto items = laz_item_decoders(setup, first);
  LazPoint point = first_laz_point(setup, first);
  sink(point);
  RangeDecoder code(bytes);
  for (std::uint64_t i = 1; i < points; ++i) {
    for (const auto& item : items) item->next(code, point);
    sink(point);
  }
  code.require_end();
}

std::size_t laz_window(const Execution& run, std::uint64_t most_points) {
  if (run.threads <= 1) return 1;
  const std::uint64_t most = 12 * std::uint64_t{run.threads};
  return std::clamp<std::uint64_t>(most * kUsual / std::max<std::uint64_t>(most_points, 1), 3,
                                   most);
}

}  // namespace geom
