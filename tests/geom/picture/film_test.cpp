// Maps from outside: what hides the room or lies before a flight does not hide it.

#include "geom/picture/film.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace {

using geom::picture::Colour;
using geom::picture::Picture;

std::size_t pixels_like(const Picture& picture, const Colour& colour, int within) {
  std::size_t out = 0;
  for (const Colour& c : picture.colour) {
    const int off = std::abs(c.r - colour.r) + std::abs(c.g - colour.g) + std::abs(c.b - colour.b);
    out += off <= within;
  }
  return out;
}

Picture overview_of(const geom::BoxMap& map) {
  const geom::picture::Line way{{{1, 2, 1}, {7, 2, 1}}, {0, 114, 178}, 3, true, "a"};
  geom::picture::FilmOptions options;
  options.kind = geom::picture::FilmKind::overview;
  options.width = options.height = 320;
  const geom::picture::Film film(map, {{way}}, options);
  return film.frames({std::nullopt})[0];
}

geom::BoxMap room(const std::vector<geom::Aabb>& boxes, const char* bounds_from) {
  return {{.bounds = {{0, 0, 0}, {8, 6, 3}}, .bounds_from = bounds_from}, support::table_of(boxes)};
}

TEST(Film, CutsAwayTheWallsThatHideARoom) {
  const std::vector<geom::Aabb> walls = {{{0, 0, 0}, {0.1, 6, 3}}, {{0, 0, 0}, {8, 0.1, 3}}};
  const std::size_t open = pixels_like(overview_of(room({}, "option")), {0, 114, 178}, 60);
  const std::size_t cut = pixels_like(overview_of(room(walls, "option")), {0, 114, 178}, 60);
  const std::size_t city = pixels_like(overview_of(room(walls, "obstacles")), {0, 114, 178}, 60);
  EXPECT_GT(open, 300u);
  EXPECT_NEAR(static_cast<double>(cut), static_cast<double>(open), 0.1 * static_cast<double>(open));
  EXPECT_LT(city, open / 2) << "a city's walls are buildings";
}

TEST(Film, DrawsAFlightFaintlyBehindATower) {
  const std::vector<geom::Aabb> tower = {{{2, 0.5, 0}, {6, 1.2, 3}}};
  const Picture with = overview_of(room(tower, "obstacles"));
  const Picture without = overview_of(room({}, "obstacles"));
  // Where the flight was seen there is more blue than red even behind the tower.
  std::size_t lost = 0;
  std::size_t line = 0;
  for (std::size_t i = 0; i < with.colour.size(); ++i) {
    const Colour& before = without.colour[i];
    if (before.b < before.r + 100) continue;
    ++line;
    lost += with.colour[i].b < with.colour[i].r + 15;
  }
  EXPECT_GT(line, 300u);
  EXPECT_LT(lost, line / 10);
}

TEST(Film, LetsAFlightInAKeepOutVolumeBeSeen) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {8, 6, 3}};
  spec.bounds_from = "obstacles";
  geom::BoxTable table = support::table_of({{{0.5, 0.5, 0}, {7.5, 5.5, 2.5}}});
  table.labels = {"", "keep-out: yard"};
  table.label = {1};
  const std::size_t open = pixels_like(overview_of(room({}, "obstacles")), {0, 114, 178}, 60);
  const std::size_t zone = pixels_like(overview_of(geom::BoxMap(spec, table)), {0, 114, 178}, 60);
  EXPECT_GT(zone, open * 8 / 10);
}

}  // namespace
