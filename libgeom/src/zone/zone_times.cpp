#include "geom/zone/zone_times.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/rounding.h"
#include "geom/text/instant.h"

namespace geom {
namespace {

constexpr double kDay = 86400;
constexpr double kForever = std::numeric_limits<double>::infinity();

// A limit of time that the map cannot say becomes one that it can, outward.
TimeSpan sayable(double from, double until) {
  if (from < -kLargestTime) from = -kForever;
  if (until > kLargestTime) until = kForever;
  return {std::min(from, kLargestTime), std::max(until, -kLargestTime)};
}

// In seconds since 1970.
struct Span {
  double from = -kForever;
  double until = kForever;
};

bool is_on(std::uint8_t days, std::int64_t day) {
  const std::int64_t weekday = ((day + 3) % 7 + 7) % 7;  // 1970-01-01 was a Thursday
  return (days >> weekday & 1) != 0;
}

// The first instant of a daily time at or after `after`, as late as it may be.
double next_end(const DayTime& time, double after, const SunArea& area) {
  const auto day = static_cast<std::int64_t>(std::floor(after / kDay));
  for (std::int64_t d = day - 2; d <= day + 2; ++d) {
    if (time.event) {
      const auto sun = sun_time(*time.event, d, area);
      if (!sun) continue;
      if (sun->least > after) return sun->most;
    } else {
      const double midnight = static_cast<double>(d) * kDay;
      if (midnight + time.least > after) return midnight + time.most;
    }
  }
  return after + 2 * kDay;
}

class Schedule {
 public:
  Schedule(const DailyPeriod& period, const SunArea& area) : period_(period), area_(area) {}

  // Appends what begins on the day.
  void add(std::int64_t day, std::vector<Span>& out) const {
    if (!is_on(period_.days, day)) return;
    const double midnight = static_cast<double>(day) * kDay;
    if (may_miss(day)) {
      out.push_back({midnight - kDay, midnight + 2 * kDay});
      return;
    }
    if (!period_.begin || !period_.begin->event) {
      for (const double begin : begins()) {
        add_from({midnight + begin, midnight + begin}, midnight, out);
      }
      return;
    }
    for (std::int64_t d = day - 1; d <= day + 1; ++d) {
      const auto sun = sun_time(*period_.begin->event, d, area_);
      const bool here = sun && sun->most >= midnight && sun->least <= midnight + kDay;
      if (sun && (d == day || here)) add_from(*sun, midnight, out);
    }
  }

 private:
  // In seconds after midnight UTC: on the day of UTC and, where a time is said in another offset,
  // on that offset's day.
  std::vector<double> begins() const {
    if (!period_.begin) {
      const double offset = period_.end ? period_.end->offset : 0;
      return offset == 0 ? std::vector<double>{0} : std::vector<double>{0, -offset};
    }
    const double there = period_.begin->least;
    const double here = there - std::floor(there / kDay) * kDay;
    return here == there ? std::vector<double>{here} : std::vector<double>{here, there};
  }

  // Whether one of the events may not come around the day.
  bool may_miss(std::int64_t day) const {
    for (const auto& end : {period_.begin, period_.end}) {
      if (!end || !end->event) continue;
      for (std::int64_t d = day - 1; d <= day + 2; ++d) {
        if (!sun_time(*end->event, d, area_)) return true;
      }
    }
    return false;
  }

  void add_from(const SunTime& begin, double midnight, std::vector<Span>& out) const {
    const double until = period_.end ? next_end(*period_.end, begin.most, area_)
                                     : std::max(midnight, begin.most) + kDay;
    out.push_back({begin.least, until});
  }

  const DailyPeriod& period_;
  const SunArea& area_;
};

class Clock {
 public:
  Clock(const ZoneClock& clock, const SunArea& area)
      : zero_(seconds_between("1970-01-01T00:00:00Z", *clock.epoch)),
        first_(static_cast<std::int64_t>(std::floor(zero_.least / kDay)) - clock.days),
        last_(static_cast<std::int64_t>(std::floor(zero_.most / kDay)) + clock.days),
        area_(area) {}

  // Appends the spans of a period, in seconds after the epoch.
  void add(const ZonePeriod& period, std::vector<TimeSpan>& out) const {
    const Span all = limits_of(period);
    if (period.schedule.empty()) {
      add_within(all, all, out);
      return;
    }
    add_within({-kForever, static_cast<double>(first_) * kDay}, all, out);
    add_within({static_cast<double>(last_ + 1) * kDay, kForever}, all, out);
    std::vector<Span> spans;
    for (const DailyPeriod& daily : period.schedule) {
      const Schedule schedule(daily, area_);
      for (std::int64_t day = first_ - 3; day <= last_ + 3; ++day) schedule.add(day, spans);
    }
    for (const Span& span : spans) add_within(span, all, out);
  }

 private:
  static Span limits_of(const ZonePeriod& period) {
    Span out;
    constexpr const char* kZero = "1970-01-01T00:00:00Z";
    if (period.start) out.from = seconds_between(kZero, *period.start).least;
    if (period.end) out.until = seconds_between(kZero, *period.end).most;
    return out;
  }

  void add_within(const Span& span, const Span& limits, std::vector<TimeSpan>& out) const {
    const double from = std::max(span.from, limits.from);
    const double until = std::min(span.until, limits.until);
    if (from > until) return;
    out.push_back(sayable(std::isfinite(from) ? add_down(from, -zero_.most) : from,
                          std::isfinite(until) ? add_up(until, -zero_.least) : until));
  }

  SecondsBetween zero_;  // the epoch, in seconds since 1970
  std::int64_t first_;
  std::int64_t last_;
  const SunArea& area_;
};

std::vector<TimeSpan> merged(std::vector<TimeSpan> spans) {
  std::sort(spans.begin(), spans.end());
  std::vector<TimeSpan> out;
  for (const TimeSpan& span : spans) {
    if (!out.empty() && span.from <= out.back().until) {
      out.back().until = std::max(out.back().until, span.until);
    } else {
      out.push_back(span);
    }
  }
  return out;
}

}  // namespace

std::vector<TimeSpan> zone_times(std::span<const ZonePeriod> periods, const ZoneClock& clock,
                                 const SunArea& area) {
  if (periods.empty() || !clock.epoch) return {TimeSpan{}};
  const Clock reading(clock, area);
  std::vector<TimeSpan> out;
  for (const ZonePeriod& period : periods) reading.add(period, out);
  return merged(std::move(out));
}

}  // namespace geom
