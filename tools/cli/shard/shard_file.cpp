#include "shard_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace cli {
namespace {

std::string differ(const char* what, const nlohmann::json& expected, const nlohmann::json& found) {
  return fmt::format("{} {}, not {}", what, found.dump(), expected.dump());
}

// Why two shards are not of one run; empty where they are.
std::string difference(const ShardFile& a, const ShardFile& b) {
  if (const std::string work = difference(a.work, b.work); !work.empty()) return work;
  if (a.output != b.output || a.kind != b.kind) return differ("output", a.output, b.output);
  if (a.shard.count != b.shard.count) return differ("N", a.shard.count, b.shard.count);
  return {};
}

// Throws where they, in order, are not all of them, each once.
void check_complete(const std::vector<ShardFile>& shards) {
  const std::size_t count = shards.front().shard.count;
  for (std::size_t k = 0; k < std::max(count, shards.size()); ++k) {
    if (k < shards.size() && k > 0 && shards[k].shard == shards[k - 1].shard) {
      throw geom::InputError(shards[k].archive.name(),
                             fmt::format("is shard {} of {}, as {} is", shards[k].shard.index + 1,
                                         count, shards[k - 1].archive.name()));
    }
    if (k >= shards.size() || shards[k].shard.index != k) {
      throw geom::InputError(
          shards.front().archive.name(),
          fmt::format("expected all {} shards, but shard {} is missing", count, k + 1));
    }
  }
}

}  // namespace

bool is_shard(const geom::ArrayArchive& archive) {
  const auto meta = geom::parse_json(archive.meta(), archive.name());
  return meta.is_object() && meta.value("format", nlohmann::json()) == "skyway-shard";
}

ShardFile read_shard(const geom::ArrayArchive& archive) {
  const auto refuse = [&](const std::string& what) {
    throw geom::InputError(archive.name(), what);
  };
  if (!is_shard(archive)) refuse("expected a shard (format \"skyway-shard\"), found another file");
  const auto meta = geom::parse_json(archive.meta(), archive.name());
  const auto find = [&](const char* key, nlohmann::json::value_t type) {
    const auto at = meta.find(key);
    if (at == meta.end() || (at->type() != type)) {
      refuse(fmt::format("the shard's \"{}\" is missing or of another type", key));
    }
    return *at;
  };
  using Type = nlohmann::json::value_t;
  if (find("version", Type::number_unsigned) != kShardVersion) {
    refuse(
        fmt::format("expected shard version {}, found {}", kShardVersion, meta["version"].dump()));
  }
  ShardFile out{archive,
                {find("tool", Type::string), find("release", Type::string),
                 find("options", Type::object), find("inputs", Type::object)},
                {},
                find("output", Type::string),
                find("kind", Type::string),
                find("content", Type::object),
                find("exit", Type::number_unsigned) == 0 ? Exit::yes : Exit::no};
  const auto pair = find("shard", Type::array);
  if (pair.size() != 2 || !pair[0].is_number_unsigned() || !pair[1].is_number_unsigned()) {
    refuse("the shard's \"shard\" must be two whole numbers, K and N");
  }
  const auto number = pair[0].get<std::size_t>();
  out.shard.count = pair[1].get<std::size_t>();
  if (number < 1 || number > out.shard.count || out.shard.count > kMostShards) {
    refuse(fmt::format("there is no shard {} of {}", number, out.shard.count));
  }
  out.shard.index = number - 1;
  return out;
}

std::string difference(const Work& expected, const Work& found) {
  if (expected.tool != found.tool) return differ("tool", expected.tool, found.tool);
  if (expected.release != found.release) return differ("release", expected.release, found.release);
  if (expected.options != found.options) return differ("options", expected.options, found.options);
  if (expected.inputs != found.inputs) return differ("inputs", expected.inputs, found.inputs);
  return {};
}

std::vector<ShardFile> open_shards(const std::vector<std::string>& files) {
  std::vector<ShardFile> shards;
  for (const std::string& file : files) shards.push_back(read_shard(open_archive(file)));
  for (const ShardFile& shard : shards) {
    const std::string why = difference(shards.front(), shard);
    if (why.empty()) continue;
    throw geom::InputError(shard.archive.name(),
                           fmt::format("expected a shard of the same run as {}, found {}",
                                       shards.front().archive.name(), why));
  }
  std::stable_sort(shards.begin(), shards.end(), [](const ShardFile& a, const ShardFile& b) {
    return a.shard.index < b.shard.index;
  });
  check_complete(shards);
  for (const ShardFile& shard : shards) shard.archive.verify();
  return shards;
}

}  // namespace cli
