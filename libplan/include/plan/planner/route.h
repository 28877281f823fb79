#pragma once

// Which search a path came from, as records name it.
//
// Example:
//   assert(plan::name(plan::Route::lattice) == "lattice");

#include <string_view>

#include "geom/text/words.h"

namespace plan {

enum class Route {
  straight,  // the line between both ends
  roadmap,
  corridor,  // the bends near a lattice's path
  lattice,
  cells,  // the chain of free cells that shows that there is a way, or that there is none
  rrt,
  rrt_connect,
  rrt_star,
  informed_rrt_star
};
inline constexpr geom::Words<Route, 9> kRouteWords{{
    {Route::straight, "straight"},
    {Route::roadmap, "roadmap"},
    {Route::corridor, "corridor"},
    {Route::lattice, "lattice"},
    {Route::cells, "cells"},
    {Route::rrt, "rrt"},
    {Route::rrt_connect, "rrt-connect"},
    {Route::rrt_star, "rrt-star"},
    {Route::informed_rrt_star, "informed-rrt-star"},
}};
constexpr std::string_view name(Route route) { return geom::word_of(kRouteWords, route); }

}  // namespace plan
