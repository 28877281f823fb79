#include "zone_period.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "geom/text/excerpt.h"
#include "geom/text/instant.h"

namespace geom::zone {
namespace {

constexpr std::string_view kPeriodKeys[] = {"permanent", "startDateTime", "endDateTime", "schedule",
                                            "dailyPeriod"};
constexpr std::string_view kScheduleKeys[] = {"day", "startTime", "startEvent", "endTime",
                                              "endEvent"};

// Whether it has a member that is neither null nor one of these.
bool warn_of_unknown(const Json& object, std::span<const std::string_view> known,
                     const ZonePlace& place, std::vector<std::string>& warnings) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_null() || std::find(known.begin(), known.end(), key) != known.end()) continue;
    warnings.push_back(
        fmt::format("{}: its times have a member \"{}\", which is not known, so they are read as "
                    "all the time",
                    place.item, excerpt(key, 40)));
    return true;
  }
  return false;
}

std::uint8_t day_bit(const Json& day, const ZonePlace& place) {
  static constexpr const char* kDays[] = {"MON", "TUE", "WED", "THU", "FRI", "SAT", "SUN"};
  if (day == "ANY") return kEveryDay;
  for (unsigned i = 0; i < 7; ++i) {
    if (day == kDays[i]) return static_cast<std::uint8_t>(1U << i);
  }
  place.refuse({.key = "day", .expected = "MON to SUN, or ANY", .found = shown(day)});
}

std::optional<DayTime> day_end_of(const Json& period, const char* time, const char* event,
                                  const ZonePlace& place) {
  const Json* const at = member(period, time);
  const Json* const sun = member(period, event);
  if (at && sun) {
    place.refuse({.key = time, .expected = std::string("absent beside ") + event, .found = "both"});
  }
  if (at) return day_time_of(*at, time, place);
  if (!sun) return std::nullopt;
  const auto word =
      sun->is_string() ? value_of(kDayEventWords, sun->get<std::string>()) : std::nullopt;
  if (!word) {
    place.refuse({.key = event, .expected = listed(kDayEventWords), .found = shown(*sun)});
  }
  return DayTime{.event = word};
}

void add_schedule(const Json* list, const ZonePlace& place, std::vector<std::string>& warnings,
                  std::vector<DailyPeriod>& out) {
  if (!list) return;
  if (!list->is_array()) {
    place.refuse({.key = "a schedule", .expected = "a list", .found = shown(*list)});
  }
  for (const Json& one : *list) {
    if (!one.is_object()) {
      place.refuse({.key = "a schedule", .expected = "objects", .found = shown(one)});
    }
    DailyPeriod period;
    if (warn_of_unknown(one, kScheduleKeys, place, warnings)) {
      out.push_back(period);
      continue;
    }
    const Json* const days = member(one, "day");
    if (days && days->is_array() && !days->empty()) {
      period.days = 0;
      for (const Json& day : *days) period.days |= day_bit(day, place);
    } else if (days && !days->is_array()) {
      period.days = day_bit(*days, place);
    }
    period.begin = day_end_of(one, "startTime", "startEvent", place);
    period.end = day_end_of(one, "endTime", "endEvent", place);
    out.push_back(period);
  }
}

void require_ordered(const ZonePeriod& period, const ZonePlace& place) {
  if (!period.start || !period.end) return;
  if (seconds_between(*period.start, *period.end).most >= 0) return;
  place.refuse({.key = "endDateTime",
                .expected = "after startDateTime",
                .found = fmt::format("{} and {}", *period.start, *period.end)});
}

bool is_permanent(const Json& period, const ZonePlace& place) {
  const Json* const permanent = member(period, "permanent");
  if (!permanent || *permanent == "NO" || *permanent == false) return false;
  if (*permanent == "YES" || *permanent == true) return true;
  place.refuse({.key = "permanent", .expected = "YES or NO", .found = shown(*permanent)});
}

ZonePeriod period_of(const Json& json, const ZonePlace& place, std::vector<std::string>& warnings) {
  ZonePeriod period;
  if (const Json* const at = member(json, "startDateTime")) {
    period.start = instant_of(*at, "startDateTime", Side::begin, place);
  }
  if (const Json* const at = member(json, "endDateTime")) {
    period.end = instant_of(*at, "endDateTime", Side::end, place);
  }
  for (const char* key : {"schedule", "dailyPeriod"}) {
    add_schedule(member(json, key), place, warnings, period.schedule);
  }
  require_ordered(period, place);
  return period;
}

}  // namespace

// What is permanent is always there, whatever else stands beside it.
std::vector<ZonePeriod> periods_of(const Json* list, const char* key, const ZonePlace& place,
                                   std::vector<std::string>& warnings) {
  std::vector<ZonePeriod> out;
  if (!list) return out;
  if (!list->is_array()) {
    place.refuse({.key = key, .expected = "a list", .found = shown(*list)});
  }
  for (const Json& one : *list) {
    if (!one.is_object()) {
      place.refuse({.key = key, .expected = "objects", .found = shown(one)});
    }
    if (warn_of_unknown(one, kPeriodKeys, place, warnings) || is_permanent(one, place)) return {};
    out.push_back(period_of(one, place, warnings));
  }
  return out;
}

}  // namespace geom::zone
