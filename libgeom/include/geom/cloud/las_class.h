#pragma once

// The classes of LAS points by name: ASPRS, LAS 1.4 R15, tables 9 and 17.
//
// Example:
//   assert(geom::las_classes("ground")[0] == geom::kGroundClass);
//   assert(geom::las_classes("vegetation").size() == 3);
//   assert(geom::is_noise_class(7));

#include <bitset>
#include <cstdint>
#include <span>
#include <string_view>

namespace geom {

// The numbers of a class, or of a group of them: "ground" is 2; "vegetation" 3, 4 and 5; "noise" 7
// and 18; "wire" 13, 14 and 16. Empty for another word.
std::span<const std::uint8_t> las_classes(std::string_view name);

// The classes that a word means: a name as above, or a number from 0 to 255. None for another word.
std::bitset<256> las_class_set(std::string_view word);

// All names, for messages: "bridge, building, …".
std::string_view las_class_names();

constexpr std::uint8_t kGroundClass = 2;

// Whether points of this class are said to be no return of anything that stands there.
constexpr bool is_noise_class(std::uint8_t cls) { return cls == 7 || cls == 18; }

}  // namespace geom
