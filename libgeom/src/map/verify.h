#pragma once

// Holds what a map's file says of itself against what it holds.

#include "box_map_data.h"

namespace geom {

// Each throws InputError at the first that is wrong, by the lowest index, whatever the threads, and
// keeps little of the file in memory. Verified says what they look at; the contents take it that
// the extents are verified.
void verify_extents(const BoxMap::Data& data, const Execution& run);
void verify_contents(const BoxMap::Data& data, const Execution& run);

}  // namespace geom
