#pragma once

// The names that a text of points gives its columns, and which of them are x, y and z.

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace geom {

// Where x (east), y (north) and z (up) stand among the fields of a line.
struct XyzColumns {
  std::array<std::size_t, 3> of_axis = {0, 1, 2};
  std::size_t count = 0;  // of names; 0: the file has none

  bool operator==(const XyzColumns&) const = default;
};

// Where a text stands, for messages.
struct TextPlace {
  std::string_view source;
  std::size_t line = 0;
};

// Names are "x", "Y [m]", "Northing", "elevation" and the like; columns of other names may stand
// between them. Where columns are called x, y and z, these are taken, whatever others are called.
// Throws InputError(source, line, …) where an axis has no column or two, and where one of the three
// is in degrees, in another unit than metres, or counts downward.
XyzColumns xyz_columns(std::span<const std::string_view> names, const TextPlace& place);

// Whether words name something for each of the three axes, in whatever unit: a comment of such
// words may be a header.
bool name_all_axes(std::span<const std::string_view> words);

// Splits a line at each `separator`, blanks at the ends of fields removed; at runs of blanks where
// it is ' '.
void fields_of(char separator, std::string_view line, std::vector<std::string_view>& fields);

// What stands behind the first number of a line; where it begins with a word, the first of these
// that the line has: a semicolon, a comma, a tab, or blanks.
char separator_of(std::string_view line);
std::string_view name_of_separator(char separator);

}  // namespace geom
