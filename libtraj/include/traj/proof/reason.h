#pragma once

// Why something is refused: the first that holds, as reports name it.
//
// Example:
//   assert(traj::name(traj::broken(traj::Limit::tilt)) == "tilt");
//   assert(traj::name(traj::unmeasured(traj::Limit::tilt)) == "tilt_not_measured");

#include <string_view>

#include "geom/text/words.h"
#include "traj/proof/limits.h"

namespace traj {

enum class Reason {
  none,  // it is not refused
  // Nothing to check.
  no_path,
  infeasible,
  stopped,
  // Numbers that cannot be judged (domain.h); also the vehicle's half sizes or margin.
  duration,
  coordinates,
  limits,
  vehicle,
  // Its way. Undecided: the way between two samples could not be bounded.
  discontinuous,
  bounds,
  collision,
  undecided,
  // A mission: the way up, the ground that it begins on, what it lands on, the autopilot's
  // envelope, a return that it does not say, a place other than the trajectory's end, a fence.
  takeoff,
  takeoff_ground,
  landing,
  ceiling,
  range,
  endurance,
  return_home,
  end,
  fence,
  // A record's own bound on its duration, or on the length of paths, that cannot be.
  duration_bound,
  // A limit that does not hold: broken() says which.
  first_broken,
  last_broken = first_broken + geom::kLimits - 1,
  // A limit that was asked for and is not measured: unmeasured() says which.
  first_unmeasured,
  last_unmeasured = first_unmeasured + geom::kLimits - 1
};
// That a limit does not hold, or is not measured.
constexpr Reason broken(Limit limit) {
  return static_cast<Reason>(static_cast<int>(Reason::first_broken) + static_cast<int>(limit));
}
constexpr Reason unmeasured(Limit limit) {
  return static_cast<Reason>(static_cast<int>(Reason::first_unmeasured) + static_cast<int>(limit));
}

inline constexpr geom::Words<Reason, 22> kOtherReasonWords{{
    {Reason::none, ""},
    {Reason::no_path, "no_path"},
    {Reason::infeasible, "infeasible"},
    {Reason::stopped, "stopped"},
    {Reason::duration, "duration"},
    {Reason::coordinates, "coordinates"},
    {Reason::limits, "limits"},
    {Reason::vehicle, "vehicle"},
    {Reason::discontinuous, "discontinuous"},
    {Reason::bounds, "bounds"},
    {Reason::collision, "collision"},
    {Reason::undecided, "undecided"},
    {Reason::takeoff, "takeoff"},
    {Reason::takeoff_ground, "takeoff_ground"},
    {Reason::landing, "landing"},
    {Reason::ceiling, "ceiling"},
    {Reason::range, "range"},
    {Reason::endurance, "endurance"},
    {Reason::return_home, "return"},
    {Reason::end, "end"},
    {Reason::fence, "fence"},
    {Reason::duration_bound, "duration_bound"},
}};
// "speed_not_measured" and so on, each of `size` characters.
struct UnmeasuredWord {
  std::array<char, 64> text{};
  std::size_t size = 0;
};
inline constexpr PerLimit<UnmeasuredWord> kUnmeasuredWords = [] {
  PerLimit<UnmeasuredWord> out;
  for (const LimitKind& kind : kLimitKinds) {
    for (const std::string_view part :
         {std::string_view(kind.quantity), std::string_view("_not_measured")}) {
      for (const char c : part) out[kind.limit].text[out[kind.limit].size++] = c;
    }
  }
  return out;
}();
inline constexpr auto kReasonWords = [] {
  geom::Words<Reason, 2 * geom::kLimits> of_limits;
  for (std::size_t i = 0; i < geom::kLimits; ++i) {
    const LimitKind& kind = kLimitKinds[i];
    const UnmeasuredWord& word = kUnmeasuredWords[kind.limit];
    of_limits[i] = {broken(kind.limit), kind.quantity};
    of_limits[geom::kLimits + i] = {unmeasured(kind.limit), {word.text.data(), word.size}};
  }
  return geom::joined<Reason>(kOtherReasonWords, of_limits);
}();
constexpr std::string_view name(Reason reason) { return geom::word_of(kReasonWords, reason); }

}  // namespace traj
