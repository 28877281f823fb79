#include "geom/archive/shard_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;

// A value of a shard as a message shows it: of an option its words, without brackets.
std::string shown(const Json& value) {
  if (value.is_null()) return "none";
  if (!value.is_array()) return value.dump();
  std::string out;
  for (const Json& word : value) {
    out += (out.empty() ? "" : " ") + (word.is_string() ? word.get<std::string>() : word.dump());
  }
  return out;
}

std::string differ(std::string_view what, const Json& expected, const Json& found) {
  return fmt::format("{} {} instead of {}", what, shown(found), shown(expected));
}

// Of two that differ: the first key, in their order, whose values do.
std::string differ_in(std::string_view what, const Json& expected, const Json& found) {
  Json all = expected;
  all.update(found);
  for (const auto& [key, value] : all.items()) {
    const Json a = expected.value(key, Json());
    const Json b = found.value(key, Json());
    if (a != b) return differ(fmt::format("{} {}", what, key), a, b);
  }
  return differ(what, expected, found);  // a null is not the same as none
}

// Why two shards are not of one run; empty where they are.
std::string difference(const ShardFile& a, const ShardFile& b) {
  if (const std::string work = difference(a.work, b.work); !work.empty()) return work;
  if (a.output != b.output) return differ("the output", a.output, b.output);
  if (a.kind != b.kind) return differ("the kind", a.kind, b.kind);
  if (a.shard.count != b.shard.count) {
    return differ("a number of shards of", a.shard.count, b.shard.count);
  }
  return {};
}

// Throws where they, in order, are not all of them, each once.
void check_complete(const std::vector<ShardFile>& shards) {
  const std::size_t count = shards.front().shard.count;
  for (std::size_t k = 0; k < std::max(count, shards.size()); ++k) {
    if (k < shards.size() && k > 0 && shards[k].shard == shards[k - 1].shard) {
      throw InputError(
          shards[k].archive.name(),
          {.expected = "each shard once",
           .found = fmt::format("shard {} of {} again, beside {}", shards[k].shard.index + 1, count,
                                shards[k - 1].archive.name()),
           .advice = "leave one of them out"});
    }
    if (k >= shards.size() || shards[k].shard.index != k) {
      throw InputError(shards.front().archive.name(),
                       {.expected = fmt::format("all {} shards", count),
                        .found = fmt::format("no shard {}", k + 1)});
    }
  }
}

}  // namespace

void write_shard(std::ostream& out, const ShardLabel& label, const PartArrays& part) {
  const Json meta = {{"tool", label.work.tool},
                     {"release", label.work.release},
                     {"options", parse_json(label.work.options, label.kind)},
                     {"inputs", parse_json(label.work.inputs, label.kind)},
                     {"format", "skyway-shard"},
                     {"version", kShardVersion},
                     {"shard", {label.shard.index + 1, label.shard.count}},
                     {"output", label.output},
                     {"kind", label.kind},
                     {"content", parse_json(part.meta, label.kind)},
                     {"exit", label.yes ? 0 : 1}};
  write_array_archive(out, meta.dump() + '\n', part.arrays);
}

bool is_shard(const ArrayArchive& archive) {
  const auto meta = parse_json(archive.meta(), archive.name());
  return meta.is_object() && meta.value("format", Json()) == "skyway-shard";
}

ShardFile read_shard(const ArrayArchive& archive) {
  const auto refuse = [&](Fault fault) { throw InputError(archive.name(), std::move(fault)); };
  if (!is_shard(archive)) {
    refuse({.expected = "a shard (format \"skyway-shard\")", .found = "a file of another kind"});
  }
  const auto meta = parse_json(archive.meta(), archive.name());
  const auto find = [&](const char* key, Json::value_t type) {
    const auto at = meta.find(key);
    if (at == meta.end() || (at->type() != type)) {
      refuse({.says = fmt::format("the shard's \"{}\" is missing or of another type", key)});
    }
    return *at;
  };
  using Type = Json::value_t;
  if (find("version", Type::number_unsigned) != kShardVersion) {
    refuse({.expected = fmt::format("shard version {}", kShardVersion),
            .found = meta["version"].dump()});
  }
  ShardFile out{archive,
                {find("tool", Type::string), find("release", Type::string),
                 find("options", Type::object).dump(), find("inputs", Type::object).dump()},
                {},
                find("output", Type::string),
                find("kind", Type::string),
                find("content", Type::object).dump(),
                find("exit", Type::number_unsigned) == 0};
  const auto pair = find("shard", Type::array);
  if (pair.size() != 2 || !pair[0].is_number_unsigned() || !pair[1].is_number_unsigned()) {
    refuse({.key = "the shard's \"shard\"", .expected = "two whole numbers, K and N"});
  }
  const auto number = pair[0].get<std::size_t>();
  out.shard.count = pair[1].get<std::size_t>();
  if (number < 1 || number > out.shard.count || out.shard.count > kMostShards) {
    refuse({.expected = fmt::format("shard K of N with 1 <= K <= N <= {}", kMostShards),
            .found = fmt::format("{} of {}", number, out.shard.count)});
  }
  out.shard.index = number - 1;
  return out;
}

std::string difference(const Work& expected, const Work& found) {
  if (expected.tool != found.tool) return differ("the tool", expected.tool, found.tool);
  if (expected.release != found.release) {
    return differ("the release", expected.release, found.release);
  }
  if (expected.options != found.options) {
    return differ_in("the option", parse_json(expected.options, "options"),
                     parse_json(found.options, "options"));
  }
  if (expected.inputs != found.inputs) {
    return differ_in("the input", parse_json(expected.inputs, "inputs"),
                     parse_json(found.inputs, "inputs"));
  }
  return {};
}

std::vector<ShardFile> complete_shards(std::vector<ShardFile> shards) {
  for (const ShardFile& shard : shards) {
    const std::string why = difference(shards.front(), shard);
    if (why.empty()) continue;
    throw InputError(shard.archive.name(), {.expected = fmt::format("a shard of the same run as {}",
                                                                    shards.front().archive.name()),
                                            .found = fmt::format("one with {}", why)});
  }
  std::stable_sort(shards.begin(), shards.end(), [](const ShardFile& a, const ShardFile& b) {
    return a.shard.index < b.shard.index;
  });
  check_complete(shards);
  for (const ShardFile& shard : shards) shard.archive.verify();
  return shards;
}

}  // namespace geom
