#pragma once

// The result of a query for a path.
//
// Example:
//   assert(geom::name(geom::PathStatus::start_blocked) == "start_blocked");

#include <optional>
#include <string_view>

#include "geom/text/words.h"

namespace geom {

enum class PathStatus {
  found,
  unreachable,
  start_blocked,
  goal_blocked,
  start_outside,
  goal_outside,
  stopped  // gave up: there may be a path
};
inline constexpr Words<PathStatus, 7> kPathStatusWords{{
    {PathStatus::found, "found"},
    {PathStatus::unreachable, "unreachable"},
    {PathStatus::start_blocked, "start_blocked"},
    {PathStatus::goal_blocked, "goal_blocked"},
    {PathStatus::start_outside, "start_outside"},
    {PathStatus::goal_outside, "goal_outside"},
    {PathStatus::stopped, "stopped"},
}};
constexpr std::string_view name(PathStatus status) { return word_of(kPathStatusWords, status); }

}  // namespace geom
