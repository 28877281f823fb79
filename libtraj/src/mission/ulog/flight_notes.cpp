#include "traj/mission/ulog/flight_notes.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/counted.h"

namespace traj {
namespace {

using geom::counted;

constexpr double kSeaLevelOff = 1;  // m from which on it is said

void add_cut(const Px4Flight& flight, std::vector<std::string>& out) {
  const UlogSummary& log = flight.summary;
  if (log.cut_at) {
    out.push_back(fmt::format(
        "the log breaks off at byte {} ({}): what stands before is kept, and its last row says cut",
        *log.cut_at, log.cut_why));
  }
  if (log.torn > 0) {
    out.push_back(fmt::format("{} off where data was appended",
                              counted(log.torn, "message breaks", "messages break")));
  }
}

void add_left_out(const Px4Flight& flight, std::vector<std::string>& out) {
  const auto add = [&](std::size_t count, const char* why) {
    if (count == 0) return;
    out.push_back(fmt::format("{} of {} positions left out: {}", count, flight.positions, why));
  };
  add(flight.not_known, "the vehicle did not know where it was");
  add(flight.nowhere, "the vehicle did not know where on Earth that is, or it is far from the map");
  add(flight.back, "their time does not grow");
  if (flight.left_out_at_end > 0 && !flight.log.samples.empty()) {
    out.push_back(fmt::format(
        "{} of these after the last row: where the flight went then is not known, and the last row "
        "says cut",
        flight.left_out_at_end));
  }
  if (flight.begins_in_air) {
    out.push_back(
        "the vehicle flew, or may have flown, before the first row: where it was then is not "
        "known, and the last row says cut");
  }
  if (flight.ends_in_air && !flight.summary.cut_at) {
    out.push_back(
        "the vehicle still flies when the log ends: where the flight went then is not known, and "
        "the last row says cut");
  }
  if (!flight.tells_landed && !flight.log.cut) {
    out.push_back(
        "the log does not say when the vehicle stands on the ground (no vehicle_land_detected): it "
        "may have flown before the first row and after the last");
  }
  if (flight.ends_silent) {
    out.push_back(
        "the log goes on for more than 1 s after the last row, without positions: where the flight "
        "went then is not known, and the last row says cut");
  }
}

void add_losses(const Px4Flight& flight, std::vector<std::string>& out) {
  const UlogSummary& log = flight.summary;
  if (log.dropouts > 0) {
    out.push_back(
        fmt::format("{} of {:.3g} s in all, the longest of {:.3g} s: what was logged then is lost",
                    counted(log.dropouts, "dropout"), log.dropout_seconds, log.longest_dropout));
  }
  if (flight.resets > 0) {
    out.push_back(fmt::format(
        "the vehicle corrected its position {}, by up to {:.3g} m: those steps were not flown",
        flight.resets == 1 ? std::string("once") : fmt::format("{} times", flight.resets),
        flight.largest_reset));
  }
  if (flight.corrected_in_air) {
    out.push_back(fmt::format(
        "by {:.3g} m of these in the air: where the vehicle was before is not known, and the last "
        "row says cut",
        flight.largest_reset_in_air));
  }
}

}  // namespace

void require_positions(const Px4Flight& flight, const std::string& source, bool placed) {
  if (!flight.log.samples.empty()) return;
  if (flight.positions == 0) {
    throw geom::InputError(source, {.expected = "vehicle_local_position or vehicle_global_position",
                                    .found = "neither"});
  }
  if (placed && flight.nowhere > 0) {
    throw geom::InputError(
        source, {.expected = "a place on Earth near the map",
                 .found = fmt::format("none in {} of {}", counted(flight.nowhere, "position"),
                                      flight.topic),
                 .advice = "the vehicle did not know where on Earth it was, or was elsewhere; "
                           "without --map and --origin its local coordinates are kept"});
  }
  throw geom::InputError(
      source,
      {.expected = "a position that the vehicle held for valid",
       .found = fmt::format("none in {} of {}", counted(flight.positions, "row"), flight.topic)});
}

std::vector<std::string> warnings(const Px4Flight& flight, std::optional<double> geoid) {
  std::vector<std::string> out;
  add_cut(flight, out);
  add_left_out(flight, out);
  add_losses(flight, out);
  if (geoid && flight.sea_level && std::abs(*flight.sea_level - *geoid) > kSeaLevelOff) {
    out.push_back(fmt::format(
        "the log has the sea level {:.1f} m above the ellipsoid there, and --geoid is {}",
        *flight.sea_level, *geoid));
  }
  return out;
}

std::string told(const Px4Flight& flight, std::string_view origin, std::string_view begin) {
  std::string from = "where the vehicle's local coordinates do";
  if (!origin.empty()) {
    from = origin;
  } else if (flight.reference) {
    from = fmt::format(
        "the log's reference, latitude {:.7f}, longitude {:.7f}, {:.2f} m above the sea",
        flight.reference->latitude, flight.reference->longitude, flight.reference->height);
  }
  const std::string takeoff =
      flight.takeoff.value_or(0) > 0 ? fmt::format("; take-off at {:.2f} s", *flight.takeoff) : "";
  return fmt::format("{} of {}; metres count from {}, seconds from {}{}",
                     counted(flight.log.samples.size(), "row"), flight.topic, from, begin, takeoff);
}

nlohmann::ordered_json stats(const Px4Flight& flight) {
  const UlogSummary& log = flight.summary;
  nlohmann::ordered_json out = {{"topic", flight.topic},
                                {"rows", flight.log.samples.size()},
                                {"positions", flight.positions},
                                {"not_known", flight.not_known},
                                {"nowhere", flight.nowhere},
                                {"back", flight.back},
                                {"left_out_at_begin", flight.left_out_at_begin},
                                {"begins_in_air", flight.begins_in_air},
                                {"left_out_at_end", flight.left_out_at_end},
                                {"ends_silent", flight.ends_silent},
                                {"ends_in_air", flight.ends_in_air},
                                {"tells_landed", flight.tells_landed},
                                {"resets", flight.resets},
                                {"largest_reset", flight.largest_reset},
                                {"largest_reset_in_air", flight.largest_reset_in_air},
                                {"version", log.version},
                                {"messages", log.messages},
                                {"unknown_messages", log.unknown},
                                {"torn_messages", log.torn},
                                {"dropouts", log.dropouts},
                                {"dropout_s", log.dropout_seconds}};
  const auto add = [&](const char* key, const auto& value) {
    if (value) out[key] = *value;
  };
  add("cut_at", log.cut_at);
  add("takeoff_s", flight.takeoff);
  add("sea_level_m", flight.sea_level);
  add("deviation_m", flight.deviation);
  add("vertical_deviation_m", flight.vertical_deviation);
  return out;
}

}  // namespace traj
