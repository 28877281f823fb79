#include "traj/record/tube_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"
#include "geom/text/rounded.h"
#include "traj/flight/monte_carlo.h"
#include "traj/record/disturbance_record.h"

namespace traj {
namespace {

using geom::JsonFields;
using Json = nlohmann::json;

// Members of a proved tube beside its disturbances.
constexpr std::string_view kMembers[] = {
    "ok",      "says", "damping", "cells", "trajectory", "reason", "motor",  "room", "period",
    "largest", "tilt", "clear",   "time",  "place",      "box",    "radius", "wind", "model"};

constexpr std::size_t kShownDigits = 8;  // of a hash, in words

constexpr std::string_view kClaimMembers[] = {"kind",       "largest", "tilt",
                                              "controller", "wind",    "model"};

// One that nobody knows may be an assumption, which would not be told on.
void require_known(const JsonFields& tube, std::span<const std::string_view> members) {
  for (const auto& [key, value] : tube.object().items()) {
    const auto is_key = [&, &name = key](const DisturbanceRange& range) {
      return range.key == name;
    };
    if (std::find(members.begin(), members.end(), key) != members.end() ||
        std::any_of(kDisturbanceRanges.begin(), kDisturbanceRanges.end(), is_key)) {
      continue;
    }
    tube.refuse({.key = "a tube",
                 .expected = "of members that this version knows",
                 .found = geom::in_quotes(key),
                 .advice = "read it with the version of Skyway that wrote it"});
  }
}

double length(const JsonFields& tube, const char* key, double most) {
  const auto value = tube.number(key);
  if (value && *value >= 0 && *value <= most) return *value;
  tube.refuse({.key = key,
               .expected = fmt::format("from 0 to {:g}", most),
               .found = value ? fmt::to_string(*value) : "none"});
}

void read_radii(const JsonFields& tube, TubeRecord& out) {
  const Json* list = tube.has("radius") ? &tube.value("radius") : nullptr;
  if (!list || !list->is_array() || list->empty()) {
    tube.refuse({.key = "radius",
                 .expected = "a list of metres",
                 .found = list ? geom::shown(*list) : "none"});
  }
  for (const Json& one : *list) {
    const double radius = tube.number(one, "radius");
    if (radius < 0 || radius > geom::kLargestCoordinate) {
      tube.refuse({.key = "radius", .expected = "metres >= 0", .found = one.dump()});
    }
    out.radius.push_back(radius);
  }
  out.claim.largest = *std::max_element(out.radius.begin(), out.radius.end());
}

// What both kinds have. Without the hash, the tube might be of any trajectory.
void read_shape(const JsonFields& tube, TubeRecord& out) {
  read_radii(tube, out);
  out.period = length(tube, "period", 1e6);
  if (out.period == 0) tube.refuse({.key = "period", .expected = "seconds > 0", .found = "0"});
  const auto largest = tube.number("largest");
  if (!largest || *largest != out.claim.largest) {
    tube.refuse({.key = "largest",
                 .expected = fmt::format("{}, the largest radius", out.claim.largest),
                 .found = largest ? fmt::to_string(*largest) : "none"});
  }
  out.claim.tilt = length(tube, "tilt", std::numbers::pi);
  out.trajectory = tube.text("trajectory", "");
  if (out.trajectory.empty()) {
    tube.refuse({.key = "trajectory", .expected = "the hash of its trajectory", .found = "none"});
  }
}

TubeRecord read_proved(const JsonFields& tube) {
  require_known(tube, kMembers);
  TubeRecord out;
  out.claim.kind = TubeKind::proved;
  out.claim.disturbances = read_disturbances(tube);
  const Json& ok = tube.value("ok");
  if (!ok.is_boolean()) tube.refuse({.key = "ok", .expected = "true or false", .found = ok.dump()});
  if (!ok.get<bool>()) {
    out.refused = tube.text("reason");
    return out;
  }
  read_shape(tube, out);
  if (out.period != kTubePeriod) {
    tube.refuse({.key = "period",
                 .expected = fmt::to_string(kTubePeriod),
                 .found = fmt::to_string(out.period)});
  }
  return out;
}

TubeRecord read_statistics(const JsonFields& tube) {
  TubeRecord out;
  read_shape(tube, out);
  return out;
}

ControlLaw read_law(const JsonFields& fields) {
  if (!fields.has("controller")) {
    fields.refuse({.key = "controller", .expected = "a word", .found = "none"});
  }
  return fields.word("controller", kControlLawWords, ControlLaw::cascade);
}

// Of the runs of a flight; a flight of which some were lost has none.
const Json* tube_of_runs(const JsonFields& flight) {
  if (!flight.has("monte_carlo")) return nullptr;
  const Json& runs = flight.value("monte_carlo");
  if (!runs.is_object() || !runs.contains("tube")) return nullptr;
  if (runs.contains("lost") && runs["lost"] != 0) {
    flight.refuse({.key = "lost",
                   .expected = "0, as runs of which some were lost have no tube",
                   .found = geom::shown(runs["lost"])});
  }
  return &runs["tube"];
}

}  // namespace

std::optional<TubeRecord> parse_tube(std::string_view json, std::string_view source,
                                     std::size_t line) {
  const JsonFields flight(json, source, line);
  flight.require_type("flight");
  const bool proved = flight.has("proved_tube");
  const Json* tube = proved ? &flight.value("proved_tube") : tube_of_runs(flight);
  if (!tube) return std::nullopt;
  if (!tube->is_object()) {
    flight.refuse({.expected = "a tube with a period and radius", .found = geom::shown(*tube)});
  }
  const JsonFields fields(tube->dump(), source, line);
  TubeRecord out = proved ? read_proved(fields) : read_statistics(fields);
  out.id = flight.text("id");
  out.claim.law = read_law(flight);
  out.claim.model = fields.text("model", "");
  out.provenance = geom::read_provenance(flight);
  return out;
}

void add(geom::JsonLine& line, const TubeClaim& claim) {
  line.add("kind", geom::word_of(kTubeKindWords, claim.kind));
  line.add("largest", claim.largest).add("tilt", claim.tilt);
  line.add("controller", geom::word_of(kControlLawWords, claim.law));
  if (!claim.model.empty()) line.add("model", claim.model);
  if (claim.disturbances) add(line, *claim.disturbances);
}

TubeClaim read_tube_claim(const geom::JsonFields& fields) {
  require_known(fields, kClaimMembers);
  if (!fields.has("kind")) fields.refuse({.key = "kind", .expected = "a word", .found = "none"});
  TubeClaim out;
  out.kind = fields.word("kind", kTubeKindWords, TubeKind::statistics);
  out.largest = length(fields, "largest", geom::kLargestCoordinate);
  out.tilt = length(fields, "tilt", std::numbers::pi);
  out.law = read_law(fields);
  out.model = fields.text("model", "");
  if (out.kind == TubeKind::proved) out.disturbances = read_disturbances(fields);
  return out;
}

std::string in_words(const TubeClaim& claim) {
  const std::string tube =
      fmt::format("a tube of at most {:.4g} m", geom::rounded_up(claim.largest));
  if (claim.kind == TubeKind::statistics) return tube + ", from statistics and not proved";
  return fmt::format("{}, proved for the simulated vehicle ({}) under the {} controller in {}",
                     tube,
                     claim.model.empty() ? "of gains that the report does not name"
                                         : "model " + claim.model.substr(0, kShownDigits),
                     geom::word_of(kControlLawWords, claim.law), in_words(*claim.disturbances));
}

}  // namespace traj
