#include <algorithm>
#include <cstdlib>

#include "fuzz/reader.h"
#include "geom/cloud/copc.h"
#include "geom/cloud/point_cloud.h"

namespace {

void skip(std::span<const geom::CloudPoint>) {}

// A second way into the bytes.
geom::ReadAt read_at(const std::string& bytes) {
  return [&bytes](std::uint64_t at, std::span<unsigned char> to) {
    const std::size_t n =
        at < bytes.size() ? std::min<std::size_t>(to.size(), bytes.size() - at) : 0;
    std::copy_n(bytes.data() + (n > 0 ? at : 0), n, to.data());
    return n;
  };
}

void copc(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  const geom::CopcPart part{geom::Aabb{{100, 100, 0}, {700, 700, 0}}, 3};
  geom::read_copc(
      read_at(bytes), "fuzz", [&](const geom::CoordinateReference&) { return part; }, skip);
}

// With a second way into the file, the same bytes are read or refused; the points are counted.
void las(std::istream& whole) {
  const std::string bytes = fuzz::rest_of(whole);
  const auto points = [&](const geom::LasReading& reading) {
    std::size_t count = 0;
    const bool read = fuzz::takes(bytes, [&](std::istream& in) {
      const auto sink = [&](std::span<const geom::CloudPoint> chunk) { count += chunk.size(); };
      geom::read_las(in, "fuzz", sink, {}, reading);
    });
    return std::pair(read, read ? count : 0);
  };
  if (points({}) != points({{2, {}}, read_at(bytes)})) std::abort();
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"copc", copc},
          {"las", las},
          {"pcd", [](std::istream& in) { geom::read_pcd(in, "fuzz", skip); }},
          {"ply", [](std::istream& in) { geom::read_ply(in, "fuzz", skip); }},
          {"xyz", [](std::istream& in) { geom::read_xyz(in, "fuzz", skip); }}};
}
