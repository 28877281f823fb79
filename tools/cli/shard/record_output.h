#pragma once

// Where records go: a stream, or the shard of one.

#include <optional>
#include <string>
#include <string_view>

#include "cli/shard/sharding.h"
#include "geom/archive/record_part.h"

namespace cli {

// A stream of records that is one or, with --shard, a shard of it. Neither is there before
// commit(), stdout apart.
class RecordOutput {
 public:
  // `name` is the option that names the file. `sharding` must outlive this.
  RecordOutput(const std::string& file, std::string name, const Sharding& sharding);

  void head(std::string_view text);   // before all records, once in all; call first
  void add(std::string_view record);  // the lines of one
  void flush();                       // OutputFile's
  void pass_on();                     // OutputFile's
  // `total`: how many records all shards have.
  void commit(std::size_t total, Exit exit);

 private:
  const Sharding& sharding_;
  std::string file_;
  std::string name_;
  std::optional<OutputFile> stream_;  // without --shard
  geom::RecordPart part_;
};

}  // namespace cli
