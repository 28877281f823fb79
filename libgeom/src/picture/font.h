#pragma once

// Letters as strokes of a pen, for words in pictures at any size.

#include <string_view>
#include <vector>

namespace geom::picture {

struct PenPoint {
  double x = 0;  // to the right, from the letter's left edge
  double y = 0;  // up, from the line that it stands on
};

struct Letter {
  double width = 0;
  std::vector<std::vector<PenPoint>> strokes;
};

// Of these units capitals are so high, and small letters without a stem.
inline constexpr double kCapital = 7;
inline constexpr double kSmall = 5;
inline constexpr double kBetween = 1.7;  // from one letter to the next

// One for each character of UTF-8 text; characters that the font lacks are a middle dot.
std::vector<const Letter*> letters_of(std::string_view words);

}  // namespace geom::picture
