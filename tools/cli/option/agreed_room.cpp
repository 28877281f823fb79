#include "agreed_room.h"

#include <fmt/format.h>

#include "cli/answer/exit.h"
#include "geom/base/error.h"
#include "geom/record/made_for_another.h"
#include "geom/vehicle/shown_limit.h"
#include "limit_options.h"

namespace cli {
namespace {

using geom::Vec3;

std::string in_words(const Room& room, bool exact) {
  return fmt::format("{} with margin {} m", geom::in_words(room.vehicle, exact), room.margin);
}

// What a record asks for; where it says nothing, what this run asks for.
Room recorded(const geom::Provenance& record, const Room& now) {
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
std::string difference(const geom::Limits& asked, const geom::Limits& found) {
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    const auto& a = asked[kind.limit];
    const auto& b = found[kind.limit];
    if (a == b) continue;
    return fmt::format("{} {}, as asked, found {}", kind.name, a ? shown(kind, *a) : "unlimited",
                       b ? shown(kind, *b) : "unlimited");
  }
  return {};
}

Room agreed_in_full(const geom::Provenance& record, const AskedRoom& asked, Differences differences,
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
    throw geom::InputError(
        source, line,
        {.expected = fmt::format("the vehicle {}, as asked", in_words(room, exact)),
         .found = in_words(had, exact),
         .advice = "ask for that one, or make this anew"});
  }
  const geom::Limits& ours = room.vehicle.limits;
  const geom::Limits& theirs = had.vehicle.limits;
  if (theirs == geom::Limits{} || ours == theirs) return room;
  if (differences == Differences::refused && ours != geom::Limits{}) {
    throw geom::InputError(
        source, line,
        {.expected = fmt::format("the vehicle {} with {} of {}", room.vehicle.name,
                                 difference(ours, theirs), had.vehicle.name)});
  }
  room.vehicle.limits = geom::stricter(ours, theirs);
  return room;
}

}  // namespace

Room agreed_room(const geom::Provenance& record, const AskedRoom& asked, Differences differences,
                 std::string_view source, std::size_t line) {
  Room room = agreed_in_full(record, asked, differences, source, line);
  if (!(asked.spare <= room.margin)) {
    throw geom::InputError(
        source, line,
        {.expected =
             fmt::format("a margin of {} m or more, which --spare takes from it", asked.spare),
         .found = fmt::format("{} m", room.margin)});
  }
  room.margin -= asked.spare;
  return room;
}

bool smaller_than_asked(const Room& room, const geom::Provenance& record) {
  return !holds(room, recorded(record, room));
}

}  // namespace cli
