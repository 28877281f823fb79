#include "geom/record/volume4d.h"

#include <fmt/format.h>

#include <initializer_list>
#include <istream>
#include <nlohmann/json.hpp>
#include <utility>

#include "geom/base/error.h"
#include "geom/text/instant.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;
using Names = std::initializer_list<const char*>;

constexpr double kLowest = -8000;  // metres: the standard's bounds of an altitude
constexpr double kHighest = 100000;

// A value and where it stands: "volumes[3].volume.outline_circle".
class Member {
 public:
  Member(const Json& value, std::string_view source, std::string where)
      : value_(value), source_(source), where_(std::move(where)) {}

  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, where_.empty() ? std::move(fault) : within(where_, std::move(fault)));
  }

  const Json& value() const { return value_; }
  bool has(const char* key) const { return value_.contains(key) && !value_[key].is_null(); }
  bool has_any(Names keys) const {
    for (const char* key : keys) {
      if (has(key)) return true;
    }
    return false;
  }

  Member at(const char* key) const {
    if (!has(key)) refuse({.expected = in_quotes(key), .found = "none"});
    return {value_[key], source_, where_.empty() ? key : where_ + '.' + key};
  }

  std::vector<Member> items() const {
    if (!value_.is_array()) refuse({.expected = "a list", .found = shown(value_)});
    std::vector<Member> out;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      out.emplace_back(value_[i], source_, fmt::format("{}[{}]", where_, i));
    }
    return out;
  }

  // An object with no other members.
  void require_known(Names known) const {
    if (!value_.is_object()) refuse({.expected = "an object", .found = shown(value_)});
    for (const auto& [key, value] : value_.items()) {
      bool found = false;
      for (const char* name : known) found = found || key == name;
      if (!found) {
        refuse({.expected = fmt::to_string(fmt::join(known, ", ")),
                .found = fmt::format("\"{}\", which is not known here", key.substr(0, 60))});
      }
    }
  }

  double number(double least, double most, const char* what) const {
    const double number = value_.is_number() ? value_.get<double>() : std::nan("");
    if (!(number >= least && number <= most)) {
      refuse({.expected = std::string(what), .found = shown(value_)});
    }
    return number;
  }

  void require_word(const char* key, const char* word, const char* what) const {
    const Member said = at(key);
    if (said.value_ != word) {
      said.refuse(
          {.expected = fmt::format("\"{}\" ({})", word, what), .found = shown(said.value_)});
    }
  }

 private:
  const Json& value_;
  std::string source_;
  std::string where_;
};

GeodeticPlace place_of(const Member& point) {
  point.require_known({"lat", "lng"});
  return {point.at("lat").number(-90, 90, "degrees north, within 90"),
          point.at("lng").number(-180, 180, "degrees east, within 180"), 0};
}

GeodeticOutline circle_of(const Member& circle) {
  circle.require_known({"center", "radius"});
  GeodeticOutline out;
  out.centre = place_of(circle.at("center"));
  const Member radius = circle.at("radius");
  radius.require_known({"value", "units"});
  radius.require_word("units", "M", "metres");
  out.radius = radius.at("value").number(1e-3, 1e5, "metres from 0.001 to 1e5");
  return out;
}

GeodeticOutline polygon_of(const Member& polygon) {
  polygon.require_known({"vertices"});
  const std::vector<Member> vertices = polygon.at("vertices").items();
  if (vertices.size() < 3) {
    polygon.refuse({.expected = "at least 3 vertices", .found = fmt::to_string(vertices.size())});
  }
  GeodeticOutline out;
  for (const Member& vertex : vertices) {
    const GeodeticPlace place = place_of(vertex);
    if (!out.ring.empty() && place == out.ring.back()) {
      vertex.refuse({.expected = "another vertex", .found = "the one before it again"});
    }
    out.ring.push_back(place);
  }
  if (out.ring.front() == out.ring.back()) {
    vertices.back().refuse({.expected = "another vertex than the first",
                            .found = "it again",
                            .advice = "the last is joined to the first without that"});
  }
  return out;
}

std::optional<double> altitude_of(const Member& volume, const char* key) {
  if (!volume.has(key)) return std::nullopt;
  const Member altitude = volume.at(key);
  altitude.require_known({"value", "reference", "units"});
  altitude.require_word("reference", "W84", "above the ellipsoid of WGS 84");
  altitude.require_word("units", "M", "metres");
  return altitude.at("value").number(kLowest, kHighest, "metres from -8000 to 100000");
}

std::optional<std::string> time_of(const Member& volume, const char* key) {
  if (!volume.has(key)) return std::nullopt;
  const Member time = volume.at(key);
  time.require_known({"value", "format"});
  time.require_word("format", "RFC3339", "a date and time in UTC");
  const Member value = time.at("value");
  const auto instant =
      value.value().is_string() ? epoch_from(value.value().get<std::string>()) : std::nullopt;
  if (!instant) {
    value.refuse({.expected = "an instant in UTC such as \"2026-05-04T06:30:00Z\" (RFC 3339)",
                  .found = shown(value.value())});
  }
  return instant;
}

Volume4d volume_of(const Member& whole) {
  whole.require_known({"volume", "time_start", "time_end"});
  const Member volume = whole.at("volume");
  volume.require_known({"outline_polygon", "outline_circle", "altitude_lower", "altitude_upper"});
  const bool polygon = volume.has("outline_polygon");
  if (polygon == volume.has("outline_circle")) {
    volume.refuse(
        {.expected = "outline_polygon or outline_circle", .found = polygon ? "both" : "neither"});
  }
  Volume4d out;
  out.outline =
      polygon ? polygon_of(volume.at("outline_polygon")) : circle_of(volume.at("outline_circle"));
  out.lower = altitude_of(volume, "altitude_lower");
  out.upper = altitude_of(volume, "altitude_upper");
  if (out.lower && out.upper && !(*out.lower < *out.upper)) {
    volume.refuse({.expected = "altitude_lower below altitude_upper",
                   .found = fmt::format("{} and {}", *out.lower, *out.upper)});
  }
  out.start = time_of(whole, "time_start");
  out.end = time_of(whole, "time_end");
  if (out.start && out.end && !(seconds_between(*out.start, *out.end).least > 0)) {
    whole.refuse({.expected = "time_start before time_end",
                  .found = fmt::format("{} and {}", *out.start, *out.end)});
  }
  return out;
}

void add_each(const Member& list, std::vector<Volume4d>& out) {
  for (const Member& volume : list.items()) out.push_back(volume_of(volume));
}

// Of an operational intent or a constraint.
void add_details(const Member& details, IntentVolumes& out) {
  details.require_known({"volumes", "off_nominal_volumes", "priority", "type", "geozone"});
  if (details.has("volumes")) add_each(details.at("volumes"), out.nominal);
  if (details.has("off_nominal_volumes")) {
    add_each(details.at("off_nominal_volumes"), out.off_nominal);
  }
}

void add_entity(const Member& entity, IntentVolumes& out) {
  entity.require_known({"reference", "details"});
  add_details(entity.at("details"), out);
}

void add_all(const Member& root, IntentVolumes& out) {
  if (root.value().is_array()) return add_each(root, out.nominal);
  if (!root.value().is_object()) {
    root.refuse(
        {.expected = "a Volume4D of ASTM F3548, or a list of them", .found = shown(root.value())});
  }
  for (const char* key : {"operational_intent", "constraint"}) {
    if (!root.has(key)) continue;
    root.require_known({key});
    return add_entity(root.at(key), out);
  }
  if (root.has("details")) return add_entity(root, out);
  if (root.has_any({"volumes", "off_nominal_volumes"})) return add_details(root, out);
  out.nominal.push_back(volume_of(root));
}

JsonLine point_line(const GeodeticPlace& place) {
  return JsonLine().add("lat", place.latitude).add("lng", place.longitude);
}

JsonLine line_of(const Volume4d& volume) {
  JsonLine space;
  if (volume.outline.ring.empty()) {
    space.add("outline_circle",
              JsonLine()
                  .add("center", point_line(volume.outline.centre))
                  .add("radius", JsonLine().add("value", volume.outline.radius).add("units", "M")));
  } else {
    JsonLine polygon;
    polygon.add("vertices", volume.outline.ring, point_line);
    space.add("outline_polygon", polygon);
  }
  const auto altitude = [&](const char* key, const std::optional<double>& value) {
    if (!value) return;
    space.add(key, JsonLine().add("value", *value).add("reference", "W84").add("units", "M"));
  };
  altitude("altitude_lower", volume.lower);
  altitude("altitude_upper", volume.upper);
  JsonLine out;
  out.add("volume", space);
  const auto time = [&](const char* key, const std::optional<std::string>& value) {
    if (value) out.add(key, JsonLine().add("value", *value).add("format", "RFC3339"));
  };
  time("time_start", volume.start);
  time("time_end", volume.end);
  return out;
}

// A volume a line.
std::string lines_of(std::span<const Volume4d> volumes) {
  std::string text;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    text += (i ? ",\n" : "\n") + line_of(volumes[i]).object();
  }
  return text;
}

}  // namespace

IntentVolumes read_intent_volumes(std::istream& in, std::string_view source) {
  const Json root = parse_json(in, source);
  IntentVolumes out;
  add_all({root, source, ""}, out);
  if (out.nominal.empty() && out.off_nominal.empty()) {
    throw InputError(source, {.expected = "at least one volume", .found = "none"});
  }
  return out;
}

std::vector<Volume4d> read_volumes_4d(std::istream& in, std::string_view source) {
  IntentVolumes read = read_intent_volumes(in, source);
  std::vector<Volume4d> out = std::move(read.nominal);
  out.insert(out.end(), read.off_nominal.begin(), read.off_nominal.end());
  return out;
}

std::string operational_intent_details(std::span<const Volume4d> volumes,
                                       std::optional<int> priority,
                                       std::span<const Volume4d> off_nominal) {
  std::string text = "{\"volumes\":[" + lines_of(volumes);
  text += "\n],\"off_nominal_volumes\":[" + lines_of(off_nominal);
  text += off_nominal.empty() ? "]" : "\n]";
  if (priority) text += fmt::format(",\"priority\":{}", *priority);
  return text + "}\n";
}

}  // namespace geom
