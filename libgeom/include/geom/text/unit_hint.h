#pragma once

// What to write in place of a number that has a unit or a decimal comma.
//
// Example:
//   const std::string hint = geom::unit_hint("500mm", "margin, metres");
//   assert(hint == "; give metres without the unit, 0.5");

#include <string>
#include <string_view>

namespace geom {

// What to add to a refusal of `text` where a number was expected. "500mm" gives "; give metres
// without the unit, 0.5", "0,5" gives "; write 0.5", and a text that is neither gives nothing.
// `description` names the unit of the number, as the help text of an option does; to a unit of
// another kind the hint is only to give the number alone.
std::string unit_hint(std::string_view text, std::string_view description);

}  // namespace geom
