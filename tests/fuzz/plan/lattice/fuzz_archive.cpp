#include "fuzz/readers.h"
#include "geom/archive/box_map_file.h"
#include "plan/lattice/lattice_file.h"
#include "plan/roadmap/roadmap_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  return refuses_or_reads(data, size, [&](std::istream&) {
    const auto archive = geom::ArrayArchive::from_bytes(bytes, "fuzz");
    if (geom::is_box_map(archive)) {
      geom::read_box_map(archive).require(geom::Verified::contents);
    } else if (plan::is_roadmap(archive)) {
      plan::verify_roadmap(plan::read_roadmap(archive));
    } else {
      // 2^24 nodes are enough to fuzz with: larger claims are well formed and take time.
      const auto record = archive.array<std::uint32_t>("block_record");
      if (record.size() <= 32768) plan::verify_lattice(plan::read_lattice(archive));
    }
  });
}
