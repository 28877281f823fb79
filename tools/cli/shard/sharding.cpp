#include "sharding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/base/hashed_stream.h"

namespace cli {
namespace {

// Options that change no byte of what a shard holds, but where it goes and how long it takes.
constexpr std::array<std::string_view, 8> kIdle = {"output",   "report", "report-file", "threads",
                                                   "progress", "stats",  "quiet",       "shard"};

geom::Shard parse_shard(const std::string& word) {
  geom::Shard shard;
  std::size_t number = 0;
  const char* const end = word.data() + word.size();
  const auto first = std::from_chars(word.data(), end, number);
  const bool slash = first.ec == std::errc() && first.ptr < end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
  if (!slash || second.ec != std::errc() || second.ptr != end || number < 1 ||
      number > shard.count || shard.count > geom::kMostShards) {
    throw UsageError(fmt::format("--shard: expected K/N with 1 <= K <= N <= {}, found \"{}\"",
                                 geom::kMostShards, word));
  }
  shard.index = number - 1;
  return shard;
}

// Of an archive: of its directory, so that big ones cost nothing.
std::string hash_of(const std::string& file) {
  InputFile input(file);
  geom::HashedStream hashed(input.stream());
  return hashed.head().starts_with("PK") ? open_archive(file).directory_hash() : hashed.hash();
}

}  // namespace

std::vector<geom::ShardFile> open_shards(const std::vector<std::string>& files) {
  std::vector<geom::ShardFile> shards;
  for (const std::string& file : files) shards.push_back(geom::read_shard(open_archive(file)));
  return geom::complete_shards(std::move(shards));
}

CLI::Option* Sharding::add_to(CLI::App& app) {
  return app.add_option("--shard", word_,
                        "K/N: do only the K-th of N shares, and write a shard for skyway-join");
}

void Sharding::begin(const CLI::App& app, const Files& inputs, const Files& outputs) {
  if (!asked()) return;
  shard_ = parse_shard(word_);
  nlohmann::json options_given = nlohmann::json::object();
  nlohmann::json hashes = nlohmann::json::object();
  for (const auto& [name, file] : inputs) {
    if (file == "-") {
      throw UsageError(
          fmt::format("--shard reads its inputs from files: give a file for {}, not stdin", name));
    }
    if (!file.empty()) hashes[name] = hash_of(file);
  }
  outputs_ = outputs;
  for (const auto& [name, file] : outputs) {
    const bool beside = !file.empty() && name != "output";
    if (beside) options_given[name] = true;  // that, not where
  }
  const auto is_input = [&](const std::string& value) {
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const auto& input) { return input.second == value; });
  };
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name();
    const auto values = option->results();
    const bool idle = std::find(kIdle.begin(), kIdle.end(), name) != kIdle.end();
    if (values.empty() || idle || options_given.contains(name)) continue;
    if (std::all_of(values.begin(), values.end(), is_input)) continue;
    if (values.size() == 1 && std::filesystem::is_regular_file(values[0])) {  // of a vehicle, say
      hashes[name] = hash_of(values[0]);
    } else {
      options_given[name] = values;
    }
  }
  work_ = {app.get_name(), SKYWAY_VERSION, options_given.dump(), hashes.dump()};
}

std::optional<Exit> Sharding::finished(const Common& common) const {
  if (!asked()) return std::nullopt;
  Exit worst = Exit::yes;
  for (const auto& [name, file] : outputs_) {
    if (file.empty()) continue;
    if (file == "-" || !std::filesystem::is_regular_file(file)) return std::nullopt;
    try {
      const geom::ShardFile there =
          geom::read_shard(geom::ArrayArchive::map(file));  // no input of the run
      const bool same = there.work == work_ && there.shard == shard_ && there.output == name;
      if (!same) return std::nullopt;
      there.archive.verify();
      if (!there.yes) worst = Exit::no;
    } catch (const geom::InputError&) {
      return std::nullopt;  // something else, or damaged: it will be written anew
    }
    common.note(fmt::format("{}: {} holds this shard already\n", work_.tool, file));
  }
  common.write_stats({{"skipped", true}});
  return worst;
}

void Sharding::write(const std::string& file, const std::string& output, const std::string& kind,
                     const geom::PartArrays& part, Exit exit) const {
  OutputFile out(file, OutputKind::artefact);
  geom::write_shard(out.stream(), {work_, shard_, output, kind, exit == Exit::yes}, part);
  out.commit();
}

}  // namespace cli
