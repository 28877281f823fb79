// skyway-replan: paths of another map, kept or mended on this one.

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "cli/artefacts.h"
#include "cli/files.h"
#include "cli/quality_option.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/parallel.h"
#include "plan/io/path_record.h"
#include "plan/replan.h"

namespace {

struct Input {
  geom::PathRecord record;
  std::size_t line = 0;
};

std::vector<Input> read_paths(const std::string& path, std::string& source) {
  cli::InputFile file(path);
  source = file.name();
  std::vector<Input> out;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    out.push_back({geom::parse_path_record(line, file.name(), number), number});
  });
  return out;
}

bool found(const geom::PathRecord& record) { return record.status == "found"; }

// Whether two records, as far as they are paths, ask for the same scene.
bool same_scene(const geom::PathRecord& a, const geom::PathRecord& b) {
  return a.provenance.frame == b.provenance.frame && a.provenance.vehicle == b.provenance.vehicle &&
         a.provenance.margin == b.provenance.margin;
}

geom::PathRecord passed_on(geom::PathRecord record) {
  record.message = "no path to replan" + (record.message.empty() ? "" : ": " + record.message);
  return record;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Keep or mend the paths of another map on this one.", "skyway-replan"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  std::string map_file;
  std::string paths_file = "-";
  cli::ArtefactFiles artefact_files;
  std::string output = "-";
  plan::Quality quality = plan::Quality::normal;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("file,--paths", paths_file, "paths of another map, JSON Lines (default: stdin)");
  artefact_files.add_to(app);
  cli::add_quality(app, quality);
  app.add_option("-o,--output", output, "paths (default: stdout)");
  vehicle.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, paths_file, artefact_files.lattice, artefact_files.roadmap});
    cli::Scenes scenes(cli::open_map(map_file), vehicle,
                       cli::Scenes::Differences::stricter_allowed);
    const cli::Artefacts artefacts(artefact_files);
    std::string source;
    const std::vector<Input> paths = read_paths(paths_file, source);

    std::vector<geom::PathRecord> records(paths.size());
    const geom::Execution run = common.execution("paths");
    for (std::size_t begin = 0, end = 0; begin < paths.size(); begin = end) {
      if (!found(paths[begin].record)) {
        records[begin] = passed_on(paths[begin].record);
        end = begin + 1;
        continue;
      }
      const geom::PathRecord& first = paths[begin].record;
      while (end < paths.size() && found(paths[end].record) &&
             same_scene(first, paths[end].record)) {
        ++end;
      }
      geom::Provenance asked = first.provenance;
      asked.map.reset();  // another one, as a rule
      const geom::CollisionScene& scene = scenes.scene_for(asked, source, paths[begin].line);
      artefacts.require_made_for(scene);
      plan::Planner planner(scene, artefacts.lattice(), artefacts.roadmap());
      geom::parallel_for(end - begin, run, [&](std::size_t i) {
        const geom::PathRecord& old = paths[begin + i].record;
        const plan::ReplanResult result = plan::replan(scene, planner, old.points, quality);
        geom::PathRecord& record = records[begin + i];
        record = plan::path_record(scene, old.id, result.plan);
        if (found(record)) record.origin = result.origin;
      });
    }

    cli::OutputFile out(output, cli::OutputKind::text);
    std::size_t kept = 0;
    std::size_t mended = 0;
    for (const geom::PathRecord& record : records) {
      if (found(record)) ++(record.origin->mended.empty() ? kept : mended);
      out.stream() << geom::to_json_line(record);
    }
    out.commit();
    const std::size_t failed = records.size() - kept - mended;
    common.write_stats(
        {{"paths", records.size()}, {"kept", kept}, {"mended", mended}, {"failed", failed}});
    if (records.size() == 1 && failed)
      fmt::print(stderr, "skyway-replan: {}\n", records[0].message);
    return failed ? cli::Exit::no : cli::Exit::yes;
  });
}
