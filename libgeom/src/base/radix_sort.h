#pragma once

// Millions of whole numbers sorted by counting, without comparing any two.

#include <cstdint>

#include "geom/base/execution.h"
#include "large_array.h"

namespace geom {

// Number: std::uint32_t or std::uint64_t.
template <class Number>
struct Keyed {
  Number key;
  Number item;  // what the key is of
};

// By key, and items of one key in the order that they had. No key is above `largest`. Takes time
// and memory in proportion to the number of items, for each 11 bits of the largest key.
template <class Number>
LargeArray<Keyed<Number>> radix_sorted(LargeArray<Keyed<Number>> items, std::uint64_t largest,
                                       const Execution& run);

}  // namespace geom
