#pragma once

// Files that hold a share of a run, and say of which.
//
// Example:
//   geom::ShardLabel label{.work = {"mine", "1.0", "{}", "{}"}};
//   label.kind = "records";
//   const geom::RecordPart records{.text = "a\n", .ends = {2}};
//   std::ostringstream out;
//   geom::write_shard(out, label, geom::arrays_of(records, 1));
//   const std::string bytes = out.str();
//   const geom::ShardFile shard = geom::read_shard(
//       geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "part.zip"));
//   assert(shard.kind == "records");

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "geom/archive/array_archive.h"
#include "geom/base/shard.h"

namespace geom {

inline constexpr int kShardVersion = 1;
inline constexpr std::size_t kMostShards = 1000000;

// What a shard is a shard of: runs of equal works give equal bytes. Keys of JSON are sorted.
struct Work {
  std::string tool;
  std::string release;
  std::string options;  // JSON: those that were given and can change a byte, by name
  std::string inputs;   // JSON: a hash of each input file, by the option that named it

  friend bool operator==(const Work&, const Work&) = default;
};

// A shard as it stands in its file.
struct ShardFile {
  ArrayArchive archive;
  Work work;
  Shard shard;
  std::string output;   // which of the tool's, by its option
  std::string kind;     // "records", "lattice", "roadmap", "boxes", "columns", "runs", …
  std::string content;  // JSON: what its arrays need besides
  bool yes = true;      // whether the answer of this share is yes
};

// The share itself: one JSON object, and arrays that own their bytes or refer to others'.
struct PartArrays {
  std::string meta;
  std::vector<NamedArray> arrays;
  std::shared_ptr<const void> keep_alive;  // of those that are not others'
};

// Which share of which run, and which of its outputs.
struct ShardLabel {
  Work work;
  Shard shard;
  std::string output;
  std::string kind;
  bool yes = true;
};

void write_shard(std::ostream& out, const ShardLabel& label, const PartArrays& part);

bool is_shard(const ArrayArchive& archive);

// Throws InputError for another kind of file, and for keys that are missing or wrong.
ShardFile read_shard(const ArrayArchive& archive);

// All shards of one output of one run, in their order, checksums looked at. Throws InputError
// where one is damaged, missing, there twice or of another run.
std::vector<ShardFile> complete_shards(std::vector<ShardFile> shards);

// What tells works apart, in words; empty where they are equal.
std::string difference(const Work& expected, const Work& found);

}  // namespace geom
