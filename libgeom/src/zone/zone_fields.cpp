#include "zone_fields.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/text/instant.h"
#include "geom/text/number.h"
#include "shape/simple_ring.h"

namespace geom::zone {
namespace {

constexpr double kNoCeiling = 99999;         // in any unit
constexpr double kLongestEdge = 1e6;         // m
constexpr double kMetresPerDegree = 111700;  // of a meridian or a parallel, at most
constexpr double kLargestRadius = 1e5;       // m

std::optional<double> whole_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = read_number(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

int two(std::string_view text, std::size_t at) {
  return (text[at] - '0') * 10 + text[at + 1] - '0';
}

// The seconds east of UTC of "Z", "+02:00", "-0330" or "+02"; nothing for other text.
std::optional<int> offset_of(std::string_view text) {
  if (text == "Z" || text == "z") return 0;
  if (text.empty() || (text[0] != '+' && text[0] != '-')) return std::nullopt;
  std::string plain(text.substr(1));
  if (plain.size() == 5 && plain[2] == ':') plain.erase(2, 1);
  if (plain.size() == 2) plain += "00";
  if (plain.size() != 4 || !digits(plain)) return std::nullopt;
  const int seconds = (two(plain, 0) * 60 + two(plain, 2)) * 60;
  if (two(plain, 2) > 59 || seconds > 14 * 3600) return std::nullopt;
  return text[0] == '-' ? -seconds : seconds;
}

// The date and time, and the offset from UTC.
struct SplitTime {
  std::string_view time;
  std::optional<int> offset;
};
SplitTime split_offset(std::string_view text, std::size_t from) {
  const std::size_t at = text.find_first_of("Zz+-", from);
  if (at == std::string_view::npos) return {text, std::nullopt};
  return {text.substr(0, at), offset_of(text.substr(at))};
}

double length_of(const GeodeticPlace& a, const GeodeticPlace& b) {
  const double east = std::abs(std::remainder(b.longitude - a.longitude, 360));
  const double least = std::min(std::abs(a.latitude), std::abs(b.latitude));
  const double shrink = a.latitude * b.latitude <= 0 ? 1 : std::cos(least * M_PI / 180);
  return kMetresPerDegree * std::hypot(b.latitude - a.latitude, east * shrink);
}

bool same(const GeodeticPlace& a, const GeodeticPlace& b) {
  return a.latitude == b.latitude && a.longitude == b.longitude;
}

std::vector<GeodeticPlace> ring_of(const Json& positions, const ZonePlace& place) {
  if (!positions.is_array()) {
    place.refuse({.key = "a ring", .expected = "a list of positions", .found = shown(positions)});
  }
  std::vector<GeodeticPlace> ring;
  for (const Json& position : positions) {
    const GeodeticPlace next = place_of(position, place);
    if (ring.empty() || !same(ring.back(), next)) ring.push_back(next);
  }
  if (ring.size() > 1 && same(ring.front(), ring.back())) ring.pop_back();
  if (ring.size() < 3) {
    place.refuse({.key = "a ring",
                  .expected = "three different places or more",
                  .found = fmt::to_string(ring.size())});
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double length = length_of(ring[i], ring[(i + 1) % ring.size()]);
    if (length <= kLongestEdge) continue;
    place.refuse({.key = "a ring",
                  .expected = "edges of at most 1000 km",
                  .found = fmt::format("one of {:.0f} km from [{}, {}]", length / 1000,
                                       ring[i].longitude, ring[i].latitude)});
  }
  return ring;
}

// In degrees, so that it crosses no antimeridian.
bool has_crossings(const std::vector<GeodeticPlace>& ring) {
  std::vector<Vec2> flat;
  for (const GeodeticPlace& p : ring) {
    const double east = std::remainder(p.longitude - ring[0].longitude, 360);
    flat.emplace_back(east, p.latitude);
  }
  return !is_simple(flat);
}

ZoneVolume polygon_of(const Json& rings, const ZonePlace& place,
                      std::vector<std::string>& warnings) {
  if (!rings.is_array() || rings.empty()) {
    place.refuse({.key = "a polygon", .expected = "a list of rings", .found = shown(rings)});
  }
  ZoneVolume volume;
  volume.outline.ring = ring_of(rings[0], place);
  if (has_crossings(volume.outline.ring)) {
    warnings.push_back(place.item +
                       ": its outline crosses itself; all that it encloses in any reading counts");
  }
  for (std::size_t i = 1; i < rings.size(); ++i) {
    volume.holes.push_back(ring_of(rings[i], place));
    if (has_crossings(volume.holes.back())) {
      place.refuse({.key = "a hole", .expected = "edges that do not cross", .found = "crossings"});
    }
  }
  return volume;
}

std::string joined_texts(const Json& list) {
  std::string out;
  for (const Json& one : list) {
    if (!one.is_string()) continue;
    out += (out.empty() ? "" : "; ") + one.get<std::string>();
  }
  return out;
}

}  // namespace

const Json* member(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto at = object.find(key);
  return at == object.end() || at->is_null() ? nullptr : &*at;
}

double number_of(const Json& value, std::string_view key, const ZonePlace& place) {
  std::optional<double> number;
  if (value.is_number()) number = value.get<double>();
  if (value.is_string()) number = whole_number(value.get<std::string>());
  if (!number || !std::isfinite(*number)) {
    place.refuse({.key = std::string(key), .expected = "a number", .found = shown(value)});
  }
  return *number;
}

std::string text_of(const Json& object, const char* key) {
  const Json* const value = member(object, key);
  return value && value->is_string() ? value->get<std::string>() : "";
}

std::string spoken(const Json* value) {
  if (!value) return "";
  if (value->is_string()) return value->get<std::string>();
  if (!value->is_array()) return "";
  std::string first;
  for (const Json& one : *value) {
    const std::string text = text_of(one, "text");
    if (!text.empty() && text_of(one, "lang").starts_with("en")) return text;
    if (first.empty()) first = text;
  }
  return first.empty() ? joined_texts(*value) : first;
}

std::string message_of(const Json& zone) {
  std::string out;
  for (const char* key : {"message", "restrictionConditions", "otherReasonInfo"}) {
    const std::string text = spoken(member(zone, key));
    if (!text.empty()) out += (out.empty() ? "" : "; ") + text;
  }
  return out;
}

std::string instant_of(const Json& value, const char* key, Side side, const ZonePlace& place) {
  const std::string text = value.is_string() ? value.get<std::string>() : "";
  const SplitTime split = split_offset(text, std::min<std::size_t>(text.size(), 11));
  const auto local = split.offset ? epoch_from(std::string(split.time) + "Z") : std::nullopt;
  if (local && *split.offset == 0) return *local;
  std::optional<std::string> utc;
  if (local) {
    utc = side == Side::begin ? instant_not_after(*local, -*split.offset)
                              : instant_not_before(*local, -*split.offset);
  }
  if (!utc) {
    place.refuse({.key = key,
                  .expected = "an instant with its offset from UTC, such as "
                              "\"2026-05-04T06:30:00Z\" (RFC 3339)",
                  .found = shown(value)});
  }
  return *utc;
}

DayTime day_time_of(const Json& value, const char* key, const ZonePlace& place) {
  const std::string text = value.is_string() ? value.get<std::string>() : "";
  const SplitTime split = split_offset(text, 0);
  const std::string_view time = split.time;
  const bool minutes =
      time.size() >= 5 && digits(time.substr(0, 2)) && time[2] == ':' && digits(time.substr(3, 2));
  const bool seconds = minutes && time.size() >= 8 && time[5] == ':' && digits(time.substr(6, 2)) &&
                       (time.size() == 8 || (time[8] == '.' && digits(time.substr(9))));
  const bool form = split.offset && (seconds || (minutes && time.size() == 5));
  const int hour = form ? two(time, 0) : 99;
  const int second = seconds ? two(time, 6) : 0;
  if (!form || hour > 24 || two(time, 3) > 59 || second > 60 ||
      (hour == 24 && (two(time, 3) > 0 || second > 0))) {
    place.refuse({.key = key,
                  .expected = "a time with its offset from UTC, such as \"08:00Z\"",
                  .found = shown(value)});
  }
  const double at = hour * 3600 + two(time, 3) * 60 + second - *split.offset;
  return {.event = {},
          .least = at,
          .most = at + (seconds ? 1 : 60),
          .offset = static_cast<double>(*split.offset)};
}

ZoneType type_of(const Json* value, const char* key, const ZonePlace& place) {
  const std::string word = value && value->is_string() ? value->get<std::string>() : "";
  if (word == "REQ_AUTHORISATION") return ZoneType::authorization;
  const auto type = value_of(kZoneTypeWords, word);
  if (!type) {
    place.refuse({.key = key,
                  .expected = listed(kZoneTypeWords),
                  .found = value ? shown(*value) : std::string("none")});
  }
  return *type;
}

GeodeticPlace place_of(const Json& value, const ZonePlace& place) {
  const bool two_numbers =
      value.is_array() && value.size() >= 2 && value[0].is_number() && value[1].is_number();
  if (!two_numbers || !(std::abs(value[0].get<double>()) <= 180) ||
      !(std::abs(value[1].get<double>()) <= 90)) {
    place.refuse({.key = "a position",
                  .expected = "[longitude, latitude] in degrees",
                  .found = shown(value)});
  }
  return {value[1].get<double>(), value[0].get<double>(), 0};
}

std::vector<ZoneVolume> polygons_of(const Json& geometry, const ZonePlace& place,
                                    std::vector<std::string>& warnings) {
  const std::string type = text_of(geometry, "type");
  const Json* const coordinates = member(geometry, "coordinates");
  if (!coordinates || (type != "Polygon" && type != "MultiPolygon")) {
    place.refuse({.key = "a geometry",
                  .expected = "a Polygon, a MultiPolygon or a circle, with coordinates",
                  .found = coordinates ? in_quotes(type) : shown(geometry)});
  }
  if (type == "Polygon") return {polygon_of(*coordinates, place, warnings)};
  if (!coordinates->is_array() || coordinates->empty()) {
    place.refuse({.key = "a MultiPolygon", .expected = "polygons", .found = shown(*coordinates)});
  }
  std::vector<ZoneVolume> out;
  for (const Json& rings : *coordinates) out.push_back(polygon_of(rings, place, warnings));
  return out;
}

ZoneVolume circle_of(const Json& centre, const Json& radius, const ZonePlace& place) {
  ZoneVolume out;
  out.outline.centre = place_of(centre, place);
  out.outline.radius = number_of(radius, "radius", place);
  if (!(out.outline.radius > 0 && out.outline.radius <= kLargestRadius)) {
    place.refuse(
        {.key = "radius", .expected = "above 0 and within 100 km", .found = shown(radius)});
  }
  return out;
}

std::optional<HeightLimit> limit_of(const Json& object, const LimitKeys& keys, double metres,
                                    const ZonePlace& place) {
  const Json* const limit = member(object, keys.limit);
  if (!limit) return std::nullopt;
  const double value = number_of(*limit, keys.limit, place);
  if (value >= kNoCeiling) return std::nullopt;
  const Json* const reference = member(object, keys.reference);
  const auto from = reference && reference->is_string()
                        ? value_of(kHeightReferenceWords, reference->get<std::string>())
                        : std::nullopt;
  if (!from) {
    place.refuse({.key = keys.reference,
                  .expected = listed(kHeightReferenceWords),
                  .found = reference ? shown(*reference) : std::string("none")});
  }
  return HeightLimit{value * metres, *from};
}

void require_ordered(const ZoneVolume& volume, const ZonePlace& place) {
  if (!volume.lower || !volume.upper || volume.lower->from != volume.upper->from) return;
  if (volume.lower->metres <= volume.upper->metres) return;
  place.refuse({.key = "the lower limit",
                .expected = "<= the upper one",
                .found = fmt::format("{} and {} m", volume.lower->metres, volume.upper->metres)});
}

std::string authorities_of(const Json* list) {
  std::string out;
  if (!list || !list->is_array()) return out;
  for (const Json& one : *list) {
    std::string words;
    for (const char* key :
         {"name", "service", "contactName", "email", "phone", "siteURL", "purpose"}) {
      const std::string text = spoken(member(one, key));
      if (!text.empty()) words += (words.empty() ? "" : ", ") + text;
    }
    const std::string before = text_of(one, "intervalBefore");
    if (!before.empty()) words += ", " + before + " before";
    if (!words.empty()) out += (out.empty() ? "" : "; ") + words;
  }
  return out;
}

}  // namespace geom::zone
