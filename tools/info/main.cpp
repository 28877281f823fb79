// skyway-info: what is in a map, a lattice, or a stream of records.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <map>

#include "cli/file/files.h"
#include "cli/file/recognise.h"
#include "cli/run.h"
#include "cli/shard/sharding.h"
#include "geom/base/error.h"
#include "geom/base/hashed_stream.h"
#include "geom/base/text_stream.h"
#include "geom/map/box_map_file.h"
#include "geom/map/description.h"
#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"
#include "geom/text/text_table.h"
#include "plan/lattice/lattice_file.h"
#include "plan/roadmap/roadmap_file.h"

namespace {

using Json = nlohmann::ordered_json;

Json describe_lattice(const geom::ArrayArchive& archive, bool verify) {
  const plan::Lattice lattice = plan::read_lattice(archive);
  if (verify) plan::verify_lattice(lattice);
  Json out = geom::parse_ordered_json(archive.meta(), archive.name());
  out.erase("format");
  out.erase("version");
  Json described = {{"type", "lattice"}};
  described.update(out);
  return described;
}

Json describe_roadmap(const geom::ArrayArchive& archive, bool verify) {
  const plan::Roadmap roadmap = plan::read_roadmap(archive);
  if (verify) plan::verify_roadmap(roadmap);
  Json out = geom::parse_ordered_json(archive.meta(), archive.name());
  out.erase("format");
  out.erase("version");
  Json described = {{"type", "roadmap"}};
  described.update(out);
  described["bends"] = roadmap.bends();
  described["edges"] = roadmap.edges();
  return described;
}

Json describe_shard(const geom::ArrayArchive& archive) {
  const geom::ShardFile shard = geom::read_shard(archive);
  return {{"type", "shard"},
          {"shard", fmt::format("{}/{}", shard.shard.index + 1, shard.shard.count)},
          {"tool", shard.work.tool},
          {"release", shard.work.release},
          {"options", geom::parse_json(shard.work.options, archive.name())},
          {"inputs", geom::parse_json(shard.work.inputs, archive.name())},
          {"output", shard.output},
          {"kind", shard.kind},
          {"exit", shard.yes ? 0 : 1}};
}

Json describe_archive(const geom::ArrayArchive& archive, bool verify) {
  if (verify) archive.verify(cli::all_cores());
  Json out;
  if (geom::is_box_map(archive)) {
    const geom::BoxMap map = geom::read_box_map(archive);
    out = geom::description(map);
    if (verify) map.require(geom::Verified::contents, cli::all_cores());
  } else if (plan::is_lattice(archive)) {
    out = describe_lattice(archive, verify);
  } else if (plan::is_roadmap(archive)) {
    out = describe_roadmap(archive, verify);
  } else if (geom::is_shard(archive)) {
    out = describe_shard(archive);
  } else {
    throw geom::InputError(
        archive.name(),
        {.expected = "a box map, a lattice, a roadmap or a shard", .found = "another archive"});
  }
  if (verify) out["verified"] = true;
  return out;
}

Json describe_records(const std::string& text, const std::string& name) {
  geom::TextInput in(text);
  std::map<std::string, std::size_t> counts;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string_view record = geom::trimmed(line);
    if (record.empty()) continue;
    if (counts.empty() && record.starts_with('{') && !record.ends_with('}')) {
      throw geom::InputError(
          name, number,
          {.expected = "records, each a JSON object in one line",
           .found = "JSON that goes on in the next line",
           .advice =
               "skyway-map patch reads zones of airspace (--zones) and GeoJSON (--keep-out)"});
    }
    const geom::JsonFields fields(line, name, number);
    std::string kind = fields.text("type", "query");
    if (fields.has("status")) kind += " " + fields.text("status");
    if (fields.has("ok")) kind += fields.value("ok") == true ? " ok" : " failed";
    if (fields.has("overridden")) kind += " overridden";
    ++counts[kind];
  }
  if (counts.empty())
    throw geom::InputError(name, {.expected = "records", .found = "an empty stream"});
  Json out;
  for (const auto& [kind, count] : counts) out[kind] = count;
  return out;
}

// Of a file that no tool of ours wrote, or that is another tool's to read.
Json describe_foreign(const geom::Format& format, std::string_view head) {
  Json out = {{"type", traj::files::described(format, head)}};
  if (!format.readers.empty()) out["read_by"] = fmt::format("{}", fmt::join(format.readers, " "));
  if (!format.advice.empty()) out["advice"] = format.advice;
  return out;
}

Json describe_file(const std::string& input, bool verify) {
  cli::InputFile file(input);
  geom::HashedStream in(file.stream());
  const geom::Format* format = cli::recognise_file(input);
  if (!format) format = traj::files::recognise(in.head());
  const bool archive = in.head().starts_with("PK");
  if (verify && !archive) {
    throw geom::InputError(
        file.name(),
        {.expected = "a map, a lattice, a roadmap or a shard, which alone have checksums to verify",
         .found = "another file"});
  }
  if (format && !geom::reads("skyway-info", *format) && !verify) {
    return describe_foreign(*format, in.head());
  }
  if (archive && input != "-") return describe_archive(cli::open_archive(input), verify);
  const std::string text(std::istreambuf_iterator<char>(in.stream()), {});
  if (!archive) return describe_records(text, file.name());
  return describe_archive(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(text)), "stdin"),
                          verify);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Say what is in a box map, a lattice, or a stream of records.", "skyway-info"};
  cli::Common common(app);
  std::string input;
  bool json = false;
  bool verify = false;
  app.add_option("file", input, "any of Skyway's files, or another; - for stdin")->required();
  app.add_flag("--json", json, "print one JSON object");
  app.add_flag(
      "--verify", verify,
      "also check every checksum, and a map's boxes and hash, even if that was done before");
  return cli::run_tool(app, argc, argv, [&] {
    const Json out = describe_file(input, verify);
    cli::OutputFile print("-", cli::OutputKind::text);
    print.stream() << (json ? out.dump() + '\n' : geom::as_lines(out));
    print.commit();
    return cli::Exit::yes;
  });
}
