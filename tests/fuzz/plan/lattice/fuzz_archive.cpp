#include "fuzz/readers.h"
#include "geom/base/error.h"
#include "geom/map/box_map_file.h"
#include "plan/lattice/lattice_file.h"
#include "plan/roadmap/roadmap_file.h"

namespace {

// What a search comes to is verified there.
void search(const plan::Roadmap& roadmap) {
  static const geom::CollisionScene scene = [] {
    geom::BoxMapSpec spec;
    spec.bounds = {{-100, -100, -100}, {100, 100, 100}};
    geom::BoxTable table;
    table.add({{30, 20, 0}, {40, 40, 20}}, 0);
    return geom::CollisionScene(geom::BoxMap(spec, table), {"box", {1, 1, 1}}, 0);
  }();
  try {
    plan::RoadmapSearch(scene, roadmap).search({10, 30, 5}, {60, 30, 5}, {200, 4, 1});
  } catch (const geom::InputError&) {  // so that all else is read, too
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  return refuses_or_reads(data, size, [&](std::istream&) {
    const auto archive = geom::ArrayArchive::from_bytes(bytes, "fuzz");
    if (geom::is_box_map(archive)) {
      geom::read_box_map(archive).require(geom::Verified::contents);
    } else if (plan::is_roadmap(archive)) {
      const plan::Roadmap roadmap = plan::read_roadmap(archive);
      search(roadmap);
      plan::verify_roadmap(roadmap);
    } else {
      // 2^24 nodes are enough to fuzz with: larger claims are well formed and take time.
      const auto record = archive.array<std::uint32_t>("block_record");
      if (record.size() <= 32768) plan::verify_lattice(plan::read_lattice(archive));
    }
  });
}
