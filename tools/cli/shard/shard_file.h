#pragma once

// Files that hold a share of a run, and say of which.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/answer/exit.h"
#include "geom/archive/array_archive.h"
#include "geom/base/shard.h"

namespace cli {

inline constexpr int kShardVersion = 1;
inline constexpr std::size_t kMostShards = 1000000;

// What a shard is a shard of: runs of equal works give equal bytes.
struct Work {
  std::string tool;
  std::string release;
  nlohmann::json options;  // those that were given and can change a byte, by name
  nlohmann::json inputs;   // a hash of each input file, by the option that named it

  friend bool operator==(const Work&, const Work&) = default;
};

// A shard as skyway-join and skyway-info see it.
struct ShardFile {
  geom::ArrayArchive archive;
  Work work;
  geom::Shard shard;
  std::string output;      // which of the tool's, by its option
  std::string kind;        // "records", "lattice", "roadmap", "boxes", "columns" or "runs"
  nlohmann::json content;  // what its arrays need besides
  Exit exit = Exit::yes;
};

bool is_shard(const geom::ArrayArchive& archive);

// Throws geom::InputError for another kind of file, and for keys that are missing or wrong.
ShardFile read_shard(const geom::ArrayArchive& archive);

// All shards of one output of one run, in their order, checksums looked at. Throws geom::InputError
// where one is damaged, missing, there twice or of another run.
std::vector<ShardFile> open_shards(const std::vector<std::string>& files);

// What tells works apart, in words; empty where they are equal.
std::string difference(const Work& expected, const Work& found);

}  // namespace cli
