// skyway-join: the shards of a run become what one run would have written.

#include "cli/option/output_option.h"
#include "cli/run.h"
#include "cli/shard/sharding.h"
#include "geom/archive/record_part.h"
#include "geom/base/error.h"
#include "plan/lattice/lattice_file.h"
#include "plan/lattice/part_file.h"
#include "plan/roadmap/part_file.h"
#include "plan/roadmap/roadmap_file.h"

namespace {

using geom::ShardFile;

void join_lattices(std::ostream& out, const std::vector<ShardFile>& shards) {
  std::vector<plan::LatticePart> parts;
  for (const ShardFile& s : shards) {
    parts.push_back(plan::read_lattice_part(s.archive, s.content, s.shard));
  }
  plan::write_lattice(out, parts);
}

void join_roadmaps(std::ostream& out, const std::vector<ShardFile>& shards) {
  std::vector<plan::Roadmap> parts;
  for (const ShardFile& s : shards) {
    parts.push_back(plan::read_roadmap_part(s.archive, s.content));
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
    const bool text = kind == "records";
    cli::OutputFile out(output, text ? cli::OutputKind::text : cli::OutputKind::artefact);
    if (text) {
      geom::join_records(out.stream(), shards);
    } else if (kind == "lattice") {
      join_lattices(out.stream(), shards);
    } else if (kind == "roadmap") {
      join_roadmaps(out.stream(), shards);
    } else {
      throw geom::InputError(
          shards.front().archive.name(),
          {.expected = "a kind of shard that is known", .found = geom::in_quotes(kind)});
    }
    out.commit();
    common.write_stats({{"shards", shards.size()}, {"kind", kind}});
    const bool no =
        std::any_of(shards.begin(), shards.end(), [](const ShardFile& s) { return !s.yes; });
    return no ? cli::Exit::no : cli::Exit::yes;
  });
}
