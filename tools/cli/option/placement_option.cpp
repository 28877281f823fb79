#include "placement_option.h"

#include "geoid_option.h"
#include "origin_option.h"

namespace cli {

void add_origin(CLI::App& app, traj::Placement& placement) {
  app.add_option_function<std::string>(
         "--origin",
         [&placement](const std::string& text) { placement.origin = origin_from(text); },
         "where on Earth the map's (0, 0, 0) is: degrees, and metres above the ellipsoid where "
         "that is known (default: what the map says)")
      ->type_name(kOriginForm);
  app.add_option("--geoid", placement.geoid,
                 "height of the sea level there above the ellipsoid, metres; converts heights "
                 "above the sea (default 0)")
      ->check(CLI::Range(-200.0, 200.0));
}

void add_ground(CLI::App& app, traj::Placement& placement) {
  app.add_option("--ground", placement.ground,
                 "height of the ground at the take-off, in the map's z")
      ->check(CLI::Range(-1e6, 1e6));
}

void add_placement(CLI::App& app, traj::Placement& placement) {
  add_origin(app, placement);
  add_geoid_grid(app, placement);
  add_ground(app, placement);
  app.add_option("--takeoff-height", placement.takeoff_height,
                 "metres above the ground to which a Tello rises on take-off (default 1)")
      ->check(CLI::Range(0.2, 10.0));
  app.add_option(
         "--heading", placement.heading,
         "where a Tello's nose points on the ground, or a DJI aircraft's on its way, degrees "
         "clockwise from north")
      ->check(CLI::Range(-360.0, 360.0));
}

}  // namespace cli
