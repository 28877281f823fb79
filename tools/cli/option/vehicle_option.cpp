#include "vehicle_option.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "cli/answer/exit.h"
#include "memory.h"

namespace cli {

void VehicleOptions::add_to(CLI::App& app) {
  app.add_option("--vehicle", word,
                 fmt::format("{}, FILE.json, box:HX,HY,HZ or sphere:R (metres)",
                             fmt::join(traj::vehicle_names(), ", ")))
      ->type_name(fmt::format("TEXT:{{{}}}|FILE", fmt::join(traj::vehicle_names(), ",")));
  app.add_option("--margin", margin, "metres added to each half size of the vehicle")
      ->check(CLI::Range(0.0, 1e6));
}

void VehicleOptions::add_spare_to(CLI::App& app) {
  app.add_option("--spare", spare,
                 "metres of the margin that was planned with and need not be kept here")
      ->check(CLI::Range(0.0, 1e6));
}

void VehicleOptions::add_memory_to(CLI::App& app) {
  app.add_option(
         "--memory", memory,
         "bytes that collision trees may take, as 512M (default: a quarter of the machine's "
         "memory or of a lower limit)")
      ->check([](const std::string& text) {
        if (parse_bytes(text)) return std::string();
        return fmt::format("expected bytes as 1000000, 64k, 512M or 2G, found \"{}\"", text);
      });
}

std::size_t VehicleOptions::budget() const {
  return memory.empty() ? fair_share() : parse_bytes(memory).value();
}

std::optional<traj::VehicleProfile> VehicleOptions::profile() const {
  if (word.empty()) return std::nullopt;
  return parse_vehicle(word);
}

geom::AskedRoom VehicleOptions::asked(const std::optional<traj::VehicleProfile>& profile) const {
  if (margin && !std::isfinite(*margin)) {
    throw UsageError(fmt::format("--margin: expected metres, found {}", *margin));
  }
  return {profile ? std::optional(profile->vehicle) : std::nullopt, margin, spare};
}

}  // namespace cli
