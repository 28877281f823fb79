#include "geom/picture/line.h"

#include <string_view>
#include <utility>

#include "geom/figure/palette.h"

namespace geom::picture {
namespace {

constexpr Colour kTrees[] = {{86, 140, 196}, {150, 110, 180}};

constexpr std::uint8_t digit(char c) {
  return static_cast<std::uint8_t>(c <= '9' ? c - '0' : c - 'a' + 10);
}

// Of "#rrggbb".
constexpr Colour colour_of(std::string_view hex) {
  const auto part = [&](std::size_t at) {
    return static_cast<std::uint8_t>(16 * digit(hex[at]) + digit(hex[at + 1]));
  };
  return {part(1), part(3), part(5)};
}

}  // namespace

Line way_line(std::size_t i, std::string id, std::vector<Vec3> points) {
  return {std::move(points), colour_of(figure::colour(i)), 3, true, std::move(id)};
}

Line tree_line(std::size_t tree, const Vec3& a, const Vec3& b) {
  return {{a, b}, kTrees[tree], 1.2, false, ""};
}

}  // namespace geom::picture
