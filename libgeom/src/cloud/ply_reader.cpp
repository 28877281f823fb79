#include <fmt/format.h>

#include "geom/cloud/cloud_format.h"
#include "geom/cloud/point_cloud.h"
#include "geom/text/beginning.h"
#include "ply_file.h"

namespace geom {
namespace {

void read_points(PlyFile& file, const PlyElement& element, PointChunks& chunks) {
  const auto x = element.find("x", false);
  const auto y = element.find("y", false);
  const auto z = element.find("z", false);
  if (!x || !y || !z) {
    file.refuse({.expected = "the properties x, y and z of element \"vertex\"",
                 .found = "not all of them"});
  }
  file.for_each_row(element, [&](const PlyRow& row, std::uint64_t) {
    chunks.add({row.of(*x)[0], row.of(*y)[0], row.of(*z)[0]});
  });
}

CloudCounts read_ply_cloud(std::istream& in, std::string_view source, const PointSink& sink,
                           const ReferenceSink& reference, const LasReading&) {
  PlyFile file(in, source);
  if (reference) reference(file.told());
  PointChunks chunks(source, sink);
  bool points = false;
  Skipped skipped;
  for (const PlyElement& element : file.elements()) {
    if (element.name == "vertex") {
      read_points(file, element, chunks);
      points = true;
      if (element.holds_splats()) {
        skipped.add("splats, which reach beyond their points",
                    fmt::format("element vertex {}", element.count));
      }
    } else {
      file.for_each_row(element, [](const PlyRow&, std::uint64_t) {});
      if (element.holds_places()) {
        skipped.add("points of another element than \"vertex\"",
                    fmt::format("element {} {}", element.name.substr(0, 40), element.count));
      }
    }
    // A grid of a range scan has at most one vertex a row.
    const bool grid = element.name == "range_grid";
    if (element.name != "vertex" && !grid && element.holds_indices()) {
      skipped.add("surface of a mesh", fmt::format("element {} {}", element.name, element.count));
    }
  }
  file.require_end();
  if (!points) file.refuse({.expected = "an element \"vertex\"", .found = "none"});
  CloudCounts counts = chunks.finish();
  counts.skipped = std::move(skipped);
  return counts;
}

}  // namespace

CloudCounts read_ply(std::istream& in, std::string_view source, const PointSink& sink) {
  return read_ply_cloud(in, source, sink, {}, {});
}

namespace {

constexpr std::string_view kReaders[] = {"skyway-cloud", "skyway-mesh"};

}  // namespace

constinit const Format kPlyFile{.word = "ply",
                                .what = "a PLY file",
                                .begins = any_of<begins_with<"ply\n">, begins_with<"ply\r">>,
                                .readers = kReaders};

constinit const CloudFormat kPlyCloud{
    .format = &kPlyFile, .may_be = begins_with<"ply">, .read = read_ply_cloud};

}  // namespace geom
