#include <sstream>

#include "fuzz/reader.h"
#include "geom/archive/shard_file.h"
#include "plan/lattice/lattice_file.h"
#include "plan/lattice/part_file.h"
#include "plan/roadmap/part_file.h"
#include "plan/roadmap/roadmap_file.h"

namespace {

// 2^24 nodes are enough to fuzz with: larger claims are well formed and take time.
bool small(const geom::ArrayArchive& archive) {
  return !archive.has("block_record") ||
         archive.array<std::uint32_t>("block_record").size() <= 32768;
}

void join(const geom::ShardFile& shard) {
  const std::string content = shard.content;
  if (shard.kind == "lattice" && small(shard.archive)) {
    const auto part = plan::read_lattice_part(shard.archive, content, shard.shard);
    plan::verify_lattice(plan::join_lattice({&part, 1}));
  } else if (shard.kind == "roadmap") {
    const auto part = plan::read_roadmap_part(shard.archive, content);
    std::ostringstream joined;
    plan::write_roadmap(joined, {&part, 1});
    plan::verify_roadmap(part);
  }
}

void shard(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  join(geom::read_shard(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "fuzz")));
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() { return {{"shard", shard}}; }
