#include "geom/zone/sun_times.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace geom {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kDay = 86400;
constexpr double kPerDegree = 240;    // s that the sun takes for a degree of longitude
constexpr double kAside = 0.5;        // degrees of height that are allowed for
constexpr double kMore = 120;         // s
constexpr double kSteepest = 89.9;    // degrees of latitude
constexpr double kJ2000 = 946728000;  // 2000-01-01T12:00:00Z

struct Sun {
  double declination;       // radians
  double equation_of_time;  // s that the sun is ahead of the mean sun
};

// Astronomical Almanac, page C5: low-precision formulas for the sun.
Sun sun_at(double seconds) {
  const double n = (seconds - kJ2000) / kDay;
  const double mean_longitude = std::remainder(280.460 + 0.9856474 * n, 360);
  const double anomaly = std::remainder(357.528 + 0.9856003 * n, 360) * kDegree;
  const double longitude =
      (mean_longitude + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2 * anomaly)) * kDegree;
  const double obliquity = (23.439 - 0.0000004 * n) * kDegree;
  const double ascension =
      std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)) / kDegree;
  return {std::asin(std::sin(obliquity) * std::sin(longitude)),
          std::remainder(mean_longitude - ascension, 360) * kPerDegree};
}

// How long before or after noon the sun is at the height, s; nothing where it never is.
std::optional<double> from_noon(double height, double latitude, double declination) {
  const double phi = std::clamp(latitude, -kSteepest, kSteepest) * kDegree;
  const double cosine = (std::sin(height * kDegree) - std::sin(phi) * std::sin(declination)) /
                        (std::cos(phi) * std::cos(declination));
  if (!(std::abs(cosine) < 1)) return std::nullopt;
  return std::acos(cosine) / kDegree * kPerDegree;
}

bool is_morning(DayEvent event) {
  return event == DayEvent::twilight_begins || event == DayEvent::sunrise;
}

double height_of(DayEvent event) {
  return event == DayEvent::sunrise || event == DayEvent::sunset ? -0.833 : -6;
}

}  // namespace

std::optional<SunTime> sun_time(DayEvent event, std::int64_t day, const SunArea& area) {
  const double middle = (area.west + area.east) / 2;
  const double noon = static_cast<double>(day) * kDay + kDay / 2 - middle * kPerDegree;
  const double aside = (area.east - area.west) / 2 * kPerDegree;
  std::optional<SunTime> out;
  for (const double at : {noon - kDay / 2, noon, noon + kDay / 2}) {
    const Sun sun = sun_at(at);
    for (const double height : {height_of(event) - kAside, height_of(event) + kAside}) {
      for (const double latitude : {area.south, area.north}) {
        const auto beside = from_noon(height, latitude, sun.declination);
        if (!beside) return std::nullopt;
        const double time = noon - sun.equation_of_time + (is_morning(event) ? -*beside : *beside);
        const SunTime here{time - aside - kMore, time + aside + kMore};
        out =
            out ? SunTime{std::min(out->least, here.least), std::max(out->most, here.most)} : here;
      }
    }
  }
  return out;
}

}  // namespace geom
