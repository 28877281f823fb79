#include "geom/archive/record_part.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/counted.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

// The records of a shard, one after the other.
class Records {
 public:
  explicit Records(const ShardFile& file)
      : name_(file.archive.name()),
        text_(file.archive.array<std::uint8_t>("text")),
        ends_(file.archive.array<std::uint64_t>("ends")) {}

  std::size_t count() const { return ends_.size(); }

  std::string_view next() {
    const std::uint64_t end = ends_[next_++];
    if (end < at_ || end > text_.size()) {
      throw InputError(name_, {.says = fmt::format("record {} ends outside of the text", next_),
                               .advice = "the file is damaged"});
    }
    const auto* const begin = reinterpret_cast<const char*>(text_.data()) + at_;
    const std::size_t size = end - at_;
    at_ = end;
    return {begin, size};
  }

 private:
  std::string name_;
  std::span<const std::uint8_t> text_;
  std::span<const std::uint64_t> ends_;
  std::size_t next_ = 0;
  std::uint64_t at_ = 0;
};

}  // namespace

PartArrays arrays_of(const RecordPart& part, std::size_t total) {
  const nlohmann::json content = {{"head", part.head}, {"total", total}};
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(part.text.data()), part.text.size());
  return {content.dump(),
          {named_array<std::uint8_t>("text", bytes), named_array<std::uint64_t>("ends", part.ends)},
          {}};
}

void join_records(std::ostream& out, std::span<const ShardFile> shards) {
  const nlohmann::json content = parse_json(shards.front().content, shards.front().archive.name());
  if (!content.contains("head") || !content["head"].is_string() || !content.contains("total") ||
      !content["total"].is_number_unsigned()) {
    throw InputError(shards.front().archive.name(),
                     {.expected = "a shard of records", .found = "a damaged one"});
  }
  const auto total = content["total"].get<std::size_t>();
  std::vector<Records> records;
  for (const ShardFile& shard : shards) {
    records.emplace_back(shard);
    const std::size_t expected = shard.shard.taken(total);
    if (shard.content != shards.front().content || records.back().count() != expected) {
      throw InputError(
          shard.archive.name(),
          {.expected = fmt::format("{}, of {} in all", counted(expected, "record"), total),
           .found = fmt::to_string(records.back().count()),
           .advice = "the file is damaged"});
    }
  }
  out << content["head"].get<std::string>();
  for (std::size_t i = 0; i < total; ++i) out << records[i % records.size()].next();
}

}  // namespace geom
