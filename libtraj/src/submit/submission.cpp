#include "traj/submit/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/instant.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"
#include "geom/zone/zone_report.h"

namespace traj {
namespace {

using geom::JsonFields;
using geom::JsonLine;

constexpr std::string_view kType = "submission";
constexpr std::string_view kClaimsType = "flight_claims";

JsonLine json_of(const RiskRules& rules) {
  JsonLine out;
  if (rules.geography != GeographyRule::margin) {
    out.add("geography", geom::word_of(kGeographyWords, rules.geography));
  }
  out.add("contingency", geom::word_of(kContingencyWords, rules.contingency))
      .add("buffer", geom::word_of(kBufferWords, rules.buffer))
      .add("dimension", rules.dimension);
  if (rules.contingency == ContingencyRule::stop) {
    out.add("position_error", rules.position_error)
        .add("holding_error", rules.holding_error)
        .add("map_error", rules.map_error)
        .add("altitude_error", rules.altitude_error)
        .add("reaction", rules.reaction)
        .add("tilt", rules.tilt);
  }
  out.add("formulas", formulas(rules), [](const RiskFormula& one) {
    return JsonLine().add("of", one.what).add("formula", one.formula).add("source", one.source);
  });
  return out;
}

JsonLine json_of(const Energy& energy) {
  return std::move(JsonLine()
                       .add("capacity", energy.capacity)
                       .add("power", energy.power)
                       .add("reserve", energy.reserve));
}

JsonLine json_of(const SourceFile& file) {
  JsonLine out;
  out.add("name", file.name).add("sha256", file.sha256);
  if (!file.date.empty()) out.add("date", file.date);
  return out;
}

JsonLine json_of(const TogetherRule& rule) {
  JsonLine out;
  const auto sides = [](const Zone& zone) {
    return zone.round ? std::vector{zone.reach.x(), zone.reach.z()}
                      : std::vector{zone.reach.x(), zone.reach.y(), zone.reach.z()};
  };
  if (const auto& zone = rule.spacing.zone) {
    out.add(zone->round ? "separation" : "separation_box", sides(*zone));
  }
  if (const auto& zone = rule.spacing.downwash) out.add("downwash", sides(*zone));
  return std::move(out.add("parked", geom::word_of(kParkedWords, rule.parked)));
}

JsonLine json_of(const FlightPairs& pairs) {
  JsonLine out;
  return std::move(
      out.add("compared", pairs.compared).add("too_near", pairs.refused).add("named", pairs.named));
}

JsonLine json_of(const geom::MapDoubts& doubts) {
  JsonLine out;
  if (doubts.skipped > 0) out.add("skipped", doubts.skipped);
  if (doubts.unknown_free) out.add("unknown_free", true);
  if (doubts.widened) out.add("widened", true);
  if (doubts.gap > 0) out.add("gap", doubts.gap);
  return out;
}

JsonLine json_of(const TerrainClaim& claim) {
  JsonLine out;
  add(out, claim);
  return out;
}

JsonLine json_of(const TubeClaim& claim) {
  JsonLine out;
  add(out, claim);
  return out;
}

JsonLine json_of(const SubmissionMethod& method) {
  JsonLine out;
  out.add("origin",
          std::vector{method.origin.latitude, method.origin.longitude, method.origin.height})
      .add("volumes", method.volumes)
      .add("around", method.buffer)
      .add("risk", json_of(method.risk))
      .add("floor", method.floor)
      .add("autopilot", method.autopilot)
      .add("params", method.params)
      .add("return_height", method.return_height);
  if (method.navigation) {
    out.add("navigation", std::vector{method.navigation->across, method.navigation->vertical});
  }
  out.add("drag", method.drag)
      .add("geoid", method.geoid)
      .add("geoid_grid", method.geoid_grid)
      .add("ground", method.ground);
  if (method.ground_model) {
    out.add("ground_model", json_of(*method.ground_model))
        .add("terrain_error", method.terrain_error);
    if (method.surface) add(out, *method.surface);
  }
  if (method.energy) out.add("energy", json_of(*method.energy));
  geom::add(out, method.limits);
  out.add("endurance", method.endurance).add("begins", method.begins).add("ends", method.ends);
  if (method.together) out.add("together", json_of(*method.together));
  if (method.tubes) out.add("tubes", json_of(*method.tubes));
  return out;
}

// --- read back --------------------------------------------------------------------------------

// A member that is an object, as the fields of a record of its own.
JsonFields member(const JsonFields& fields, const char* key, std::string_view source,
                  std::size_t line = 0) {
  const nlohmann::json& value = fields.value(key);
  if (!value.is_object()) {
    fields.refuse({.key = key, .expected = "an object", .found = geom::shown(value)});
  }
  return JsonFields(value.dump(), source, line);
}

double number(const JsonFields& fields, const char* key, double least, double most) {
  const auto value = fields.number(key);
  if (value && *value >= least && *value <= most) return *value;
  fields.refuse({.key = key,
                 .expected = fmt::format("a number from {} to {}", least, most),
                 .found = value ? fmt::to_string(*value) : "none"});
}

std::optional<double> number_or_nothing(const JsonFields& fields, const char* key, double least,
                                        double most) {
  return fields.has(key) ? std::optional(number(fields, key, least, most)) : std::nullopt;
}

std::size_t count(const JsonFields& fields, const char* key, double least, double most) {
  const double value = number(fields, key, least, most);
  if (value != static_cast<double>(static_cast<std::size_t>(value))) {
    fields.refuse({.key = key, .expected = "a whole number", .found = fmt::to_string(value)});
  }
  return static_cast<std::size_t>(value);
}

std::vector<double> numbers(const JsonFields& fields, const char* key, std::size_t count,
                            double least, double most) {
  const nlohmann::json& value = fields.value(key);
  std::vector<double> out;
  if (value.is_array()) {
    for (const nlohmann::json& one : value) out.push_back(fields.number(one, key));
  }
  const bool within =
      std::all_of(out.begin(), out.end(), [&](double one) { return one >= least && one <= most; });
  if (out.size() == count && within) return out;
  fields.refuse({.key = key,
                 .expected = fmt::format("{} numbers from {} to {}", count, least, most),
                 .found = geom::shown(value)});
}

std::optional<std::string> instant(const JsonFields& fields, const char* key) {
  if (!fields.has(key)) return std::nullopt;
  std::string text = fields.text(key);
  if (geom::epoch_from(text) != text) {
    fields.refuse({.key = key,
                   .expected = "an instant such as 2026-05-04T06:30:00Z",
                   .found = geom::in_quotes(text)});
  }
  return text;
}

RiskRules read_rules(const JsonFields& fields) {
  constexpr double kFar = 1e4;
  RiskRules out;
  out.geography = fields.word("geography", kGeographyWords, GeographyRule::margin);
  out.contingency = fields.word("contingency", kContingencyWords, ContingencyRule::stop);
  out.buffer = fields.word("buffer", kBufferWords, BufferRule::one_to_one);
  out.dimension = number(fields, "dimension", 0, kFar);
  if (out.contingency == ContingencyRule::ways_home) return out;
  out.position_error = number(fields, "position_error", 0, kFar);
  out.holding_error = number(fields, "holding_error", 0, kFar);
  out.map_error = number(fields, "map_error", 0, kFar);
  out.altitude_error = number(fields, "altitude_error", 0, kFar);
  out.reaction = number(fields, "reaction", 0, kFar);
  out.tilt = number(fields, "tilt", 1e-3, 1.55);
  return out;
}

Energy read_energy(const JsonFields& fields) {
  return {number(fields, "capacity", 1e-9, 1e15), number(fields, "power", 1e-9, 1e9),
          number(fields, "reserve", 0, 1 - 1e-9)};
}

std::optional<Zone> read_zone(const JsonFields& fields, const char* key, std::size_t sides) {
  if (!fields.has(key)) return std::nullopt;
  const std::vector<double> reach = numbers(fields, key, sides, 1e-9, 1e8);
  return sides == 2 ? cylinder(reach[0], reach[1]) : Zone{false, {reach[0], reach[1], reach[2]}};
}

TogetherRule read_together(const JsonFields& fields) {
  TogetherRule out{.exact = true};
  out.spacing.zone = read_zone(fields, "separation", 2);
  if (!out.spacing.zone) out.spacing.zone = read_zone(fields, "separation_box", 3);
  out.spacing.downwash = read_zone(fields, "downwash", 2);
  out.parked = fields.word("parked", kParkedWords, Parked::pad);
  return out;
}

FlightPairs read_pairs(const JsonFields& fields) {
  FlightPairs out{count(fields, "compared", 0, 1e18), count(fields, "too_near", 0, 1e18), {}};
  const nlohmann::json& named = fields.value("named");
  const auto is_pair = [](const nlohmann::json& one) {
    return one.is_array() && one.size() == 2 && one[0].is_string() && one[1].is_string();
  };
  if (!named.is_array() || !std::all_of(named.begin(), named.end(), is_pair)) {
    fields.refuse({.key = "named", .expected = "pairs of ids", .found = geom::shown(named)});
  }
  for (const nlohmann::json& one : named) {
    out.named.push_back({one[0].get<std::string>(), one[1].get<std::string>()});
  }
  return out;
}

geom::MapDoubts read_doubts(const JsonFields& fields) {
  const auto said = [&](const char* key) { return fields.has(key) && fields.value(key) == true; };
  geom::MapDoubts out;
  if (fields.has("skipped")) out.skipped = count(fields, "skipped", 1, 1e18);
  out.unknown_free = said("unknown_free");
  out.widened = said("widened");
  out.gap = fields.number("gap").value_or(0);
  return out;
}

SourceFile read_source_file(const nlohmann::json& value, std::string_view source) {
  const JsonFields fields(value.dump(), source, 0);
  return {fields.text("name"), fields.text("sha256"), fields.text("date", "")};
}

SubmissionMethod read_method(const JsonFields& fields, std::string_view source) {
  SubmissionMethod out;
  const std::vector<double> origin = numbers(fields, "origin", 3, -1e5, 1e5);
  out.origin = {origin[0], origin[1], origin[2]};
  out.limits = geom::read_limits(fields);
  out.volumes = count(fields, "volumes", 1, 64);
  out.buffer = number(fields, "around", 0, 1e4);
  out.risk = read_rules(member(fields, "risk", source));
  out.floor = number(fields, "floor", -1e5, 1e5);
  out.autopilot = fields.text("autopilot");
  if (fields.has("params")) out.params = fields.text("params");
  out.return_height = number_or_nothing(fields, "return_height", 0, 1e4);
  if (fields.has("navigation")) {
    const std::vector<double> value = numbers(fields, "navigation", 2, 0, 100);
    out.navigation = Uncertainty{value[0], value[1]};
  }
  out.drag = number_or_nothing(fields, "drag", 0, 100);
  out.geoid = number(fields, "geoid", -1e3, 1e3);
  if (fields.has("geoid_grid")) out.geoid_grid = fields.text("geoid_grid");
  out.ground = number_or_nothing(fields, "ground", -1e5, 1e5);
  if (fields.has("ground_model")) {
    out.ground_model = read_source_file(fields.value("ground_model"), source);
    out.terrain_error = number_or_nothing(fields, "terrain_error", 0, 1e3);
    if (fields.has(kSurfaceBandKey)) out.surface = read_surface_band(fields);
    if (!out.terrain_error && !out.surface) {
      fields.refuse({.key = "ground_model",
                     .expected = fmt::format("terrain_error or {} beside it", kSurfaceBandKey),
                     .found = "neither"});
    }
  }
  if (fields.has("energy")) out.energy = read_energy(member(fields, "energy", source));
  out.endurance = number_or_nothing(fields, "endurance", 1e-9, 1e9);
  out.begins = instant(fields, "begins");
  out.ends = instant(fields, "ends");
  if (fields.has("together")) out.together = read_together(member(fields, "together", source));
  if (fields.has("tubes")) out.tubes = read_source_file(fields.value("tubes"), source);
  return out;
}

std::vector<nlohmann::json> list(const JsonFields& fields, const char* key) {
  const nlohmann::json& value = fields.value(key);
  if (!value.is_array()) {
    fields.refuse({.key = key, .expected = "a list", .found = geom::shown(value)});
  }
  return {value.begin(), value.end()};
}

}  // namespace

std::string to_json_line(const Submission& submission) {
  JsonLine out;
  out.add("type", kType).add("made_by", submission.made_by);
  geom::add(out, submission.method.made_for);
  out.add("method", json_of(submission.method))
      .add("flights", submission.flights)
      .add("missions", submission.missions);
  if (submission.population) out.add("population", json_of(*submission.population));
  out.add("zones", submission.zones, [](const SourceFile& file) { return json_of(file); });
  if (submission.doubts.any()) out.add("doubts", json_of(submission.doubts));
  if (submission.pairs) out.add("pairs", json_of(*submission.pairs));
  return out.line();
}

std::vector<SourceFile> zones_of(const geom::BoxMapSpec& spec) {
  std::vector<SourceFile> out;
  for (const geom::ZoneSource& zone : geom::zone_sources(spec)) {
    const std::string_view hash = zone.hash;
    const std::string_view prefix = "sha256:";
    out.push_back({zone.file,
                   std::string(hash.substr(hash.starts_with(prefix) ? prefix.size() : 0)),
                   zone.issued});
  }
  return out;
}

Submission read_submission(std::string_view json, std::string_view source) {
  const JsonFields fields(json, source, 0);
  fields.require_type(kType);
  Submission out;
  out.made_by = fields.text("made_by");
  out.method = read_method(member(fields, "method", source), source);
  out.method.made_for = geom::read_provenance(fields);
  out.flights = count(fields, "flights", 1, 1e9);
  for (const nlohmann::json& mission : list(fields, "missions")) {
    if (!mission.is_string()) fields.refuse({.key = "missions", .expected = "names of files"});
    out.missions.push_back(mission.get<std::string>());
  }
  if (fields.has("population")) {
    out.population = read_source_file(fields.value("population"), source);
  }
  for (const nlohmann::json& zone : list(fields, "zones")) {
    out.zones.push_back(read_source_file(zone, source));
  }
  if (fields.has("doubts")) out.doubts = read_doubts(member(fields, "doubts", source));
  if (fields.has("pairs")) out.pairs = read_pairs(member(fields, "pairs", source));
  return out;
}

std::string to_json_line(const FlightClaims& claims) {
  JsonLine out;
  out.add("type", kClaimsType)
      .add("id", claims.id)
      .add("kind", claims.kind)
      .add("volumes", claims.volumes)
      .add("risk", claims.risk)
      .add("vehicle", claims.vehicle)
      .add("half", claims.half)
      .add("margin", claims.margin)
      .add("begins", claims.begins)
      .add("ends", claims.ends)
      .add("duration", claims.duration)
      .add("clearance", claims.clearance);
  if (claims.tube) out.add("tube", json_of(*claims.tube));
  if (claims.terrain) out.add("terrain", json_of(*claims.terrain));
  out.add("speed", claims.speed)
      .add("top", claims.top)
      .add("contingency_across", claims.contingency.across)
      .add("contingency_vertical", claims.contingency.vertical)
      .add("buffer", claims.buffer)
      .add("returns", claims.returns)
      .add("energy", claims.energy)
      .add("people", claims.people);
  if (claims.people) out.add("people_unknown", claims.people_unknown);
  return out.line();
}

FlightClaims parse_flight_claims(std::string_view json, std::string_view source, std::size_t line) {
  constexpr double kMost = 1e15;
  const JsonFields fields(json, source, line);
  fields.require_type(kClaimsType);
  FlightClaims out;
  out.id = fields.text("id");
  out.kind = fields.text("kind");
  out.volumes = fields.text("volumes");
  out.risk = fields.text("risk");
  out.vehicle = fields.text("vehicle");
  out.half = fields.point("half");
  out.margin = number(fields, "margin", 0, kMost);
  out.begins = fields.text("begins");
  out.ends = fields.text("ends");
  out.duration = number(fields, "duration", 0, kMost);
  out.clearance = number_or_nothing(fields, "clearance", -kMost, kMost);
  if (fields.has("tube")) out.tube = read_tube_claim(member(fields, "tube", source, line));
  if (fields.has("terrain")) {
    out.terrain = read_terrain_claim(member(fields, "terrain", source, line));
  }
  out.speed = number(fields, "speed", 0, kMost);
  out.top = number(fields, "top", -kMost, kMost);
  out.contingency = {number(fields, "contingency_across", 0, kMost),
                     number(fields, "contingency_vertical", 0, kMost)};
  out.buffer = number(fields, "buffer", 0, kMost);
  out.returns = number_or_nothing(fields, "returns", 0, 1);
  out.energy = number_or_nothing(fields, "energy", 0, kMost);
  out.people = number_or_nothing(fields, "people", 0, kMost);
  if (out.people) out.people_unknown = count(fields, "people_unknown", 0, kMost);
  return out;
}

}  // namespace traj
