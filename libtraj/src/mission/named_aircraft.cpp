#include "traj/mission/named_aircraft.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "traj/flight/vehicle_profile.h"

namespace traj {
namespace {

std::string shown(const geom::Vec3& half) {
  return fmt::format("{:.3g} x {:.3g} x {:.3g} m", 2 * half.x(), 2 * half.y(), 2 * half.z());
}

}  // namespace

std::string why_too_small(const geom::Vehicle& vehicle, std::string_view aircraft) {
  const auto named = vehicle_named(aircraft);
  if (!named || (vehicle.half.array() >= named->vehicle.half.array()).all()) return "";
  return fmt::format(
      "the mission is for the aircraft {0}, whose box is {1}, and the box of {2} is {3}: give "
      "--vehicle {0}, or a box that is as large",
      aircraft, shown(named->vehicle.half), vehicle.name, shown(vehicle.half));
}

void require_room_for_aircraft(const geom::Vehicle& vehicle, const FileFlight& file) {
  std::string why = why_too_small(vehicle, file.vehicle);
  if (!why.empty()) throw geom::InputError(file.id, {.says = std::move(why)});
}

geom::Provenance made_for(const FileFlight& file, geom::Provenance asked) {
  if (asked.vehicle) {
    require_room_for_aircraft(*asked.vehicle, file);
  } else if (const auto named = vehicle_named(file.vehicle)) {
    asked.vehicle = named->vehicle;
  }
  return asked;
}

}  // namespace traj
