#include "traj/mission/dji/dji_aircraft.h"

namespace traj {

const DjiAirframe* airframe_of(const DjiAircraft& aircraft) {
  for (const DjiAirframe& known : kDjiAirframes) {
    if (known.type == aircraft.type) return &known;
  }
  return nullptr;
}

std::string_view vehicle_of(const DjiAircraft& aircraft) {
  for (const NamedDjiAircraft& known : kDjiAircraft) {
    if (known.aircraft == aircraft) return known.name;
  }
  const DjiAirframe* airframe = airframe_of(aircraft);
  return airframe ? airframe->vehicle : std::string_view();
}

}  // namespace traj
