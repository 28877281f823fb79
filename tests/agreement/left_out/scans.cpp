// scans [FILES]: random LAS, LAZ and COPC files of all point formats and layouts. No marked point
// is left out in silence (support/left_out.h).

#include <cmath>
#include <cstdlib>

#include "geom/cloud/copc.h"
#include "marked_points.h"
#include "support/copc_file.h"
#include "support/las_file.h"

namespace {

using geom::Vec3;
using support::chance;
using support::CopcFile;
using support::LasFile;
using support::LazFile;
using support::LazFilePoint;
using support::MarkedFile;
using support::one_of;
using support::Outcome;
using support::Random;

// Reads of any place, as a tool has them of a file.
geom::ReadAt at_any_place(const std::string& bytes) {
  return [&bytes](std::uint64_t at, std::span<unsigned char> to) -> std::size_t {
    if (at >= bytes.size()) return 0;
    const std::size_t count = std::min<std::size_t>(to.size(), bytes.size() - at);
    std::memcpy(to.data(), bytes.data() + at, count);
    return count;
  };
}

// With one thread or more, with a second way into the file or without.
Outcome read_las(std::istream& in, const MarkedFile& file) {
  geom::LasReading reading;
  reading.run.threads = 1 + static_cast<unsigned>(file.bytes.size() % 3);
  if (file.bytes.size() % 2) reading.ahead = at_any_place(file.bytes);
  const auto read = [&](std::istream& stream, std::string_view name, const geom::PointSink& sink) {
    return geom::read_las(stream, name, sink, {}, reading);
  };
  return left_out::read_points(read, in, file, 1e-6);
}

std::string some_bytes(Random& random, int most) {
  std::string out(static_cast<std::size_t>(random.below(most)), '\0');
  for (char& c : out) c = static_cast<char>(random.below(256));
  return out;
}

// Axes of their own scale and place, records of others before and behind the points, bytes that
// their writers add, any flags and classes; and counts that are too small or too large.
MarkedFile las(Random& random) {
  LasFile file;
  file.minor = static_cast<unsigned>(random.below(5));
  const int formats[] = {2, 2, 4, 6, 11};
  file.format = static_cast<unsigned>(random.below(formats[file.minor]));
  file.seed = 1 + static_cast<std::uint64_t>(random.below(1 << 30));
  for (int i = 0; i < 3; ++i) {
    file.scale[i] = (chance(random, 8) ? -1 : 1) * std::pow(10, -random.below(7));
    file.offset[i] = chance(random, 2) ? 0 : std::round(random.uniform(-1e6, 1e6));
  }
  if (chance(random, 3)) file.extra = static_cast<std::size_t>(random.below(30));
  if (chance(random, 4)) file.own = static_cast<std::size_t>(random.below(30));
  for (int i = random.below(3); i > 0; --i)
    file.records.push_back({one_of(random, {"a writer", "LASF_Spec", "liblas"}),
                            static_cast<std::uint16_t>(random.below(100)), some_bytes(random, 90)});
  for (int i = random.below(3); i > 0; --i)
    file.later.push_back({"a writer", 7, some_bytes(random, 90)});
  MarkedFile out;
  file.points = left_out::random_places(random);
  for (Vec3& p : file.points) {
    if (chance(random, 2)) p += file.offset;
    p = p.cwiseMin(file.offset + 2e9 * file.scale.cwiseAbs())
            .cwiseMax(file.offset - 2e9 * file.scale.cwiseAbs());
    out.marks.push_back(file.held(p));
  }
  out.bytes = file.bytes();
  if (chance(random, 6)) {
    file.put_count(out.bytes, file.points.size() + (chance(random, 2) ? 1 : -1));
    out.must_tell = true;
  }
  return out;
}

// Points of all cuts into chunks, and other bytes behind them.
MarkedFile laz(Random& random) {
  LazFile file;
  file.format = static_cast<unsigned>(random.below(11));
  const bool modern = file.format >= 6;
  file.version = modern ? 3 : 1 + static_cast<unsigned>(random.below(2));
  file.layout = chance(random, 3)              ? LazFile::Layout::varying
                : !modern && chance(random, 3) ? LazFile::Layout::one_stream
                                               : LazFile::Layout::fixed;
  file.chunk = 1 + static_cast<std::uint32_t>(random.below(60));
  file.extra = chance(random, 2) ? 0 : static_cast<std::uint32_t>(random.below(5));
  file.table_place_at_end = chance(random, 4);
  file.scale = std::pow(10, -random.below(4));
  for (double& v : file.offset) v = chance(random, 2) ? 0 : std::round(random.uniform(-1e6, 1e6));
  file.points = LazFile::scan(static_cast<std::size_t>(1 + random.below(150)),
                              static_cast<std::uint64_t>(random.below(1 << 30)), modern);
  for (LazFilePoint& p : file.points) {
    for (std::int32_t* v : {&p.x, &p.y, &p.z}) *v %= 50000000;  // within 1e8 m
  }
  MarkedFile out;
  for (int i = 0; i < 6; ++i) {
    const LazFilePoint& p = one_of(random, file.points);
    const Vec3 offset(file.offset[0], file.offset[1], file.offset[2]);
    out.marks.push_back(Vec3(p.x, p.y, p.z) * file.scale + offset);
  }
  out.bytes = file.bytes();
  // Elsewhere the code of all points may be that of all but one, too.
  const bool counted = modern || file.layout == LazFile::Layout::varying;
  if (counted && chance(random, 8)) {
    const auto fewer = static_cast<std::uint32_t>(file.points.size() - 1);
    std::memcpy(out.bytes.data() + 107, &fewer, 4);
    if (modern) std::memcpy(out.bytes.data() + 247, &fewer, 4);
    out.must_tell = true;
  }
  if (chance(random, 12)) {
    out.bytes.resize(out.bytes.size() - 1 - static_cast<std::size_t>(random.below(40)));
    out.must_tell = true;
  }
  return out;
}

// What is asked of the COPC file that was made last.
geom::CopcPart part;

using Entries = std::vector<CopcFile::Entry>;

// A claim of the octree that is not so.
void spoil(Random& random, Entries& entries) {
  CopcFile::Entry& one =
      entries[static_cast<std::size_t>(random.below(static_cast<int>(entries.size())))];
  switch (random.below(5)) {
    case 0:
      entries.pop_back();
      break;
    case 1:
      ++one.points;
      break;
    case 2:
      // Of a cube that is not read nothing tells that its points lie elsewhere.
      if (!part.region) one.key[1 + static_cast<std::size_t>(random.below(3))] ^= 1;
      break;
    case 3:
      one.place += 8;
      break;
    default:
      one.points = one.bytes = 0;
      break;
  }
}

// Read whole or in part; entries of the octree in pages of any size, some of them wrong.
MarkedFile copc(Random& random) {
  CopcFile file = CopcFile::scan(static_cast<std::size_t>(20 + random.below(200)),
                                 static_cast<std::uint64_t>(random.below(1 << 30)),
                                 static_cast<std::size_t>(5 + random.below(40)));
  file.page = static_cast<std::size_t>(1 + random.below(40));
  part = {};
  if (chance(random, 2)) {
    const Vec3 middle(random.uniform(0, 1000), random.uniform(0, 1000), 0);
    part.region = geom::Aabb{middle, middle};
    part.region = geom::grow(*part.region, Vec3(random.uniform(1, 500), random.uniform(1, 500), 9));
  }
  if (chance(random, 5)) part.resolution = random.uniform(0.1, 20);
  MarkedFile out;
  for (int i = 0; i < 40; ++i) {
    const LazFilePoint& p = one_of(random, file.points);
    const Vec3 place = Vec3(p.x, p.y, p.z) * file.scale;
    const Vec3 level(place.x(), place.y(), 0);
    if (!part.region || geom::contains(*part.region, level)) out.marks.push_back(place);
  }
  const bool spoilt = chance(random, 6);
  out.bytes = file.bytes_with([&](Entries& entries) {
    if (spoilt) spoil(random, entries);
  });
  return out;
}

Outcome read_copc(std::istream& in, const MarkedFile& file) {
  if (!geom::is_copc(file.bytes)) return Outcome::lost;
  std::uint64_t finer = 0;
  const auto read = [&](std::istream&, std::string_view name, const geom::PointSink& sink) {
    const geom::CopcCounts counts = geom::read_copc(
        at_any_place(file.bytes), name, [](const geom::CoordinateReference&) { return part; }, sink,
        {1 + static_cast<unsigned>(file.bytes.size() % 3)});
    finer = counts.finer;
    return counts.cloud;
  };
  const Outcome outcome = left_out::read_points(read, in, file, 1e-6);
  return finer > 0 ? Outcome::told : outcome;
}

}  // namespace

int main(int argc, char** argv) {
  const auto n = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 1e4);
  std::size_t lost = support::left_out("LAS", n, las, read_las);
  lost += support::left_out("LAZ", n, laz, read_las);
  lost += support::left_out("COPC", n, copc, read_copc);
  lost += support::left_out("COPC, whole", n, copc, read_las);
  return lost != 0;
}
