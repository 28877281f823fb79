#include "fuzz/reader.h"
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

void archive(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  const auto read = geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "fuzz");
  if (geom::is_box_map(read)) {
    geom::read_box_map(read).require(geom::Verified::contents);
  } else if (plan::is_roadmap(read)) {
    const plan::Roadmap roadmap = plan::read_roadmap(read);
    search(roadmap);
    plan::verify_roadmap(roadmap);
  } else {
    // 2^24 nodes are enough to fuzz with: larger claims are well formed and take time.
    const auto record = read.array<std::uint32_t>("block_record");
    if (record.size() <= 32768) plan::verify_lattice(plan::read_lattice(read));
  }
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() { return {{"archive", archive}}; }
