#include "options.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/option/geoid_option.h"
#include "cli/option/option_check.h"
#include "cli/option/placement_option.h"
#include "cli/option/spacing_options.h"
#include "cli/run.h"
#include "geom/text/instant.h"
#include "traj/mission/airspace/flight_volumes.h"

namespace submitting {
namespace {

constexpr double kRadians = 0.017453292519943295;
constexpr double kFar = 1000;  // m

}  // namespace

void Options::add_to(CLI::App& app) {
  app.add_option("map", map, "box map")->required();
  app.add_option("flights", flights,
                 "trajectories that say when they begin, and missions (QGroundControl plans, WPL)")
      ->required();
  app.add_option("-o,--output", folder, "folder to make")->required()->type_name("FOLDER");
  app.add_option("--operation", operation, "who flies what: operator and vehicle, JSON")
      ->required()
      ->type_name("FILE");
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  limits.add_to(app);
  cli::add_origin(app, placement_);
  cli::add_geoid_grid(app, placement_);
  cli::add_ground(app, placement_);
  terrain.add_to(app);
  app.add_option("--volumes", asked_.volumes,
                 "how many volumes of airspace a flight has at most (default 8)")
      ->check(CLI::Range(std::size_t{1}, traj::kMostVolumes));
  app.add_option("--buffer", asked_.buffer,
                 "metres around the vehicle and its margin on every side, for how far it may "
                 "stray (default 0)")
      ->check(CLI::Range(0.0, kFar));
  app.add_option("--tube", tube,
                 "reports of skyway-fly --proved-tube: volumes hold the vehicle in the proved tube "
                 "of its trajectory, which takes the place of the margin")
      ->type_name("FILE");
  app.add_option("--between", between_,
                 "from when until when missions are flown, which have no times, as "
                 "2026-05-04T06:30:00Z,2026-05-04T07:00:00Z")
      ->type_name("INSTANT,INSTANT");
  add_risk(app);
  autopilot_.add_to(app);
  app.add_option("--return-height", asked_.return_height,
                 "metres above home at which the autopilot returns (default: as its firmware says)")
      ->check(CLI::Range(0.0, 1e4));
  app.add_flag("--together", together_,
               "compare the trajectories with one another, too: the folder says that they keep "
               "apart, or which do not");
  cli::add_spacing(app, rule_.spacing, rule_.parked);
  app.add_option("--population", population,
                 "raster with the number of people in each cell (GeoTIFF and whatever GDAL reads)")
      ->type_name("FILE");
  app.add_flag("--no-page", no_page, "leave out the page that shows map and flights");
}

void Options::add_risk(CLI::App& app) {
  app.add_option("--contingency", contingency_,
                 "contingency volumes: stop, for a multirotor that stops; return, for all places "
                 "of the autopilot's own return (default stop)")
      ->check(CLI::IsMember({"stop", "return"}));
  app.add_option("--ground-buffer", ground_buffer_,
                 "ground risk buffer: 1:1, as wide as the contingency volume is high; ballistic, "
                 "as far as the vehicle falls (default 1:1)")
      ->check(CLI::IsMember({"1:1", "ballistic"}));
  app.add_option("--reaction", asked_.risk.reaction,
                 "seconds until the vehicle begins to stop (default 1)")
      ->check(CLI::Range(0.0, 600.0));
  app.add_option("--stop-tilt", tilt_deg_, "degrees by which it tilts to stop (default 35)")
      ->check(CLI::Range(1.0, 80.0));
  app.add_option("--ground-level", floor_,
                 "metres in the map's z: no ground below the flights is lower (default: the floor "
                 "of the map's bounds, or the lowest ground of --ground-model over the map, if "
                 "that is lower)");
}

void Options::require_sound(const CLI::App& app) const {
  cli::only_for(app, contingency_ == "stop", {"--reaction", "--stop-tilt"}, "--contingency stop");
  terrain.refuse_idle({});
  if (terrain.any() && terrain.file().empty()) {
    throw cli::UsageError(
        "--ground-model: expected a file of skyway-footprints --ground-of, which becomes a part of "
        "the folder, found the height of flat ground");
  }
  for (const char* option : cli::kSpacingOptions) {
    cli::only_for(app, together_, {option}, "--together");
  }
}

void Options::take_between(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos) {
    asked_.begins = geom::epoch_from(text.substr(0, comma));
    asked_.ends = geom::epoch_from(text.substr(comma + 1));
  }
  if (asked_.begins && asked_.ends &&
      geom::seconds_between(*asked_.begins, *asked_.ends).least > 0) {
    return;
  }
  throw cli::UsageError(
      fmt::format("--between: expected two instants, the earlier first, as "
                  "2026-05-04T06:30:00Z,2026-05-04T07:00:00Z; found \"{}\"",
                  text));
}

traj::SubmissionMethod Options::method(const traj::Operation& by, const geom::BoxMapSpec& map_spec,
                                       const std::string& hash) const {
  Options settled = *this;
  if (!between_.empty()) settled.take_between(between_);
  const auto profile = vehicle.profile();
  settled.autopilot_.settle(profile);
  if (profile) traj::require_dimension(by, *profile, operation);
  traj::SubmissionMethod out = settled.asked_;
  const geom::AskedRoom room = vehicle.asked(profile);
  out.made_for = {hash, map_spec.frame.axes, room.vehicle, room.margin};
  const traj::MissionFrame frame = placement_.mission_frame(map_spec.frame);
  if (frame.origin.height == 0 && !placement_.origin) {
    throw cli::UsageError(
        "altitudes of volumes are above the ellipsoid, and the map does not say how high above it "
        "its z = 0 is: give --origin latitude,longitude,height");
  }
  out.origin = frame.origin;
  out.geoid = placement_.geoid;
  if (placement_.geoid_grid) out.geoid_grid = placement_.geoid_name;
  out.ground = placement_.ground;
  out.limits = limits.limits();
  out.risk.contingency = *geom::value_of(traj::kContingencyWords, contingency_);
  out.risk.buffer = *geom::value_of(traj::kBufferWords, ground_buffer_);
  out.risk.dimension = by.uas.dimension;
  if (tilt_deg_) out.risk.tilt = *tilt_deg_ * kRadians;
  out.floor = floor_.value_or(map_spec.bounds.min.z());
  out.autopilot = autopilot_.word;
  if (!autopilot_.params.empty()) {
    out.params = std::filesystem::path(autopilot_.params).filename().string();
  }
  out.navigation = settled.autopilot_.flier.navigation;
  out.drag = settled.autopilot_.flier.autopilots.front().drag;
  if (profile) out.energy = profile->energy;
  out.endurance = by.uas.endurance;
  if (together_) out.together = traj::TogetherRule{rule_.spacing, rule_.parked, true};
  return out;
}

}  // namespace submitting
