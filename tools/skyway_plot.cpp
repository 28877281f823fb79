// skyway-plot: SVG pictures of maps with paths, and of trajectories.

#include "cli/files.h"
#include "cli/run.h"
#include "geom/error.h"
#include "plot/motion_profile.h"
#include "plot/plan_view.h"

namespace {

std::vector<geom::PathRecord> read_paths(const std::string& input) {
  std::vector<geom::PathRecord> paths;
  cli::InputFile file(input);
  file.for_each_line([&](const std::string& line, std::size_t number) {
    paths.push_back(geom::parse_path_record(line, file.name(), number));
  });
  return paths;
}

std::string profile_of_first_solved(const std::string& input) {
  cli::InputFile file(input);
  std::string svg;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    const auto record = traj::parse_trajectory_record(line, file.name(), number);
    if (svg.empty() && record.status == "solved") svg = plot::motion_profile(record);
  });
  if (svg.empty()) throw geom::InputError(file.name(), "expected a solved trajectory, found none");
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Draw a plan view or a motion profile as SVG.", "skyway-plot"};
  cli::Common common(app);
  std::string map_file;
  std::string input;
  std::string output = "-";
  CLI::App* plan = app.add_subcommand("plan", "a map from above, with paths");
  plan->add_option("map", map_file, "box map; - for stdin")->required();
  plan->add_option("paths", input, "paths to draw on it; - for stdin");
  CLI::App* profile = app.add_subcommand("profile", "height, speed, acceleration and jerk");
  profile->add_option("file", input, "trajectories; the first solved one is drawn")->required();
  for (CLI::App* verb : {plan, profile}) {
    verb->fallthrough();
    verb->add_option("-o,--output", output, "SVG to write (default: stdout)");
  }
  app.require_subcommand(1);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, input});
    std::string svg;
    if (plan->parsed()) {
      const auto paths = input.empty() ? std::vector<geom::PathRecord>{} : read_paths(input);
      svg = plot::plan_view(cli::open_map(map_file), paths);
    } else {
      svg = profile_of_first_solved(input);
    }
    cli::OutputFile out(output, cli::OutputKind::text);
    out.stream() << svg;
    out.commit();
    return cli::Exit::yes;
  });
}
