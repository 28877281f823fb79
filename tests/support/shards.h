#pragma once

// Shards of a run through the bytes of their files.

#include <functional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "geom/archive/shard_file.h"

namespace support {

// The shards of kind `kind` that `part` gives, of one run.
inline std::vector<geom::ShardFile> shards(
    std::size_t count, const std::string& kind,
    const std::function<geom::PartArrays(const geom::Shard&)>& part) {
  std::vector<geom::ShardFile> out;
  for (std::size_t k = 0; k < count; ++k) {
    const geom::Shard shard{k, count};
    std::ostringstream bytes;
    const geom::Work work{"tool", "1", "{}", "{}"};
    geom::write_shard(bytes, {work, shard, "output", kind}, part(shard));
    const std::string text = bytes.str();
    out.push_back(geom::read_shard(geom::ArrayArchive::from_bytes(
        std::as_bytes(std::span(text)), "shard " + std::to_string(k + 1))));
  }
  return geom::complete_shards(std::move(out));
}

}  // namespace support
