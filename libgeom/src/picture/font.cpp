#include "font.h"

#include <array>
#include <cmath>

#include "geom/base/text_stream.h"

namespace geom::picture {
namespace {

// What the pen does: "M x y" puts it down, "L x y" draws a line, "A x y rx ry from to" an arc
// around (x, y) between two angles in degrees, from wherever it stands.
struct Drawn {
  char character;
  double width;
  const char* pen;
};

constexpr Drawn kDrawn[] = {
    {'a', 4, "A 2 2.5 2 2.5 0 360 M 4 5 L 4 0"},
    {'b', 4, "M 0 7 L 0 0 M 4 2.5 A 2 2.5 2 2.5 0 360"},
    {'c', 3.5, "A 2 2.5 2 2.5 48 312"},
    {'d', 4, "A 2 2.5 2 2.5 0 360 M 4 7 L 4 0"},
    {'e', 4, "M 0 2.6 L 4 2.6 A 2 2.5 2 2.5 2 312"},
    {'f', 2.7, "A 2.3 5.7 1.4 1.3 50 180 L 0.9 0 M 0 4.8 L 2.5 4.8"},
    {'g', 4, "A 2 2.5 2 2.5 0 360 M 4 5 L 4 -0.2 A 2 -0.2 2 1.8 0 -148"},
    {'h', 4, "M 0 7 L 0 0 M 0 3 A 2 3 2 2 180 0 L 4 0"},
    {'i', 0.4, "M 0.2 5 L 0.2 0 M 0.2 6.8 L 0.2 6.9"},
    {'j', 1.3, "M 1.1 5 L 1.1 -0.8 A -0.1 -0.8 1.2 1.1 0 -95 M 1.1 6.8 L 1.1 6.9"},
    {'k', 3.6, "M 0 7 L 0 0 M 3.4 5 L 0 1.9 M 1.2 3 L 3.6 0"},
    {'l', 0.4, "M 0.2 7 L 0.2 0"},
    {'m', 6.2,
     "M 0 5 L 0 0 M 0 3.4 A 1.55 3.4 1.55 1.6 180 0 L 3.1 0 M 3.1 3.4 A 4.65 3.4 1.55 1.6 180 0 L "
     "6.2 0"},
    {'n', 4, "M 0 5 L 0 0 M 0 3 A 2 3 2 2 180 0 L 4 0"},
    {'o', 4, "A 2 2.5 2 2.5 0 360"},
    {'p', 4, "M 0 5 L 0 -2 M 4 2.5 A 2 2.5 2 2.5 0 360"},
    {'q', 4, "A 2 2.5 2 2.5 0 360 M 4 5 L 4 -2"},
    {'r', 2.4, "M 0 5 L 0 0 M 0 3.2 A 1.8 3.2 1.8 1.8 180 65"},
    {'s', 3.3, "A 1.65 3.72 1.45 1.28 35 270 A 1.65 1.22 1.6 1.22 90 -145"},
    {'t', 2.7, "M 1 6.7 L 1 1.3 A 2.3 1.3 1.3 1.3 180 285 M 0 4.8 L 2.5 4.8"},
    {'u', 4, "M 0 5 L 0 2 A 2 2 2 2 180 360 M 4 5 L 4 0"},
    {'v', 3.8, "M 0 5 L 1.9 0 L 3.8 5"},
    {'w', 5.8, "M 0 5 L 1.5 0 L 2.9 4.8 L 4.3 0 L 5.8 5"},
    {'x', 3.7, "M 0 5 L 3.7 0 M 3.7 5 L 0 0"},
    {'y', 3.8, "M 0 5 L 1.9 0.2 M 3.8 5 L 1.5 -1 L 0.9 -1.8 L 0.2 -2"},
    {'z', 3.6, "M 0.1 5 L 3.5 5 L 0 0 L 3.6 0"},
    {'0', 4, "A 2 3.5 2 3.5 0 360"},
    {'1', 4, "M 0.7 5.6 L 2.3 7 L 2.3 0 M 0.7 0 L 3.9 0"},
    {'2', 4, "A 2 5.1 1.85 1.9 160 -38 L 0.1 0 L 4 0"},
    {'3', 4, "A 1.9 5.2 1.7 1.8 145 -90 A 1.9 1.7 2 1.7 90 -150"},
    {'4', 4, "M 3.1 0 L 3.1 7 L 0 2 L 4.1 2"},
    {'5', 4, "M 3.6 7 L 0.7 7 L 0.4 3.9 A 1.9 2.2 2 2.2 128 -145"},
    {'6', 4, "A 2 2.15 2 2.15 0 360 M 0 2.3 A 3.7 2.3 3.7 4.7 180 103"},
    {'7', 4, "M 0.1 7 L 4 7 L 1.4 0"},
    {'8', 4, "A 2 5.25 1.7 1.75 0 360 M 4 1.75 A 2 1.75 2 1.75 0 360"},
    {'9', 4, "A 2 4.85 2 2.15 0 360 M 4 4.7 A 0.3 4.7 3.7 4.7 0 -77"},
    {'A', 5, "M 0 0 L 2.5 7 L 5 0 M 0.85 2.4 L 4.15 2.4"},
    {'B', 4.4,
     "M 0 3.7 L 2.4 3.7 A 2.4 5.35 1.7 1.65 -90 90 L 0 7 L 0 0 L 2.5 0 A 2.5 1.85 1.9 1.85 -90 90"},
    {'C', 5, "A 2.9 3.5 2.9 3.5 48 312"},
    {'D', 4.8, "M 0 0 L 0 7 L 1.8 7 A 1.8 3.5 3 3.5 90 -90 L 0 0"},
    {'E', 3.9, "M 3.9 7 L 0 7 L 0 0 L 3.9 0 M 0 3.7 L 3.4 3.7"},
    {'F', 3.7, "M 3.7 7 L 0 7 L 0 0 M 0 3.7 L 3.2 3.7"},
    {'G', 5.4, "A 2.9 3.5 2.9 3.5 48 340 L 5.6 3.3 L 3.4 3.3"},
    {'H', 4.6, "M 0 0 L 0 7 M 4.6 0 L 4.6 7 M 0 3.7 L 4.6 3.7"},
    {'I', 0.4, "M 0.2 0 L 0.2 7"},
    {'J', 2.8, "M 2.7 7 L 2.7 1.8 A 1.2 1.8 1.5 1.8 0 -140"},
    {'K', 4.3, "M 0 0 L 0 7 M 4.1 7 L 0 2.7 M 1.6 4.3 L 4.3 0"},
    {'L', 3.7, "M 0 7 L 0 0 L 3.7 0"},
    {'M', 5.6, "M 0 0 L 0 7 L 2.8 2 L 5.6 7 L 5.6 0"},
    {'N', 4.6, "M 0 0 L 0 7 L 4.6 0 L 4.6 7"},
    {'O', 5.8, "A 2.9 3.5 2.9 3.5 0 360"},
    {'P', 4.3, "M 0 0 L 0 7 L 2.4 7 A 2.4 5.2 1.9 1.8 90 -90 L 0 3.4"},
    {'Q', 5.8, "A 2.9 3.5 2.9 3.5 0 360 M 3.6 1.6 L 5.6 -0.6"},
    {'R', 4.4, "M 0 0 L 0 7 L 2.4 7 A 2.4 5.2 1.9 1.8 90 -90 L 0 3.4 M 2.4 3.4 L 4.4 0"},
    {'S', 4.3, "A 2.2 5.25 1.9 1.75 35 270 A 2.2 1.75 2.1 1.75 90 -150"},
    {'T', 4.8, "M 0 7 L 4.8 7 M 2.4 7 L 2.4 0"},
    {'U', 4.6, "M 0 7 L 0 2.3 A 2.3 2.3 2.3 2.3 180 360 L 4.6 7"},
    {'V', 5, "M 0 7 L 2.5 0 L 5 7"},
    {'W', 7.2, "M 0 7 L 1.8 0 L 3.6 6.8 L 5.4 0 L 7.2 7"},
    {'X', 4.6, "M 0 7 L 4.6 0 M 4.6 7 L 0 0"},
    {'Y', 4.8, "M 0 7 L 2.4 3.2 L 4.8 7 M 2.4 3.2 L 2.4 0"},
    {'Z', 4.6, "M 0.1 7 L 4.5 7 L 0 0 L 4.6 0"},
    {' ', 1.2, ""},
    {'.', 0.5, "M 0.25 0 L 0.25 0.15"},
    {',', 0.7, "M 0.5 0.2 L 0.1 -1.2"},
    {':', 0.5, "M 0.25 0 L 0.25 0.15 M 0.25 3.9 L 0.25 4.05"},
    {';', 0.7, "M 0.5 0.2 L 0.1 -1.2 M 0.5 3.9 L 0.5 4.05"},
    {'-', 2.4, "M 0 2.7 L 2.4 2.7"},
    {'_', 4, "M 0 -1 L 4 -1"},
    {'+', 3.6, "M 0 2.7 L 3.6 2.7 M 1.8 4.5 L 1.8 0.9"},
    {'=', 3.4, "M 0 3.5 L 3.4 3.5 M 0 1.9 L 3.4 1.9"},
    {'/', 2.8, "M 0 -1 L 2.8 7.4"},
    {'(', 1.6, "A 3.4 3 3.4 5 122 238"},
    {')', 1.6, "A -1.8 3 3.4 5 58 -58"},
    {'#', 4.4, "M 1.2 0 L 1.9 7 M 2.9 0 L 3.6 7 M 0.2 4.8 L 4.4 4.8 M 0 2.3 L 4.2 2.3"},
    {'%', 5.6, "A 1.2 5.5 1.2 1.5 0 360 M 5.6 1.5 A 4.4 1.5 1.2 1.5 0 360 M 4.5 7 L 1.1 0"},
    {'\0', 1, "M 0.5 2.6 L 0.5 2.75"},  // what the font lacks
};

void draw_arc(TextInput& pen, std::vector<PenPoint>& stroke) {
  double x = 0;
  double y = 0;
  double rx = 0;
  double ry = 0;
  double from = 0;
  double to = 0;
  pen >> x >> y >> rx >> ry >> from >> to;
  constexpr int kSteps = 24;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = (from + (to - from) * i / kSteps) * 0.017453292519943295;
    stroke.push_back({x + rx * std::cos(angle), y + ry * std::sin(angle)});
  }
}

Letter letter_of(const Drawn& drawn) {
  Letter out{drawn.width, {{}}};
  TextInput pen(drawn.pen);
  for (char move = 0; pen >> move;) {
    if (move == 'A') {
      draw_arc(pen, out.strokes.back());
      continue;
    }
    if (move == 'M' && !out.strokes.back().empty()) out.strokes.emplace_back();
    PenPoint at;
    pen >> at.x >> at.y;
    out.strokes.back().push_back(at);
  }
  return out;
}

std::array<Letter, 256> alphabet() {
  std::array<Letter, 256> out;
  out.fill(letter_of(kDrawn[std::size(kDrawn) - 1]));
  for (const Drawn& drawn : kDrawn) {
    out[static_cast<unsigned char>(drawn.character)] = letter_of(drawn);
  }
  return out;
}

}  // namespace

std::vector<const Letter*> letters_of(std::string_view words) {
  static const std::array<Letter, 256> letters = alphabet();
  std::vector<const Letter*> out;
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0) != 0x80) out.push_back(&letters[byte]);  // not within a character of UTF-8
  }
  return out;
}

}  // namespace geom::picture
