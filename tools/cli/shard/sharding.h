#pragma once

// --shard K/N: a process's share of a run, written to files that say what they are shares of, for
// skyway-join.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/answer/exit.h"
#include "cli/file/files.h"
#include "cli/option/common.h"
#include "geom/archive/shard_file.h"

namespace cli {

// All shards of one output of one run, in their order. Throws geom::InputError where one is
// damaged, missing, there twice or of another run.
std::vector<geom::ShardFile> open_shards(const std::vector<std::string>& files);

class Sharding {
 public:
  CLI::Option* add_to(CLI::App& app);
  bool asked() const { return !word_.empty(); }
  geom::Shard shard() const { return shard_; }

  using Files = std::vector<std::pair<std::string, std::string>>;  // by option; empty: not given

  // Call first: notes what is asked, and hashes the inputs. Throws UsageError where one is stdin.
  // Outputs are those of a shard.
  void begin(const CLI::App& app, const Files& inputs, const Files& outputs);

  // The exit code of an earlier run where all outputs are this very shard already, undamaged.
  std::optional<Exit> finished(const Common& common) const;

  // A share of this kind, of the output that this option names.
  void write(const std::string& file, const std::string& output, const std::string& kind,
             const geom::PartArrays& part, Exit exit = Exit::yes) const;

 private:
  std::string word_;
  geom::Shard shard_;
  geom::Work work_;
  Files outputs_;
};

}  // namespace cli
