#include "dji_options.h"

#include <string>
#include <vector>

#include "cli/option/numbers_option.h"

namespace exporting {

namespace {

std::vector<std::string> aircraft_names() {
  std::vector<std::string> names;
  for (const auto& known : traj::kDjiAircraft) names.emplace_back(known.name);
  return names;
}

}  // namespace

void add_dji_options(CLI::App& app, traj::DjiOptions& options, std::optional<double>& turns) {
  app.add_option("--wpml-version", options.version,
                 "DJI: version of the format, 1.0.2 or 1.0.6 (default 1.0.6)")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(traj::kWrittenWpmlVersions),
                                                     std::end(traj::kWrittenWpmlVersions))));
  app.add_option_function<std::string>(
         "--aircraft",
         [&options](const std::string& name) {
           for (const traj::NamedDjiAircraft& known : traj::kDjiAircraft) {
             if (name == known.name) options.aircraft = known.aircraft;
           }
         },
         "DJI: the aircraft that the mission is for: m30, m30t, m3e, m3t, m3m, m3d or m3td "
         "(default m3e)")
      ->check(CLI::IsMember(aircraft_names()));
  app.add_option("--turns", turns,
                 "DJI: turn without a stop, from at most so many metres before each waypoint to as "
                 "many behind it, where there is room (default: stop at each)")
      ->check(CLI::Range(0.2, 1000.0));
  cli::add_point(app, "--takeoff-place", options.takeoff,
                 "DJI: where the aircraft stands before it takes off, along the map's axes "
                 "(default: under the first point)");
  app.add_option_function<std::string>(
         "--lost-link",
         [&options](const std::string& word) {
           options.lost_link = *geom::value_of(traj::kDjiLostLinkWords, word);
         },
         "DJI: what the aircraft does when it loses its controller: return (default), continue, "
         "land or hover; only continue is a way that is proved")
      ->check(CLI::IsMember({"return", "continue", "land", "hover"}));
  app.add_option("--gimbal", options.gimbal,
                 "DJI: pitch of the camera from the first waypoint on, degrees: -90 is down")
      ->check(CLI::Range(traj::kDjiGimbalDown, traj::kDjiGimbalUp));
}

}  // namespace exporting
