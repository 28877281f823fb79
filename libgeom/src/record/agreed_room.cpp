#include "geom/record/agreed_room.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/record/made_for_another.h"
#include "geom/vehicle/shown_limit.h"

namespace geom {
namespace {

std::string in_words(const Room& room, bool exact) {
  return fmt::format("{} with margin {} m", in_words(room.vehicle, exact), room.margin);
}

// What a record asks for; where it says nothing, what this run asks for.
Room recorded(const Provenance& record, const Room& now) {
  Room room = now;
  if (record.vehicle) room = {*record.vehicle, 0};
  if (record.margin) room.margin = *record.margin;
  return room;
}

bool holds(const Room& room, const Room& other) {
  const Vec3 ours = room.vehicle.half.array() + room.margin;
  const Vec3 theirs = other.vehicle.half.array() + other.margin;
  return (ours.array() >= theirs.array()).all();
}

// In words, the first limit in which two vehicles differ.
std::string difference(const Limits& asked, const Limits& found) {
  for (const LimitKind& kind : kLimitKinds) {
    const auto& a = asked[kind.limit];
    const auto& b = found[kind.limit];
    if (a == b) continue;
    return fmt::format("{} {}, as asked, found {}", kind.name, a ? shown(kind, *a) : "unlimited",
                       b ? shown(kind, *b) : "unlimited");
  }
  return {};
}

Room agreed_in_full(const Provenance& record, const AskedRoom& asked, Differences differences,
                    std::string_view source, std::size_t line) {
  if (!asked.vehicle && !record.vehicle) {
    throw UsageError(
        "no vehicle: the record names none; give --vehicle, such as tello or "
        "box:0.5,0.5,0.3");
  }
  Room room;
  room.vehicle = asked.vehicle ? *asked.vehicle : *record.vehicle;
  room.margin = asked.margin ? *asked.margin : record.margin.value_or(0);
  if (differences == Differences::allowed) return room;
  const Room had = recorded(record, room);
  const bool same = room.vehicle.half == had.vehicle.half && room.margin == had.margin;
  if (!same && !(differences == Differences::stricter_allowed && holds(room, had))) {
    const bool exact = in_words(room, false) == in_words(had, false);
    throw InputError(source, line,
                     {.expected = fmt::format("the vehicle {}, as asked", in_words(room, exact)),
                      .found = in_words(had, exact),
                      .advice = "ask for that one, or make this anew"});
  }
  const Limits& ours = room.vehicle.limits;
  const Limits& theirs = had.vehicle.limits;
  if (theirs == Limits{} || ours == theirs) return room;
  if (differences == Differences::refused && ours != Limits{}) {
    throw InputError(source, line,
                     {.expected = fmt::format("the vehicle {} with {} of {}", room.vehicle.name,
                                              difference(ours, theirs), had.vehicle.name)});
  }
  room.vehicle.limits = stricter(ours, theirs);
  return room;
}

}  // namespace

Room agreed_room(const Provenance& record, const AskedRoom& asked, Differences differences,
                 std::string_view source, std::size_t line) {
  Room room = agreed_in_full(record, asked, differences, source, line);
  if (!(asked.spare <= room.margin)) {
    throw InputError(source, line,
                     {.expected = fmt::format(
                          "a margin of {} m or more, which --spare takes from it", asked.spare),
                      .found = fmt::format("{} m", room.margin)});
  }
  room.margin -= asked.spare;
  return room;
}

bool smaller_than_asked(const Room& room, const Provenance& record) {
  return !holds(room, recorded(record, room));
}

namespace {

void require_speed_and_acceleration(const Limits& limits, const std::string& vehicle) {
  const bool speed =
      limits[Limit::speed] || (limits[Limit::horizontal_speed] && limits[Limit::vertical_speed]);
  const bool acceleration =
      limits[Limit::acceleration] || (limits[Limit::tilt] && limits[Limit::thrust]);
  constexpr const char* kSpeed = "--vmax (or --vmax-h and --vmax-v)";
  constexpr const char* kAcceleration = "--amax (or --tilt and --thrust)";
  if (speed && acceleration) return;
  if (speed || acceleration) {
    throw UsageError(
        fmt::format("no limit on {}, which the vehicle {} does not name either: give {}",
                    speed ? "acceleration" : "speed", vehicle, speed ? kAcceleration : kSpeed));
  }
  throw UsageError(fmt::format(
      "no limits on speed and acceleration, and the vehicle {} names none: give {} and {}", vehicle,
      kSpeed, kAcceleration));
}

}  // namespace

Limits limits_to_check(const LimitSources& sources, const std::string& vehicle) {
  const auto& asked = sources.options[Limit::tilt];
  const auto& held = sources.vehicle[Limit::tilt];
  if (sources.overridden && asked && held && *asked > *held) {
    throw UsageError(fmt::format(
        "tilt: asked for {:.10g} degrees, but the box of {} holds its body up to {:.10g} "
        "degrees only, which --override cannot change: name a --vehicle whose profile "
        "allows that tilt",
        *asked / kRadiansPerDegree, vehicle, *held / kRadiansPerDegree));
  }
  return limits_that_hold(sources);
}

Limits limits_to_solve(const Limits& asked, const Vehicle& vehicle) {
  if (const auto above = first_above(asked, vehicle.limits)) {
    const LimitKind& kind = kind_of(*above);
    throw UsageError(fmt::format(
        "{}: asked for {}, but the vehicle {} may do at most {}: ask for no more, or name a "
        "--vehicle that may",
        kind.name, shown(kind, *asked[*above]), vehicle.name,
        shown(kind, *vehicle.limits[*above])));
  }
  const Limits limits = limits_that_hold({asked, {}, vehicle.limits});
  require_speed_and_acceleration(limits, vehicle.name);
  return limits;
}

}  // namespace geom
