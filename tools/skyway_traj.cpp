// skyway-traj: minimum-snap trajectories along paths, each proved before it is written.

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <optional>

#include "cli/files.h"
#include "cli/limit_options.h"
#include "cli/numbers_option.h"
#include "cli/processes.h"
#include "cli/record_output.h"
#include "cli/run.h"
#include "cli/solver_words.h"
#include "cli/vehicle_option.h"
#include "traj/io/corridor_record.h"
#include "traj/io/solved_record.h"
#include "traj/solve.h"
#include "traj/yaw.h"

namespace {

constexpr double kDrawnReach = 10;  // metres: how far a corridor is drawn from its piece

// --yaw along, DEGREES, or X,Y of a point to look at; up to 90 degrees/s where no limit is given.
std::optional<traj::YawOptions> yaw_options(const std::string& text, traj::Limits& limits) {
  if (text.empty()) return std::nullopt;
  if (!limits.yaw_rate) limits.yaw_rate = std::numbers::pi / 2;
  traj::YawOptions yaw;
  yaw.rate = *limits.yaw_rate * (1 - 1e-9);  // room for rounding in the proof
  if (text == "along") return yaw;
  if (const auto degrees = cli::parse_numbers(text, 1)) {
    yaw.kind = traj::YawOptions::Kind::fixed;
    yaw.angle = degrees->front() * std::numbers::pi / 180;
  } else if (const auto point = cli::parse_numbers(text, 2)) {
    yaw.kind = traj::YawOptions::Kind::towards;
    yaw.target = {point->front(), point->back(), 0};
  } else {
    throw cli::UsageError(
        fmt::format("--yaw: expected along, degrees, or X,Y of a point, found {}", text));
  }
  return yaw;
}

struct Solved {
  traj::TrajectoryRecord record;
  traj::Corridor corridor = {};  // of the optimiser
};

Solved solve(const geom::CollisionScene& scene, const geom::PathRecord& path,
             const traj::SolveOptions& options, const std::optional<traj::YawOptions>& yaw) {
  const traj::SolveResult result = traj::solve(scene, traj::waypoints_of(path), options);
  traj::TrajectoryRecord record = traj::trajectory_record(scene, path.id, result, options.limits);
  if (yaw && !record.trajectory.segments.empty()) traj::add_yaw(*yaw, record.trajectory);
  return {std::move(record), result.corridor};
}

Solved without_path(const geom::PathRecord& path, const traj::Limits& limits) {
  traj::TrajectoryRecord record;
  record.id = path.id;
  record.status = "no_path";
  record.provenance = path.provenance;
  record.limits = limits;
  record.message = path.message.empty() ? path.status : path.message;
  return {std::move(record)};
}

// What a process answers: the rung or status, the trajectory, and its corridor, a line each.
struct Answer {
  std::string found;
  std::string_view trajectory;
  std::string_view corridor;

  static std::string text(const Solved& solved, bool with_corridor) {
    const traj::TrajectoryRecord& record = solved.record;
    std::string out = record.status == "solved" ? record.rung : record.status;
    out += '\n' + traj::to_json_line(record);
    if (with_corridor) {
      out += traj::to_json_line(record.id, record.provenance, solved.corridor, kDrawnReach);
    }
    return out;
  }
  explicit Answer(std::string_view text) {
    const std::size_t first = text.find('\n') + 1;
    const std::size_t second = text.find('\n', first) + 1;
    found = text.substr(0, first - 1);
    trajectory = text.substr(first, second - first);
    corridor = text.substr(second);
  }
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Solve minimum-snap trajectories along paths, and prove them.", "skyway-traj"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  traj::SolveOptions options;
  std::string map_file;
  std::string input = "-";
  std::string output = "-";
  std::string solver = "auto";
  std::string times;
  cli::LimitOptions limit_options;
  std::string corridor_file;
  std::string yaw_text;
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("paths", input, "paths, JSON Lines (default: stdin)");
  app.add_option("-o,--output", output, "trajectories (default: stdout)");
  vehicle.add_to(app);
  limit_options.add_to(app);
  app.add_option("--solver", solver, "auto, closed, ipopt or stop-and-go")
      ->check(CLI::IsMember({"auto", "closed", "ipopt", "stop-and-go"}));
  app.add_option("--times", times, "leg times: stops, distance, cautious, trapezoid or optimised")
      ->check(CLI::IsMember({"stops", "distance", "cautious", "trapezoid", "optimised"}));
  app.add_option("--corridor", options.corridor,
                 "of the optimiser: planes (default) between path and obstacles, or empty boxes")
      ->transform(CLI::CheckedTransformer(cli::kCorridors));
  app.add_option("--corridor-file", corridor_file,
                 "write the optimiser's corridors, JSON Lines with vertices and faces to draw");
  app.add_option("--rho", options.rho, "flight seconds a unit of snap is worth, s per m2/s7")
      ->check(CLI::Range(0.0, 1e3));
  app.add_option("--yaw", yaw_text,
                 "along (the velocity), degrees from the map's x axis towards y, or X,Y of a point "
                 "to look at (default: no yaw)");
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, input});
    if (corridor_file == "-" && output == "-") {
      throw cli::UsageError("trajectories and corridors cannot both go to stdout");
    }
    cli::choose_solver(solver, times, options);
    sharding.begin(app, {{"map", map_file}, {"paths", input}},
                   {{"output", output}, {"corridor-file", corridor_file}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    options.limits = cli::limits_to_solve(limit_options.limits(), scenes.profile());
    const auto yaw = yaw_options(yaw_text, options.limits);
    cli::InputFile file(input);
    cli::RecordOutput out(output, "output", sharding);
    std::optional<cli::RecordOutput> corridors;
    if (!corridor_file.empty()) corridors.emplace(corridor_file, "corridor-file", sharding);
    std::vector<std::pair<std::string, std::size_t>> lines;  // and their numbers
    std::size_t total = 0;
    file.for_each_line([&](const std::string& line, std::size_t number) {
      if (sharding.shard().takes(total++)) lines.emplace_back(line, number);
    });
    // A process an optimisation: MUMPS is not thread safe.
    const auto work = [&](std::size_t i) {
      const auto& [line, number] = lines[i];
      const geom::PathRecord path = geom::parse_path_record(line, file.name(), number);
      const Solved solved =
          path.status == "found"
              ? solve(scenes.scene_for(path.provenance, file.name(), number), path, options, yaw)
              : without_path(path, options.limits);
      return Answer::text(solved, corridors.has_value());
    };
    std::map<std::string, std::size_t> counts;
    const auto run = common.execution("trajectories");
    cli::in_processes(lines.size(), run.threads, work, [&](std::size_t i, const std::string& text) {
      const Answer answer(text);
      ++counts[answer.found];
      if (run.progress) run.progress(i + 1, lines.size());
      out.add(answer.trajectory);
      out.flush();
      if (corridors) corridors->add(answer.corridor);
    });
    const bool no = counts.count("no_path") || counts.count("infeasible");
    const cli::Exit exit = no ? cli::Exit::no : cli::Exit::yes;
    out.commit(total, exit);
    if (corridors) corridors->commit(total, exit);
    common.write_stats({{"records", counts}});
    return exit;
  });
}
