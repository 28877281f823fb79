#include "traj/home/return_parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

namespace traj {
namespace {

// Types of MAVLink's parameters (MAV_PARAM_TYPE).
constexpr int kWhole = 6;
constexpr int kReal = 9;

class Px4File {
 public:
  void whole(std::string_view name, int value) {
    text_ += fmt::format("1\t1\t{}\t{}\t{}\n", name, value, kWhole);
  }
  void real(std::string_view name, double value) {
    text_ += fmt::format("1\t1\t{}\t{}\t{}\n", name, value, kReal);
  }
  std::string text() const { return text_; }

 private:
  std::string text_ = "# Vehicle: Multi-Rotor\n# Vehicle-Id Component-Id Name Value Type\n";
};

// The half angle of a cone of this height over distance, degrees; 0: there is none.
double half_angle(double slope) {
  return slope > 0 ? std::round(std::atan(1 / slope) * 180 / std::numbers::pi) : 0;
}

std::string px4_parameters(const Autopilot& autopilot) {
  Px4File file;
  file.real("RTL_RETURN_ALT", autopilot.return_height);
  file.whole("RTL_CONE_ANG", static_cast<int>(half_angle(autopilot.return_slope)));
  file.whole("RTL_TYPE", 0);       // home or a rally point, straight
  file.real("RTL_LAND_DELAY", 0);  // lands
  file.whole("NAV_DLL_ACT", 2);    // the ground station is lost: return
  file.whole("NAV_RCL_ACT", 2);    // the remote control is lost: return
  // In missions, too.
  if (autopilot.name != "px4:1.11") file.whole("COM_RCL_EXCEPT", 0);
  if (autopilot.name == "px4:1.17") file.whole("COM_DLL_EXCEPT", 0);
  return file.text();
}

bool counts_in_metres(const Autopilot& autopilot) { return autopilot.name == "ardupilot:4.7"; }

// The mission's fences, and those of the autopilot that it was proved with: by default it would
// have others, 100 m above home and 300 m from it.
int fence_types(const ParameterFence& fence) {
  return 4 + (fence.top ? 1 : 0) + (fence.across ? 2 : 0) + (fence.bottom ? 8 : 0);
}

std::string ardupilot_parameters(const Autopilot& autopilot, const ReturnParameters& what) {
  const bool metres = counts_in_metres(autopilot);
  const double unit = metres ? 1 : 100;
  std::string text;
  const auto add = [&](std::string_view name, double value) {
    text += fmt::format("{},{}\n", name, value);
  };
  add(metres ? "RTL_ALT_M" : "RTL_ALT", autopilot.return_height * unit);
  add(metres ? "RTL_CLIMB_MIN_M" : "RTL_CLIMB_MIN", autopilot.return_climb * unit);
  add(metres ? "RTL_ALT_FINAL_M" : "RTL_ALT_FINAL", 0);  // lands
  add("RTL_CONE_SLOPE", autopilot.return_slope);
  add("FS_GCS_ENABLE", 1);  // the ground station is lost: return
  add("FS_THR_ENABLE", 1);  // the remote control is lost: return
  add("FS_OPTIONS", 0);     // in missions, too
  if (what.fenced) {
    add("FENCE_ENABLE", 1);
    add("FENCE_TYPE", fence_types(autopilot.fence));
  }
  return text;
}

}  // namespace

std::string return_parameters(const Autopilot& autopilot, const ReturnParameters& what) {
  return autopilot.firmware == Firmware::px4 ? px4_parameters(autopilot)
                                             : ardupilot_parameters(autopilot, what);
}

double height_as_set(const Autopilot& autopilot, double height) {
  if (autopilot.firmware == Firmware::px4 || counts_in_metres(autopilot)) return height;
  return std::ceil(height * 100 - 1e-6) / 100;
}

}  // namespace traj
