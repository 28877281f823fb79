// skyway-traj: minimum-snap trajectories along paths, each proved before it is written.

#include <algorithm>
#include <map>
#include <optional>

#include "answer.h"
#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/shard/record_output.h"
#include "geom/base/processes.h"
#include "options.h"
#include "traj/record/verdict.h"

namespace {

struct Line {
  std::string text;
  std::size_t number = 0;
};

// What a shard takes of the paths.
struct Share {
  std::string source;
  std::vector<Line> lines;
  std::size_t total = 0;  // of all shards
};

Share read_share(const std::string& path, const geom::Shard& shard) {
  cli::InputFile file(path);
  Share share{file.name(), {}, 0};
  file.for_each_line([&](const std::string& line, std::size_t number) {
    if (shard.takes(share.total++)) share.lines.push_back({line, number});
  });
  return share;
}

struct Outputs {
  cli::RecordOutput trajectories;
  std::optional<cli::RecordOutput> corridors;

  void add(const solving::Answer& answer) {
    trajectories.add(answer.trajectory);
    trajectories.flush();
    if (corridors) corridors->add(answer.corridor);
  }
  void commit(std::size_t total, cli::Exit exit) {
    trajectories.commit(total, exit);
    if (corridors) corridors->commit(total, exit);
  }
};

using Counts = std::map<std::string, std::size_t, std::less<>>;  // by rung or status

traj::SolvedRecord answer_to(const geom::PathRecord& path, const std::string& source,
                             std::size_t line, const solving::Options& options,
                             cli::Scenes& scenes) {
  if (path.status != geom::PathStatus::found) {
    const auto vehicle =
        scenes.profile() ? std::optional(scenes.profile()->vehicle) : path.provenance.vehicle;
    return {traj::without_path(path, options.limits_for(vehicle.value_or(geom::Vehicle{})))};
  }
  const geom::CollisionScene& scene = scenes.scene_for(path.provenance, source, line);
  options.metres.check_input(scene.map().spec().frame, path.points, source, line);
  const solving::Task task = options.task(scene.vehicle());
  return traj::solve_record(scene, path, task.options, task.yaw);
}

struct Tally {
  Counts counts;
  cli::Batch batch;
};

bool is_failure(std::string_view found) { return found == "no_path" || found == "infeasible"; }

void add(const solving::Answer& answer, const std::string& source, Tally& tally) {
  ++tally.counts[std::string(answer.found)];
  if (!is_failure(answer.found)) return tally.batch.add_good();
  const traj::TrajectoryRecord record = traj::parse_trajectory_record(answer.trajectory, source, 0);
  tally.batch.add_failed(answer.found, record.id + ": " + traj::in_words(record));
}

// A process an optimisation: MUMPS is not thread safe.
Tally solve_each(const Share& share, const solving::Options& options, cli::Scenes& scenes,
                 const geom::Execution& run, Outputs& out) {
  const auto work = [&](std::size_t i) {
    const auto& [line, number] = share.lines[i];
    const geom::PathRecord path = geom::parse_path_record(line, share.source, number);
    return solving::to_text(answer_to(path, share.source, number, options, scenes),
                            out.corridors.has_value());
  };
  Tally tally;
  const auto take = [&](std::size_t i, const std::string& text) {
    const solving::Answer answer = solving::parse_answer(text);
    add(answer, share.source, tally);
    if (run.progress) run.progress(i + 1, share.lines.size());
    out.add(answer);
  };
  geom::in_processes(share.lines.size(), run.threads, work, take);
  return tally;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Solve minimum-snap trajectories along paths, and prove them.", "skyway-traj"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  solving::Options options;
  std::string map_file;
  std::string input = "-";
  std::string output = "-";
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("paths", input, "paths, JSON Lines (default: stdin)");
  cli::add_output(app, "-o,--output", output, "trajectories (default: stdout)");
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  options.add_to(app);
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, input});
    options.choose_solver();
    sharding.begin(app, {{"map", map_file}, {"paths", input}},
                   {{"output", output}, {"corridor-file", options.corridor_file}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::Scenes scenes(cli::open_map(map_file, geom::Verified::extents, common.execution("verify")),
                       vehicle, geom::Differences::refused);
    if (scenes.profile()) options.task(scenes.profile()->vehicle);  // refuses before it reads
    const Share share = read_share(input, sharding.shard());
    Outputs out{{output, "output", sharding}, std::nullopt};
    if (!options.corridor_file.empty()) {
      out.corridors.emplace(options.corridor_file, "corridor-file", sharding);
    }
    const auto [counts, batch] =
        solve_each(share, options, scenes, common.execution("trajectories"), out);
    const bool no = std::any_of(counts.begin(), counts.end(),
                                [](const auto& count) { return is_failure(count.first); });
    const cli::Exit exit = no ? cli::Exit::no : cli::Exit::yes;
    out.commit(share.total, exit);
    batch.tell(common, "skyway-traj", "paths have no trajectory");
    common.write_stats({{"records", counts}});
    return exit;
  });
}
