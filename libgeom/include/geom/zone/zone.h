#pragma once

// Zones of airspace as states publish them: where, how high, when, and who decides.
//
// Example:
//   geom::Zone zone{.identifier = "CH-1", .type = geom::ZoneType::prohibited};
//   geom::ZoneVolume& volume = zone.volumes.emplace_back();
//   volume.outline.centre = {47.4, 8.5, 0};
//   volume.outline.radius = 500;
//   volume.upper = geom::HeightLimit{120, geom::HeightReference::ground};
//   assert(!volume.lower && zone.periods.empty());  // from below all, and always

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geom/map/geodetic_outline.h"
#include "geom/text/words.h"

namespace geom {

// What a zone asks of a flight. ED-269 writes REQ_AUTHORISATION.
enum class ZoneType { prohibited, authorization, conditional, u_space, none };
inline constexpr Words<ZoneType, 5> kZoneTypeWords{{{ZoneType::prohibited, "PROHIBITED"},
                                                    {ZoneType::authorization, "REQ_AUTHORIZATION"},
                                                    {ZoneType::conditional, "CONDITIONAL"},
                                                    {ZoneType::u_space, "USPACE"},
                                                    {ZoneType::none, "NO_RESTRICTION"}}};
constexpr std::string_view name(ZoneType type) { return word_of(kZoneTypeWords, type); }

// What a height counts from: the ground below (AGL), the sea level (AMSL), the ellipsoid (WGS84).
enum class HeightReference { ground, sea, ellipsoid };
inline constexpr Words<HeightReference, 3> kHeightReferenceWords{
    {{HeightReference::ground, "AGL"},
     {HeightReference::sea, "AMSL"},
     {HeightReference::ellipsoid, "WGS84"}}};

struct HeightLimit {
  double metres = 0;
  HeightReference from = HeightReference::ground;
};

// A polygon or a circle between two heights; closed. Edges are those of the file: nobody says
// whether they are straight in degrees or shortest ways.
struct ZoneVolume {
  GeodeticOutline outline;
  std::vector<std::vector<GeodeticPlace>> holes;  // of a polygon
  std::optional<HeightLimit> lower;               // absent: open below
  std::optional<HeightLimit> upper;               // absent: open above
};

// Events of the sun: begin of civil twilight, sunrise, sunset, end of civil twilight.
enum class DayEvent { twilight_begins, sunrise, sunset, twilight_ends };
inline constexpr Words<DayEvent, 4> kDayEventWords{{{DayEvent::twilight_begins, "BMCT"},
                                                    {DayEvent::sunrise, "SR"},
                                                    {DayEvent::sunset, "SS"},
                                                    {DayEvent::twilight_ends, "EECT"}}};

// A time of day: an event, or seconds after midnight UTC between which the time lies. A time to the
// minute ends with that minute. A time in another offset than UTC's may be before or after this
// day.
struct DayTime {
  std::optional<DayEvent> event;
  double least = 0;
  double most = 0;
  double offset = 0;  // s that the clock which it is read from is ahead of UTC
};

inline constexpr std::uint8_t kEveryDay = 0x7f;

// Bit d of `days` is the day d after Monday. Nobody says whether days are those of UTC or of the
// offset in which a time is said, so the period is there on both. If it ends before it begins, it
// ends on the next day.
struct DailyPeriod {
  std::uint8_t days = kEveryDay;
  std::optional<DayTime> begin;  // absent: with the day
  std::optional<DayTime> end;    // absent: with the day
};

// Instants as epoch_from() writes them (geom/text/instant.h). Without a schedule it is there all
// the time between them.
struct ZonePeriod {
  std::optional<std::string> start;  // absent: since ever
  std::optional<std::string> end;    // absent: for ever
  std::vector<DailyPeriod> schedule;
};

struct Zone {
  std::string identifier;
  std::string name;
  std::string country;
  ZoneType type = ZoneType::prohibited;
  std::vector<ZoneVolume> volumes;
  std::vector<ZonePeriod> periods;  // any of them; none: always
  std::string authority;            // who is asked, with all that the file says of how
  std::string message;              // what the file says to people, with the conditions
};

// All zones of a file, and what it says of itself.
struct ZoneFile {
  std::string format;                     // the word of its format
  std::string title;                      // may be empty
  std::optional<std::string> issued;      // instants, as the file has them
  std::optional<std::string> valid_from;  // as epoch_from() writes them
  std::optional<std::string> valid_to;
  std::vector<Zone> zones;
  std::vector<std::string> warnings;  // what was read in the stricter of two ways
};

}  // namespace geom
