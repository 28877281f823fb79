#include "laz_setup.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "point_chunks.h"

namespace geom {
namespace {

using Kind = LazItem::Kind;

constexpr std::size_t kHead = 34;
constexpr std::size_t kItem = 6;
constexpr unsigned kFirstLayered = 6;  // the first point format of LAS 1.4

[[noreturn]] void refuse(std::string_view source, Fault fault) {
  throw InputError(source, std::move(fault));
}

// The bytes of an item that has one size; 0: any size.
std::size_t size_of(Kind kind) {
  switch (kind) {
    case Kind::point10:
      return 20;
    case Kind::gps_time:
      return 8;
    case Kind::rgb:
    case Kind::rgb14:
      return 6;
    case Kind::rgb_nir14:
      return 8;
    case Kind::wave_packet:
    case Kind::wave_packet14:
      return 29;
    case Kind::point14:
      return 30;
    case Kind::byte:
    case Kind::byte14:
      return 0;
  }
  return 0;
}

LazItem parse_item(const unsigned char* bytes, bool layered, std::string_view source) {
  LazItem item;
  const auto kind = number_at<std::uint16_t>(bytes);
  item.kind = static_cast<Kind>(kind);
  item.size = number_at<std::uint16_t>(bytes + 2);
  item.version = number_at<std::uint16_t>(bytes + 4);
  const bool known = layered ? kind >= 10 && kind <= 14 : kind == 0 || (kind >= 6 && kind <= 9);
  if (!known) {
    refuse(source,
           {.says = fmt::format(
                "its points hold an item of kind {}, which is not one of its point format", kind)});
  }
  if (item.size == 0 || (size_of(item.kind) != 0 && item.size != size_of(item.kind))) {
    refuse(source, {.expected = fmt::format("an item of kind {} to have {} bytes", kind,
                                            size_of(item.kind)),
                    .found = fmt::to_string(item.size)});
  }
  const bool waves = item.kind == Kind::wave_packet;
  const bool read =
      layered ? item.version == 3 : item.version == 1 || (item.version == 2 && !waves);
  if (!read) {
    refuse(
        source,
        {.says = fmt::format("its points are compressed by version {} of item {}, and {} is read",
                             item.version, kind, layered ? "version 3" : "versions 1 and 2"),
         .advice = "write the file anew, for example with `laszip -i in.laz -o out.las`"});
  }
  return item;
}

LazSetup::Layout parse_layout(unsigned compressor, unsigned coder, bool layered,
                              std::string_view source) {
  if (coder != 0) refuse(source, {.expected = "LAZ coder 0", .found = fmt::to_string(coder)});
  const unsigned first = layered ? 3 : 1;
  const unsigned last = layered ? 3 : 2;
  if (compressor < first || compressor > last) {
    refuse(source,
           {.expected = fmt::format("LAZ compressor {} to {} for its point format", first, last),
            .found = fmt::to_string(compressor)});
  }
  constexpr LazSetup::Layout kLayouts[] = {LazSetup::Layout::one_stream, LazSetup::Layout::chunks,
                                           LazSetup::Layout::layers};
  return kLayouts[compressor - 1];
}

}  // namespace

LazSetup parse_laz_setup(std::string_view data, unsigned format, std::size_t point_bytes,
                         std::string_view source) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(data.data());
  if (data.size() < kHead) refuse(source, {.says = "its record \"laszip encoded\" is cut short"});
  const bool layered = format >= kFirstLayered;
  LazSetup setup;
  setup.layout = parse_layout(number_at<std::uint16_t>(bytes), number_at<std::uint16_t>(bytes + 2),
                              layered, source);
  setup.chunk_points = number_at<std::uint32_t>(bytes + 12);
  if (setup.chunk_points == 0)
    refuse(source, {.expected = "chunks of one point or more", .found = "0"});
  const std::size_t items = number_at<std::uint16_t>(bytes + 32);
  if (data.size() < kHead + items * kItem) {
    refuse(source, {.says = fmt::format(
                        "its record \"laszip encoded\" is cut short of its {} items", items)});
  }
  for (std::size_t i = 0; i < items; ++i) {
    setup.items.push_back(parse_item(bytes + kHead + i * kItem, layered, source));
    setup.point_bytes += setup.items.back().size;
    const bool point =
        setup.items.back().kind == Kind::point10 || setup.items.back().kind == Kind::point14;
    if (point != (i == 0)) refuse(source, {.expected = "its items to begin with the one point"});
  }
  if (setup.point_bytes != point_bytes) {
    refuse(source, {.says = fmt::format("its header says {} bytes a point, and its items have {}",
                                        point_bytes, setup.point_bytes)});
  }
  return setup;
}

}  // namespace geom
