// skyway-traj: minimum-snap trajectories along paths, each proved before it is written.

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <optional>

#include "cli/files.h"
#include "cli/numbers_option.h"
#include "cli/processes.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "traj/io/trajectory_record.h"
#include "traj/solve.h"
#include "traj/yaw.h"

namespace {

// The options' limits, where given, else the profile's.
traj::Limits merge(const traj::Limits& asked, const std::optional<cli::VehicleProfile>& profile) {
  const traj::Limits own = profile ? profile->limits : traj::Limits{};
  const auto pick = [](std::optional<double> a, std::optional<double> b) { return a ? a : b; };
  return traj::combined(asked, own, pick);
}

// --yaw along, DEGREES, or X,Y of a point to look at.
std::optional<traj::YawOptions> yaw_options(const std::string& text, double rate) {
  if (text.empty()) return std::nullopt;
  traj::YawOptions yaw;
  yaw.rate = rate * std::numbers::pi / 180;
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

std::string solver_report(const traj::SolveResult& result) {
  std::string out = R"({"status":)";
  geom::append_json(out, std::string_view(result.solver_status));
  out += fmt::format(R"(,"rounds":{},"iterations":{},"snap":)", result.rounds, result.iterations);
  geom::append_json(out, result.snap);
  return out + '}';
}

traj::TrajectoryRecord solve(const geom::CollisionScene& scene, const geom::PathRecord& path,
                             const traj::SolveOptions& options,
                             const std::optional<traj::YawOptions>& yaw) {
  traj::TrajectoryRecord record;
  record.id = path.id;
  record.provenance = geom::provenance_of(scene);
  record.limits = options.limits;
  const traj::SolveResult result = traj::solve(scene, path.points, options);
  record.status = result.status == traj::SolveStatus::solved ? "solved" : "infeasible";
  record.message = result.reason;
  record.trajectory = result.trajectory;
  if (yaw && !record.trajectory.segments.empty()) traj::add_yaw(*yaw, record.trajectory);
  record.rung = result.rung;
  if (result.status == traj::SolveStatus::solved) record.solver = solver_report(result);
  return record;
}

traj::TrajectoryRecord without_path(const geom::PathRecord& path, const traj::Limits& limits) {
  traj::TrajectoryRecord record;
  record.id = path.id;
  record.status = "no_path";
  record.provenance = path.provenance;
  record.limits = limits;
  record.message = path.message.empty() ? path.status : path.message;
  return record;
}

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
  std::optional<double> tilt;
  std::string yaw_text;
  double yaw_rate = 90;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("paths", input, "paths, JSON Lines (default: stdin)");
  app.add_option("-o,--output", output, "trajectories (default: stdout)");
  vehicle.add_to(app);
  app.add_option("--vmax", options.limits.vmax, "largest speed, m/s")->check(CLI::PositiveNumber);
  app.add_option("--amax", options.limits.amax, "largest acceleration, m/s2")
      ->check(CLI::PositiveNumber);
  app.add_option("--jmax", options.limits.jmax, "largest jerk, m/s3")->check(CLI::PositiveNumber);
  app.add_option("--vmax-h", options.limits.vmax_h, "largest horizontal speed, m/s")
      ->check(CLI::PositiveNumber);
  app.add_option("--vmax-v", options.limits.vmax_v, "largest vertical speed, m/s")
      ->check(CLI::PositiveNumber);
  app.add_option("--tilt", tilt, "largest tilt of the thrust from upright, degrees")
      ->check(CLI::Range(1.0, 80.0));
  app.add_option("--thrust", options.limits.thrust,
                 "largest thrust over mass, m/s2 (above 9.80665)")
      ->check(CLI::Range(9.81, 1e4));
  app.add_option("--solver", solver, "auto, closed, ipopt or stop-and-go")
      ->check(CLI::IsMember({"auto", "closed", "ipopt", "stop-and-go"}));
  app.add_option("--rho", options.rho, "flight seconds a unit of snap is worth, s per m2/s7")
      ->check(CLI::Range(0.0, 1e3));
  app.add_option("--yaw", yaw_text,
                 "along (the velocity), degrees from the map's x axis towards y, or X,Y of a point "
                 "to look at (default: no yaw)");
  app.add_option("--yaw-rate", yaw_rate, "largest yaw rate, degrees/s (default 90)")
      ->check(CLI::Range(0.1, 1e4));
  return cli::run_tool(app, argc, argv, [&] {
    const auto yaw = yaw_options(yaw_text, yaw_rate);
    cli::at_most_one_stdin({map_file, input});
    options.solver = solver == "closed"  ? traj::Solver::closed
                     : solver == "ipopt" ? traj::Solver::ipopt
                     : solver == "auto"  ? traj::Solver::automatic
                                         : traj::Solver::stop_and_go;
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    if (tilt) options.limits.tilt = *tilt * std::numbers::pi / 180;
    options.limits = merge(options.limits, scenes.profile());
    const traj::Limits& limits = options.limits;
    if ((!limits.vmax && !(limits.vmax_h && limits.vmax_v)) ||
        (!limits.amax && !(limits.tilt && limits.thrust))) {
      throw cli::UsageError(
          "no limits: give --vmax (or --vmax-h and --vmax-v) and --amax (or --tilt and --thrust)");
    }
    cli::InputFile file(input);
    cli::OutputFile out(output, cli::OutputKind::text);
    std::vector<std::pair<std::string, std::size_t>> lines;  // and their numbers
    file.for_each_line(
        [&](const std::string& line, std::size_t number) { lines.emplace_back(line, number); });
    // A process an optimisation: MUMPS is not thread safe. What was found comes first in a reply.
    const auto work = [&](std::size_t i) {
      const auto& [line, number] = lines[i];
      const geom::PathRecord path = geom::parse_path_record(line, file.name(), number);
      const auto record =
          path.status == "found"
              ? solve(scenes.scene_for(path.provenance, file.name(), number), path, options, yaw)
              : without_path(path, options.limits);
      return (record.status == "solved" ? record.rung : record.status) + '\n' +
             traj::to_json_line(record);
    };
    std::map<std::string, std::size_t> counts;
    const auto run = common.execution("trajectories");
    cli::in_processes(lines.size(), run.threads, work, [&](std::size_t i, const std::string& text) {
      const std::size_t end = text.find('\n');
      ++counts[text.substr(0, end)];
      if (run.progress) run.progress(i + 1, lines.size());
      out.stream() << std::string_view(text).substr(end + 1);
      out.flush();
    });
    out.commit();
    common.write_stats({{"records", counts}});
    return counts.count("no_path") || counts.count("infeasible") ? cli::Exit::no : cli::Exit::yes;
  });
}
