#include <fmt/format.h>

#include "byte_source.h"
#include "geom/cloud/cloud_format.h"
#include "geom/cloud/point_cloud.h"
#include "geom/text/beginning.h"
#include "geom/text/counted.h"
#include "las_header.h"
#include "las_records.h"
#include "laz_chunks.h"
#include "point_chunks.h"

// LAS 1.4 R15 (ASPRS 2019), tables 7 to 17: offsets below are those of the specification.

namespace geom {
namespace {

constexpr std::size_t kLaterHead = 60;

using Bytes = std::vector<unsigned char>;

// Whether points that the header does not count follow those it does: `room` bytes or more up to
// where the next part of the file begins, or its end. Gives the bytes that were read to tell this.
Bytes require_no_more(ByteSource& rest, const LasHeader& h, std::size_t room) {
  const std::uint64_t end = rest.position();
  std::uint64_t next = std::numeric_limits<std::uint64_t>::max();
  if (h.later_count > 0 && h.later_records >= end) next = h.later_records;
  if (h.waveforms >= end) next = std::min(next, h.waveforms);
  const bool known_end = next != std::numeric_limits<std::uint64_t>::max();
  Bytes read(known_end ? 0 : room);
  const std::size_t got = rest.copy(read);
  if (known_end ? next - end >= room : got == room) {
    rest.refuse({.says = fmt::format("expected {} points of {} bytes, and the file holds more",
                                     h.points, h.record)});
  }
  read.resize(got);
  return read;
}

// What follows the points must say nothing of the coordinates that the records before do not.
void require_told_before(ByteSource& rest, const LasHeader& h, const LasRecords& told,
                         const Bytes& before) {
  LaterReferences later(told.references, h.well_known_text);
  later.take(before);
  Bytes piece(1 << 16);
  const auto pass = [&](std::uint64_t bytes) {  // false where there were less
    while (bytes > 0) {
      const std::size_t some = std::min<std::uint64_t>(bytes, piece.size());
      const std::size_t got = rest.copy({piece.data(), some});
      later.take({piece.data(), got});
      if (got < some) return false;
      bytes -= got;
    }
    return true;
  };
  const std::uint64_t end = rest.position();
  if (h.later_count > 0 && h.later_records < end) {
    rest.refuse({.expected = fmt::format("its later records after byte {}", end),
                 .found = fmt::format("them at {}", h.later_records)});
  }
  bool whole = h.later_count == 0 || pass(h.later_records - end);
  for (std::uint32_t i = 0; whole && i < h.later_count; ++i) {
    whole = pass(kLaterHead) && pass(number_at<std::uint64_t>(&piece[20]));
  }
  if (!whole) rest.refuse({.says = "its records after the points are cut short"});
  pass(std::numeric_limits<std::uint64_t>::max());
  later.finish();
}

// Of one record, without compression.
void add_point(const unsigned char* record, const LasHeader& h, PointChunks& chunks) {
  const Vec3 raw(number_at<std::int32_t>(record), number_at<std::int32_t>(record + 4),
                 number_at<std::int32_t>(record + 8));
  const std::uint8_t cls = h.modern() ? record[16] : static_cast<std::uint8_t>(record[15] & 0x1f);
  chunks.add(raw.cwiseProduct(h.scale) + h.offset, cls);
}

// Each gives what it read behind the points.
Bytes read_points(ByteSource& bytes, const LasHeader& h, PointChunks& chunks) {
  Bytes split(h.record);  // one whose parts do not lie together
  for (std::uint64_t i = 0; i < h.points;) {
    const std::span<const unsigned char> ready = bytes.ready();
    const std::uint64_t whole = std::min<std::uint64_t>(h.points - i, ready.size() / h.record);
    for (std::uint64_t k = 0; k < whole; ++k) add_point(&ready[k * h.record], h, chunks);
    bytes.skip(whole * h.record);
    i += whole;
    if (whole > 0) continue;
    if (bytes.copy(split) < h.record) {
      bytes.refuse({.says = fmt::format("expected {}, and the file ends after {}",
                                        counted(h.points, "point"), i)});
    }
    add_point(split.data(), h, chunks);
    ++i;
  }
  return require_no_more(bytes, h, h.record);
}

Bytes read_compressed(ByteSource& bytes, const LasHeader& h, const LazSetup& setup,
                      const LasReading& reading, PointChunks& chunks) {
  for_each_laz_point(bytes, setup, h.points, reading, [&](const LazPoint& p) {
    chunks.add(Vec3(p.x, p.y, p.z).cwiseProduct(h.scale) + h.offset, p.cls);
  });
  // Some writers leave a few bytes behind the table of chunks; a second file would be longer.
  constexpr std::size_t kLeastFile = 227;
  return require_no_more(bytes, h, setup.layout == LazSetup::Layout::one_stream ? 1 : kLeastFile);
}

}  // namespace

CloudCounts read_las(std::istream& in, std::string_view source, const PointSink& sink,
                     const ReferenceSink& reference, const LasReading& reading) {
  const LasHeader h = read_las_header(in, source);
  const LasRecords told = read_las_records(in, h, source);
  if (reference) reference(told.reference);
  PointChunks chunks(source, sink);
  ByteSource bytes(in, h.data, source);
  const Bytes behind = told.laz ? read_compressed(bytes, h, *told.laz, reading, chunks)
                                : read_points(bytes, h, chunks);
  require_told_before(bytes, h, told, behind);
  return chunks.finish();
}

namespace {

bool is_las(std::string_view head) { return head.starts_with("LASF"); }

// Where the highest bit of the point format is set.
bool is_compressed(std::string_view head) {
  constexpr std::size_t kPointFormat = 104;
  return is_las(head) && head.size() > kPointFormat && (head[kPointFormat] & 0x80) != 0;
}

bool says_copc(std::string_view head) {
  return is_compressed(head) && head.substr(0, 600).find("copc") != head.npos;
}

constexpr std::string_view kReaders[] = {"skyway-cloud"};
constexpr Format kLas{
    .word = "las",
    .what = "a LAS point cloud",
    .begins = [](std::string_view head) { return is_las(head) && !is_compressed(head); },
    .readers = kReaders};
constexpr Format kLaz{
    .what = "a LAZ point cloud",
    .begins = [](std::string_view head) { return is_compressed(head) && !says_copc(head); },
    .readers = kReaders};
constexpr Format kCopc{
    .what = "a COPC point cloud (LAZ)", .begins = says_copc, .readers = kReaders};
constexpr const Format* kKinds[] = {&kLaz, &kCopc};

}  // namespace

constinit const CloudFormat kLasCloud{
    .format = &kLas, .kinds = kKinds, .read = read_las, .is_surveyed = true};

}  // namespace geom
