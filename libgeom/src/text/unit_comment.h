#pragma once

// Units of length that models name in words that no format knows.

#include <optional>
#include <string_view>

namespace geom {

// The metres in the unit that a comment names, as "File units = inches" of SketchUp, "Units: mm" or
// "UNITS=mm" do. Nothing if it names none of the usual ones.
std::optional<double> unit_of_comment(std::string_view comment);

}  // namespace geom
