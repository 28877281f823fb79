#pragma once

// Shares of a stream of records: every n-th of them.
//
// Example:
//   geom::RecordPart part{.text = "{\"id\":\"q1\"}\n"};
//   part.ends = {part.text.size()};
//   const geom::PartArrays arrays = geom::arrays_of(part, 3);  // one of three records

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "geom/archive/shard_file.h"

namespace geom {

// Some records of a stream.
struct RecordPart {
  std::string head;                 // text before all records
  std::string text;                 // of the records, one after the other
  std::vector<std::uint64_t> ends;  // where each ends in the text
};

// `total`: how many records all shares have. The arrays refer to the part, which must outlive them.
PartArrays arrays_of(const RecordPart& part, std::size_t total);

// Writes the records of all shards in their order. Throws InputError where one is damaged.
void join_records(std::ostream& out, std::span<const ShardFile> shards);

}  // namespace geom
