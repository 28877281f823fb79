#pragma once

// --shard K/N: a process's share of a run, written to files that say what they are shares of, for
// skyway-join.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/files.h"
#include "cli/run.h"
#include "geom/io/array_archive.h"
#include "geom/shard.h"

namespace cli {

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
  std::string kind;        // "records", "lattice", "roadmap", "boxes", "columns"
  nlohmann::json content;  // what its arrays need besides
  Exit exit = Exit::yes;
};

bool is_shard(const geom::ArrayArchive& archive);

// Throws geom::InputError for another kind of file, and for keys that are missing or wrong.
ShardFile read_shard(const geom::ArrayArchive& archive);

class Sharding {
 public:
  CLI::Option* add_to(CLI::App& app);
  bool asked() const { return !word_.empty(); }
  geom::Shard shard() const { return shard_; }

  using Files = std::vector<std::pair<std::string, std::string>>;  // by option; empty: not given

  // Call first: notes what is asked, and hashes the inputs. Throws UsageError where one is stdin.
  void begin(const CLI::App& app, const Files& inputs, const Files& outputs);

  // The exit code of an earlier run where all outputs are this very shard already, undamaged.
  std::optional<Exit> finished(const Common& common) const;

  // `output` is the option that names it, `content` JSON.
  void write(const std::string& file, const std::string& output, const std::string& kind,
             const std::string& content, std::span<const geom::NamedArray> arrays, Exit exit) const;

 private:
  std::string word_;
  geom::Shard shard_;
  Work work_;
  Files outputs_;
};

}  // namespace cli
