#include "exporter.h"

#include <fmt/format.h>

#include "cli/file/files.h"

namespace exporting {

Exporter::Exporter(const cli::Common& common, const Options& options)
    : common_(common), options_(options) {
  if (options.unchecked) return;
  scenes_.emplace(cli::open_map(options.files[0], geom::Verified::contents), options.vehicle,
                  cli::Scenes::Differences::refused);
  geom::Frame frame = scenes_->map().spec().frame;
  if (options.file.placement.origin) frame.origin = options.file.placement.origin;
  wishes_ = options.returns.wishes(frame, options.file.volumes);
}

std::optional<traj::WrittenMission> Exporter::make(const Flight& flight) {
  traj::MissionExport made = export_one(flight);
  if (!made.written) {
    cli::complain("skyway-export", fmt::format("{}: refused: {}", flight.way.id, made.refusal));
  }
  for (const std::string& warning : made.warnings) {
    if (told_.insert(warning).second) common_.warn(warning);
  }
  return std::move(made.written);
}

geom::Frame Exporter::frame_of(const Flight& flight) {
  if (!options_.unchecked) return scene_for(flight).map().spec().frame;
  geom::Frame frame;
  frame.axes = flight.provenance.frame.value_or(geom::Axes::enu);
  return frame;
}

traj::MissionExport Exporter::export_one(const Flight& flight) {
  if (!flight.missing.empty()) return {{}, flight.missing};
  std::string unfit = traj::why_unfit(flight.way, options_.format());
  if (!unfit.empty()) return {{}, std::move(unfit)};
  return options_.unchecked ? export_unchecked(flight) : export_checked(flight);
}

traj::MissionExport Exporter::export_unchecked(const Flight& flight) {
  traj::Limits limits = flight.way.limits;
  const auto asked = options_.vehicle.asked(options_.vehicle.profile());
  if (asked.vehicle || flight.provenance.vehicle) {
    const auto room = geom::agreed_room(flight.provenance, asked, geom::Differences::refused,
                                        options_.input(), 0);
    limits = geom::limits_that_hold({{}, limits, room.vehicle.limits});
  }
  return traj::export_unchecked(flight.way, limits, frame_of(flight), options_.format(),
                                options_.file);
}

// A mission of DJI is for an aircraft whose profile is known.
void Exporter::require_vehicle(const Flight& flight) const {
  if (scenes_->asked().vehicle || flight.provenance.vehicle) return;
  if (&options_.format() != &traj::kDjiWpml) return;
  throw cli::UsageError(
      fmt::format("no vehicle: the record names none; give --vehicle {}, which is the aircraft "
                  "that the mission is for (--aircraft)",
                  traj::vehicle_of(options_.file.dji.aircraft)));
}

traj::MissionExport Exporter::export_checked(const Flight& flight) {
  require_vehicle(flight);
  const geom::CollisionScene& scene = scene_for(flight);
  options_.metres.check_input(scene.map().spec().frame, flight.way.trajectory, flight.way.id, 0);
  if (!wishes_.any()) {
    return traj::export_mission(scene, flight.way, options_.format(), options_.file);
  }
  return traj::export_with_return(scene, flight.way, options_.format(), options_.file, wishes_);
}

}  // namespace exporting
