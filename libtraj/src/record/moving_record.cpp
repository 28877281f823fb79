#include "traj/record/moving_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <tuple>

#include "geom/record/flight_time.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

void require_known(const geom::JsonFields& fields) {
  static constexpr std::array<std::string_view, 10> kKnown = {
      "type", "id", "epoch", "frame", "map", "from", "until", "min", "max", "velocity"};
  for (const auto& [key, value] : fields.object().items()) {
    if (key == "growth" || std::find(kKnown.begin(), kKnown.end(), key) != kKnown.end()) continue;
    fields.refuse({.expected = fmt::format("{}, growth", fmt::join(kKnown, ", ")),
                   .found = fmt::format("\"{}\", which is not known here", key.substr(0, 60))});
  }
}

double seconds(const geom::JsonFields& fields, const char* key) {
  const auto number = fields.number(key);
  if (number) return *number;
  fields.refuse({.expected = fmt::format("\"{}\", seconds after the epoch", key),
                 .found = "none",
                 .advice = "an obstacle that moves is there for a time that is said"});
}

geom::Vec3 vector(const geom::JsonFields& fields, const char* key, const char* what) {
  if (fields.has(key)) return fields.point(key);
  fields.refuse({.expected = fmt::format("\"{}\", {}", key, what), .found = "none"});
}

geom::JsonLine object_of(const MovingCover& cover) {
  const auto word = [](const FaceSide& side) {
    return std::string{side.above ? '+' : '-', "xyz"[side.axis]};
  };
  geom::JsonLine line;
  line.add("pieces", cover.pieces).add("sides", cover.sides, word);
  return line;
}

}  // namespace

MovingRecord parse_moving_record(std::string_view json, std::string_view source, std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  fields.require_type("moving");
  require_known(fields);
  MovingRecord out;
  out.id = fields.text("id");
  if (fields.has("epoch")) {
    out.epoch = geom::epoch_from(fields.text("epoch"));
    if (!out.epoch) {
      fields.refuse({.key = "epoch",
                     .expected = "an instant in UTC such as \"2026-05-04T06:30:00Z\" (RFC 3339)",
                     .found = geom::shown(fields.value("epoch"))});
    }
  }
  if (fields.has("frame")) {
    out.frame = geom::axes_from_name(fields.text("frame"));
    if (!out.frame) {
      fields.refuse(
          {.key = "frame", .expected = "enu or neu", .found = geom::shown(fields.value("frame"))});
    }
  }
  if (fields.has("map")) out.map = fields.text("map");
  out.box.from = seconds(fields, "from");
  out.box.until = seconds(fields, "until");
  out.box.box.min = vector(fields, "min", "the lower corner at \"from\", metres");
  out.box.box.max = vector(fields, "max", "the upper corner at \"from\", metres");
  out.box.velocity = vector(fields, "velocity", "m/s along each axis");
  out.box.growth =
      vector(fields, "growth", "m/s of each half size, [0,0,0] where it does not grow");
  if (const auto fault = moving_box_fault(out.box)) fields.refuse(*fault);
  return out;
}

std::string to_json_line(const MovingConflict& conflict, const std::optional<std::string>& epoch) {
  geom::JsonLine line;
  line.add("type", "moving_conflict").add("id", conflict.flight);
  line.add("obstacle", conflict.obstacle).add("ok", false);
  line.add("reason", reason_of(conflict));
  line.add("time", conflict.result.time).add("place", conflict.result.place);
  return line.add("epoch", epoch).line();
}

std::string to_json_line(const MovingSummary& summary) {
  geom::JsonLine line;
  line.add("type", "clear_of_moving").add("ok", summary.ok()).add("flights", summary.flights);
  if (summary.left_out > 0) line.add("left_out", summary.left_out);
  line.add("obstacles", summary.obstacles).add("pieces", summary.pieces);
  line.add("refused", summary.refused).add("parked", name(summary.parked));
  return line.add("epoch", summary.epoch).line();
}

std::string certificate_line(const ProvedMoving& proved) {
  geom::JsonLine line;
  line.add("type", "clear_of").add("ids", std::tuple(proved.flight, proved.obstacle));
  return line.add("stretches", proved.proof.stretches, object_of).line();
}

std::string certificate_line(const MovingClaim& claim) {
  geom::JsonLine line;
  line.add("type", "clear_of_moving").add("flights", claim.flights);
  line.add("obstacles", claim.obstacles).add("rooms", claim.rooms);
  line.add("parked", name(claim.parked)).add("map", claim.map);
  return line.add("epoch", claim.epoch).line();
}

std::string_view reason_of(const MovingConflict& conflict) {
  if (conflict.result.clear) return "exact";  // never, unless one of the two checks is wrong
  return conflict.result.undecided ? "undecided" : "moving";
}

std::string in_words(const MovingConflict& conflict) {
  const MovingResult& result = conflict.result;
  const bool touches = !result.undecided && !result.clear;
  return fmt::format("{} {} {} at {:.6g} s, near ({:.2f}, {:.2f}, {:.2f})", conflict.flight,
                     touches ? "touches" : "could not be shown to keep clear of", conflict.obstacle,
                     result.time, result.place.x(), result.place.y(), result.place.z());
}

}  // namespace traj
