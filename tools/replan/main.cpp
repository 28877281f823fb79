// skyway-replan: paths of another map, kept or mended on this one.

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/batch.h"
#include "cli/content/artefacts.h"
#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/output_option.h"
#include "cli/option/quality_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "geom/base/parallel.h"
#include "plan/planner/replanned_record.h"

namespace {

struct Line {
  geom::PathRecord record;
  std::size_t number = 0;
};

struct Paths {
  std::string source;
  std::vector<Line> lines;
};

Paths read_paths(const std::string& path) {
  cli::InputFile file(path);
  Paths out{file.name(), {}};
  file.for_each_line([&](const std::string& line, std::size_t number) {
    out.lines.push_back({geom::parse_path_record(line, file.name(), number), number});
  });
  return out;
}

bool found(const geom::PathRecord& record) { return record.status == geom::PathStatus::found; }

// Whether two records, as far as they are paths, ask for the same scene.
bool same_scene(const geom::PathRecord& a, const geom::PathRecord& b) {
  return a.provenance.frame == b.provenance.frame && a.provenance.vehicle == b.provenance.vehicle &&
         a.provenance.margin == b.provenance.margin;
}

// The paths that were found, by what scene they ask for; both in the order of the stream.
std::vector<std::vector<std::size_t>> by_scene(const std::vector<Line>& paths) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!found(paths[i].record)) continue;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& known) {
      return same_scene(paths[known.front()].record, paths[i].record);
    });
    if (group == groups.end()) group = groups.emplace(group);
    group->push_back(i);
  }
  return groups;
}

// A record for each path, in order.
std::vector<geom::PathRecord> replan_each(const Paths& paths, cli::Scenes& scenes,
                                          const cli::Artefacts& artefacts, plan::Quality quality,
                                          const geom::Execution& run) {
  const std::vector<Line>& lines = paths.lines;
  std::vector<geom::PathRecord> records(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (found(lines[i].record)) continue;
    records[i] = plan::passed_on(lines[i].record, scenes.map());
  }
  for (const std::vector<std::size_t>& group : by_scene(lines)) {
    const Line& first = lines[group.front()];
    geom::Provenance asked = first.record.provenance;
    asked.map.reset();  // another one, as a rule
    const geom::CollisionScene& scene = scenes.scene_for(asked, paths.source, first.number);
    artefacts.require_made_for(scene);
    plan::Planner planner(scene, artefacts.lattice(), artefacts.roadmap());
    geom::parallel_for(group.size(), run, [&](std::size_t k) {
      records[group[k]] = plan::replanned(scene, planner, lines[group[k]].record, quality);
    });
  }
  return records;
}

struct Tally {
  std::size_t kept = 0;
  std::size_t mended = 0;
  std::size_t failed = 0;
  cli::Batch batch;
};

// The output may take the place of the paths.
Tally write_records(const std::vector<geom::PathRecord>& records, const std::string& output,
                    const std::string& paths, const cli::Common& common) {
  cli::OutputFile out(output, cli::OutputKind::text, paths);
  Tally tally;
  for (const geom::PathRecord& record : records) {
    const bool kept = found(record) && record.origin->mended.empty();
    if (found(record)) {
      tally.batch.add_good();
    } else if (records.size() == 1) {
      tally.batch.add_failed(name(record.status));  // main() says why
    } else {
      tally.batch.add_failed(name(record.status), record.id + ": " + record.message);
    }
    ++(!found(record) ? tally.failed : kept ? tally.kept : tally.mended);
    if (found(record) && !record.message.empty()) {
      common.warn(fmt::format("{}: {}", record.id, record.message));
    }
    out.stream() << geom::to_json_line(record);
  }
  out.commit();
  return tally;
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
  cli::MetresOption metres;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("file,--paths", paths_file, "paths of another map, JSON Lines (default: stdin)");
  artefact_files.add_to(app);
  cli::add_quality(app, quality);
  cli::add_output(app, "-o,--output", output, "paths (default: stdout)");
  metres.add_to(app);
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, paths_file, artefact_files.lattice, artefact_files.roadmap});
    cli::Scenes scenes(cli::open_map(map_file, geom::Verified::extents, common.execution("verify")),
                       vehicle, cli::Scenes::Differences::stricter_allowed);
    const cli::Artefacts artefacts(artefact_files);
    const Paths paths = read_paths(paths_file);
    for (const Line& path : paths.lines) {
      metres.check_input(scenes.map().spec().frame, path.record.points, paths.source, path.number);
    }
    const std::vector<geom::PathRecord> records =
        replan_each(paths, scenes, artefacts, quality, common.execution("paths"));
    const auto [kept, mended, failed, batch] = write_records(records, output, paths_file, common);
    common.write_stats(
        {{"paths", records.size()}, {"kept", kept}, {"mended", mended}, {"failed", failed}});
    batch.tell(common, "skyway-replan", "paths could be neither kept nor mended");
    if (records.size() == 1 && failed) {
      cli::complain("skyway-replan", records[0].message);
    }
    return failed ? cli::Exit::no : cli::Exit::yes;
  });
}
