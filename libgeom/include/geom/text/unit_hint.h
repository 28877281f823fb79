#pragma once

// What to write in place of a number that has a unit or a decimal comma.
//
// Example:
//   const std::string hint = geom::unit_hint("500mm", "margin, metres");
//   assert(hint == "; give metres without the unit, 0.5");

#include <string>
#include <string_view>

namespace geom {

// What to add to a refusal of `text` where a number was expected: "; give metres without the unit,
// 0.5" of "500mm", "; write 0.5" of "0,5", else nothing. `description` is that of the number, whose
// unit it names: to a unit of another kind only "give the number alone" is said.
std::string unit_hint(std::string_view text, std::string_view description);

}  // namespace geom
