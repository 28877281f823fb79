#pragma once

// Numbers that were given with a unit, or with a decimal comma.

#include <string>
#include <string_view>

namespace cli {

// What to add to a refusal of `text` where a number was expected: "; give metres without the unit,
// 0.5" of "500mm", "; write 0.5" of "0,5", else nothing. `description` is the option's own, whose
// unit it names: to a unit of another kind only "give the number alone" is said.
std::string unit_hint(std::string_view text, std::string_view description);

}  // namespace cli
