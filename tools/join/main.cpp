// skyway-join: the shards of a run become what one run would have written.

#include <fmt/format.h>

#include "cli/option/map_output.h"
#include "cli/option/output_option.h"
#include "cli/run.h"
#include "cli/shard/map_shard.h"
#include "cli/shard/sharding.h"
#include "geom/base/error.h"
#include "geom/text/counted.h"
#include "plan/lattice/lattice_file.h"
#include "plan/lattice/part_file.h"
#include "plan/roadmap/part_file.h"
#include "plan/roadmap/roadmap_file.h"

namespace {

using cli::ShardFile;

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
      throw geom::InputError(name_,
                             {.says = fmt::format("record {} ends outside of the text", next_),
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

void join_records(std::ostream& out, const std::vector<ShardFile>& shards) {
  const nlohmann::json& content = shards.front().content;
  if (!content.contains("head") || !content["head"].is_string() || !content.contains("total") ||
      !content["total"].is_number_unsigned()) {
    throw geom::InputError(shards.front().archive.name(),
                           {.expected = "a shard of records", .found = "a damaged one"});
  }
  const auto total = content["total"].get<std::size_t>();
  std::vector<Records> records;
  for (const ShardFile& shard : shards) {
    records.emplace_back(shard);
    const std::size_t expected = shard.shard.taken(total);
    if (shard.content != content || records.back().count() != expected) {
      throw geom::InputError(
          shard.archive.name(),
          {.expected = fmt::format("{}, of {} in all", geom::counted(expected, "record"), total),
           .found = fmt::to_string(records.back().count()),
           .advice = "the file is damaged"});
    }
  }
  out << content["head"].get<std::string>();
  for (std::size_t i = 0; i < total; ++i) out << records[i % records.size()].next();
}

void join_lattices(std::ostream& out, const std::vector<ShardFile>& shards) {
  std::vector<plan::LatticePart> parts;
  for (const ShardFile& s : shards) {
    parts.push_back(plan::read_lattice_part(s.archive, s.content.dump(), s.shard));
  }
  plan::write_lattice(out, parts);
}

void join_roadmaps(std::ostream& out, const std::vector<ShardFile>& shards) {
  std::vector<plan::Roadmap> parts;
  for (const ShardFile& s : shards) {
    parts.push_back(plan::read_roadmap_part(s.archive, s.content.dump()));
  }
  plan::write_roadmap(out, parts);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Join the shards of a run (--shard) into what one run would have written.",
               "skyway-join"};
  cli::Common common(app, true);
  std::vector<std::string> files;
  std::string output = "-";
  app.add_option("shards", files, "all shards of one output, in any order")->required();
  cli::add_output(app, "-o,--output", output, "the joined output (default: stdout)");
  return cli::run_tool(app, argc, argv, [&] {
    const std::vector<ShardFile> shards = cli::open_shards(files);
    const std::string& kind = shards.front().kind;
    if (cli::is_map_shard(shards.front())) {
      cli::write_map(common, output, cli::join_map(shards), shards.front().archive.name(), {});
      return cli::Exit::yes;
    }
    const bool text = kind == "records";
    cli::OutputFile out(output, text ? cli::OutputKind::text : cli::OutputKind::artefact);
    if (text) {
      join_records(out.stream(), shards);
    } else if (kind == "lattice") {
      join_lattices(out.stream(), shards);
    } else if (kind == "roadmap") {
      join_roadmaps(out.stream(), shards);
    } else if (kind == "runs") {
      throw geom::InputError(shards.front().archive.name(),
                             {.says = "this is a shard of runs",
                              .advice = "join it with skyway-fly --join, with the trajectories and "
                                        "options that they were flown with"});
    } else if (kind == "departures") {
      throw geom::InputError(shards.front().archive.name(),
                             {.says = "this is a shard of skyway-fleet",
                              .advice = "join it with skyway-fleet --join, with the trajectories "
                                        "and options that it was made with"});
    } else {
      throw geom::InputError(
          shards.front().archive.name(),
          {.expected = "a kind of shard that is known", .found = geom::in_quotes(kind)});
    }
    out.commit();
    common.write_stats({{"shards", shards.size()}, {"kind", kind}});
    const bool no = std::any_of(shards.begin(), shards.end(),
                                [](const ShardFile& s) { return s.exit == cli::Exit::no; });
    return no ? cli::Exit::no : cli::Exit::yes;
  });
}
