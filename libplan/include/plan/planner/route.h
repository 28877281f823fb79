#pragma once

// Which search a path came from, as records name it.
//
// Example:
//   assert(plan::name(plan::OwnRoute::lattice) == "lattice");

#include <string_view>
#include <variant>

#include "geom/text/words.h"
#include "plan/sampling/rrt.h"

namespace plan {

// A step of the recipe of kAutomatic (plan.h), or A* alone.
enum class OwnRoute {
  straight,  // the line between both ends
  chain,     // over or round what stands on that line, within half a plane
  roadmap,
  corridor,  // the bends that a path shorter than a known one may use
  lattice,
  cells  // the chain of free cells that shows that there is a way, or that there is none
};
inline constexpr geom::Words<OwnRoute, 6> kOwnRouteWords{{
    {OwnRoute::straight, "straight"},
    {OwnRoute::chain, "chain"},
    {OwnRoute::roadmap, "roadmap"},
    {OwnRoute::corridor, "corridor"},
    {OwnRoute::lattice, "lattice"},
    {OwnRoute::cells, "cells"},
}};

using Route = std::variant<OwnRoute, SamplingMethod>;
inline constexpr auto kRouteWords = geom::joined<Route>(kOwnRouteWords, kSamplingWords);
constexpr std::string_view name(Route route) { return geom::word_of(kRouteWords, route); }

}  // namespace plan
