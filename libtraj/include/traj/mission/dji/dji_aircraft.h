#pragma once

// DJI's aircraft: their names, numbers and airframes.
//
// Example:
//   assert(traj::vehicle_of({.type = 77, .kind = 1}) == "m3t");
//   assert(traj::airframe_of({.type = 77})->climb == 6);

#include <string_view>

namespace traj {

// droneEnumValue and droneSubEnumValue.
struct DjiAircraft {
  int type = 77;  // Mavic 3 Enterprise
  int kind = 0;

  bool operator==(const DjiAircraft&) const = default;
};

// The aircraft that have a name: DJI's enumeration, in its cloud API documentation of WPML (common
// element).
struct NamedDjiAircraft {
  std::string_view name;
  DjiAircraft aircraft;
  int camera = 0;  // payloadEnumValue of its own
};
inline constexpr NamedDjiAircraft kDjiAircraft[] = {
    {"m30", {67, 0}, 52}, {"m30t", {67, 1}, 53}, {"m3e", {77, 0}, 66}, {"m3t", {77, 1}, 67},
    {"m3m", {77, 2}, 68}, {"m3d", {91, 0}, 80},  {"m3td", {91, 1}, 81}};

// What is known of all aircraft of a type (droneEnumValue): the profile of data/vehicles that holds
// them, and the most that they climb and sink, m/s, as DJI publishes it (of type 91 an assumption).
struct DjiAirframe {
  int type = 0;
  std::string_view vehicle;
  double climb = 0;
  double descent = 0;
};
inline constexpr DjiAirframe kDjiAirframes[] = {{67, "m30", 6, 5},
                                                {77, "m3e", 6, 6},
                                                {89, "m350", 6, 5},
                                                {91, "m3d", 8, 8},
                                                {99, "m4e", 10, 8}};
// Null for a type that is not known.
const DjiAirframe* airframe_of(const DjiAircraft& aircraft);
// The word of --vehicle for an aircraft: its name if it has one, else that of its airframe's
// profile. Empty for a type that is not known.
std::string_view vehicle_of(const DjiAircraft& aircraft);

// What gimbals of the aircraft that have a name can do, as far as all of them can: degrees.
inline constexpr double kDjiGimbalDown = -90;
inline constexpr double kDjiGimbalUp = 30;

}  // namespace traj
