#include <sstream>

#include "fuzz/reader.h"
#include "geom/map/map_part.h"
#include "plan/lattice/lattice_file.h"
#include "plan/lattice/part_file.h"
#include "plan/roadmap/part_file.h"
#include "plan/roadmap/roadmap_file.h"
#include "traj/flight/run_part.h"

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
  } else if (geom::is_map_part(shard) &&
             shard.content.find("\"unknown_blocked\":1") == std::string::npos) {
    geom::join_map({&shard, 1});
  } else if (shard.kind == "runs" && shard.shard.count == 1) {
    const traj::JoinedRuns runs({shard});
    for (std::size_t i = 0; i < runs.trajectories(); ++i) runs.outcomes(i, 0.75);
  }
}

void shard(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  join(geom::read_shard(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "fuzz")));
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() { return {{"shard", shard}}; }
