#include "dji_options.h"

#include <array>
#include <string>
#include <utility>

namespace exporting {
namespace {

// DJI's enumeration of aircraft, in its cloud API documentation of WPML (common element).
constexpr std::array<std::pair<const char*, traj::DjiAircraft>, 7> kAircraft = {
    {{"m30", {67, 0}},
     {"m30t", {67, 1}},
     {"m3e", {77, 0}},
     {"m3t", {77, 1}},
     {"m3m", {77, 2}},
     {"m3d", {91, 0}},
     {"m3td", {91, 1}}}};

}  // namespace

void add_dji_options(CLI::App& app, traj::DjiOptions& options, std::optional<double>& turns) {
  app.add_option("--wpml-version", options.version,
                 "DJI: version of the format, 1.0.2 or 1.0.6 (default 1.0.6)")
      ->check(CLI::IsMember({"1.0.2", "1.0.6"}));
  app.add_option_function<std::string>(
         "--aircraft",
         [&options](const std::string& name) {
           for (const auto& [known, aircraft] : kAircraft) {
             if (name == known) options.aircraft = aircraft;
           }
         },
         "DJI: the aircraft that the mission is for: m30, m30t, m3e, m3t, m3m, m3d or m3td "
         "(default m3e)")
      ->check(CLI::IsMember({"m30", "m30t", "m3e", "m3t", "m3m", "m3d", "m3td"}));
  app.add_option("--turns", turns,
                 "DJI: turn without a stop, from at most so many metres before each waypoint to as "
                 "many behind it, where there is room (default: stop at each)")
      ->check(CLI::Range(0.2, 1000.0));
}

}  // namespace exporting
