#pragma once

// Members of a zone's JSON, with errors that name the zone.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"
#include "geom/zone/zone.h"

namespace geom::zone {

using Json = nlohmann::json;

// Where a value stands: the file and the zone.
struct ZonePlace {
  std::string source;
  std::string item;  // "zone CH-1"

  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source, within(item, std::move(fault)));
  }
};

// A member that is there and not null; else null.
const Json* member(const Json& object, const char* key);

// A number, or a text that is one.
double number_of(const Json& value, std::string_view key, const ZonePlace& place);

// A member that is text, or "".
std::string text_of(const Json& object, const char* key);

// What a text says to people: itself, or of a list of {"text", "lang"} the English or first one, or
// of a list of texts all.
std::string spoken(const Json* value);

// What a zone's members say of its conditions, joined by "; ".
std::string message_of(const Json& zone);

// An instant with an offset from UTC, as epoch_from() writes it; rounded down or up.
enum class Side { begin, end };
std::string instant_of(const Json& value, const char* key, Side side, const ZonePlace& place);

// "08:00Z", "08:00:00Z", "08:00:00.00+02:00".
DayTime day_time_of(const Json& value, const char* key, const ZonePlace& place);

// The type of a word, in either spelling.
ZoneType type_of(const Json* value, const char* key, const ZonePlace& place);

// [longitude, latitude, …] on Earth.
GeodeticPlace place_of(const Json& value, const ZonePlace& place);

// The volumes of GeoJSON's Polygon or MultiPolygon, whose limits the caller sets. Adds warnings of
// rings whose edges cross.
std::vector<ZoneVolume> polygons_of(const Json& geometry, const ZonePlace& place,
                                    std::vector<std::string>& warnings);

// A circle about a place, m.
ZoneVolume circle_of(const Json& centre, const Json& radius, const ZonePlace& place);

// A limit and its reference. Nothing where the limit is absent or stands for none (99999).
struct LimitKeys {
  const char* limit;
  const char* reference;
};
std::optional<HeightLimit> limit_of(const Json& object, const LimitKeys& keys, double metres,
                                    const ZonePlace& place);

// Throws where the lower limit is above the upper one of the same reference.
void require_ordered(const ZoneVolume& volume, const ZonePlace& place);

// "name, service, email …; purpose; 30 days before".
std::string authorities_of(const Json* list);

}  // namespace geom::zone
