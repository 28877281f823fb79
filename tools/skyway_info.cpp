// skyway-info: what is in a map, a lattice, or a stream of records.

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

#include "cli/describe.h"
#include "cli/files.h"
#include "cli/run.h"
#include "cli/sharding.h"
#include "geom/error.h"
#include "geom/io/box_map_file.h"
#include "geom/io/json_fields.h"
#include "geom/io/parse_json.h"
#include "plan/io/lattice_file.h"
#include "plan/io/roadmap_file.h"

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
  described["bends"] = roadmap.bends.size();
  described["edges"] = roadmap.to.size() / 2;
  return described;
}

Json describe_shard(const geom::ArrayArchive& archive) {
  const cli::ShardFile shard = cli::read_shard(archive);
  return {{"type", "shard"},
          {"shard", fmt::format("{}/{}", shard.shard.index + 1, shard.shard.count)},
          {"tool", shard.work.tool},
          {"release", shard.work.release},
          {"options", shard.work.options},
          {"inputs", shard.work.inputs},
          {"output", shard.output},
          {"kind", shard.kind},
          {"exit", static_cast<int>(shard.exit)}};
}

Json describe_archive(const geom::ArrayArchive& archive, bool verify) {
  if (verify) archive.verify();
  Json out;
  if (geom::is_box_map(archive)) {
    const geom::BoxMap map = geom::read_box_map(archive);
    out = cli::describe(map);
    if (verify) {
      geom::BoxTable table{{map.boxes().begin(), map.boxes().end()},
                           {map.ids().begin(), map.ids().end()},
                           {map.label().begin(), map.label().end()},
                           map.labels()};
      if (geom::BoxMap(map.spec(), table).hash() != map.hash()) {
        throw geom::InputError(archive.name(), "the hash is not that of the boxes");
      }
    }
  } else if (plan::is_lattice(archive)) {
    out = describe_lattice(archive, verify);
  } else if (plan::is_roadmap(archive)) {
    out = describe_roadmap(archive, verify);
  } else if (cli::is_shard(archive)) {
    out = describe_shard(archive);
  } else {
    throw geom::InputError(
        archive.name(),
        "expected a box map, a lattice, a roadmap or a shard, found another archive");
  }
  if (verify) out["verified"] = true;
  return out;
}

Json describe_records(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  std::map<std::string, std::size_t> counts;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const geom::JsonFields fields(line, name, number);
    std::string kind = fields.text("type", "query");
    if (fields.has("status")) kind += " " + fields.text("status");
    if (fields.has("ok")) kind += fields.object()["ok"] == true ? " ok" : " failed";
    ++counts[kind];
  }
  if (counts.empty()) throw geom::InputError(name, "expected records, found an empty stream");
  Json out;
  for (const auto& [kind, count] : counts) out[kind] = count;
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Say what is in a box map, a lattice, or a stream of records.", "skyway-info"};
  cli::Common common(app);
  std::string input;
  bool json = false;
  bool verify = false;
  app.add_option("file", input, "any of Skyway's files; - for stdin")->required();
  app.add_flag("--json", json, "as one JSON object");
  app.add_flag("--verify", verify, "check every checksum, and a map's hash, as well");
  return cli::run_tool(app, argc, argv, [&] {
    cli::InputFile file(input);
    Json out;
    if (file.stream().peek() == 'P') {
      if (input == "-") {
        const std::string text = file.read_all();
        out = describe_archive(
            geom::ArrayArchive::from_bytes(std::as_bytes(std::span(text)), "stdin"), verify);
      } else {
        out = describe_archive(cli::open_archive(input), verify);
      }
    } else {
      out = describe_records(file.read_all(), file.name());
    }
    cli::OutputFile print("-", cli::OutputKind::text);
    print.stream() << (json ? out.dump() + '\n' : cli::as_lines(out));
    print.commit();
    return cli::Exit::yes;
  });
}
