// What goes beside a Tello script: a program and a table.

#include <fmt/format.h>

#include <numbers>
#include <ostream>

#include "traj/mission/formats/tello.h"

namespace traj {
namespace {

// DJITelloPy gives up on an answer after 7 s and sends the command again, up to three times: a leg
// that takes longer would be flown twice. So one attempt a command, and time enough.
constexpr std::string_view kProgram = R"(
from djitellopy import Tello

# Forward, left and up in centimetres, centimetres a second, and seconds to wait for the answer.
LEGS = [
{}]

drone = Tello(retry_count=1)  # a command that was sent twice would be flown twice
drone.connect()
print(f"battery: {{drone.get_battery()}} %")
drone.takeoff()
try:
    for x, y, z, speed, patience in LEGS:
        drone.send_control_command(f"go {{x}} {{y}} {{z}} {{speed}}", timeout=patience)
finally:
    {}
)";

}  // namespace

void write_tello_python(std::ostream& out, const TelloFlight& flight, const TelloStart& start,
                        std::string_view note) {
  out << fmt::format(
      "\"\"\"{}\n\nStand the drone at east {:.3f} m, north {:.3f} m, up {:.3f} m of the map, its "
      "nose "
      "{:.6g} degrees clockwise\nfrom north. It is expected to hover {:.6g} m above the ground "
      "after "
      "taking off.\n\"\"\"\n",
      note, start.ground.x(), start.ground.y(), start.ground.z(),
      start.heading * 180 / std::numbers::pi, start.takeoff_height);
  const std::vector<double> times = tello_times(flight, start);
  std::string legs;
  for (std::size_t i = 0; i < flight.legs.size(); ++i) {
    const TelloLeg& leg = flight.legs[i];
    const int patience = 15 + static_cast<int>(2 * (times[i + 1] - times[i]));
    legs += fmt::format("    ({}, {}, {}, {}, {}),\n", leg.x, leg.y, leg.z, leg.speed, patience);
  }
  out << fmt::format(kProgram, legs,
                     flight.lands ? "drone.land()" : "print(\"hovering: land it by hand\")");
}

void write_tello_csv(std::ostream& out, const TelloFlight& flight, const TelloStart& start) {
  out << "leg,time_s,east_m,north_m,up_m,forward_cm,left_cm,up_cm,speed_cm_s\n";
  const geom::Polyline path = tello_path(flight, start);
  const std::vector<double> times = tello_times(flight, start);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const TelloLeg leg = i > 0 ? flight.legs[i - 1] : TelloLeg{};
    out << fmt::format("{},{:.1f},{:.4f},{:.4f},{:.4f},{},{},{},{}\n", i, times[i], path[i].x(),
                       path[i].y(), path[i].z(), leg.x, leg.y, leg.z, leg.speed);
  }
}

}  // namespace traj
