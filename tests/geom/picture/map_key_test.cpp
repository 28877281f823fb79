// What makes a picture a map: the grid, the marks, the bar of the scale.

#include "picture/map_key.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "picture/drawn.h"
#include "support/small_map.h"

namespace {

using geom::Aabb;
using geom::picture::Colour;
using geom::picture::Picture;

TEST(LengthWords, SayMetresAndKilometres) {
  EXPECT_EQ(geom::picture::length_words(250), "250 m");
  EXPECT_EQ(geom::picture::length_words(2000), "2 km");
  EXPECT_EQ(geom::picture::length_words(0.05), "0.05 m");
}

// The bar of a plan: as long as it says, in the picture's pixels.
TEST(MapKey, TheBarIsAsLongAsItSays) {
  const Aabb ground{{0, 0, 0}, {1000, 1000, 50}};
  const geom::picture::View view = geom::picture::plan_view(ground, 960, 960);
  Picture picture{960, 960, std::vector<Colour>(960 * 960, Colour{90, 90, 90}), {}, {}};
  geom::picture::draw_map_key(picture, view, {ground, geom::picture::grid_lines(ground), false});
  int longest = 0;  // run of dark pixels
  for (int y = 800; y < 960; ++y) {
    int run = 0;
    for (int x = 0; x < 480; ++x) {
      run = picture.colour[static_cast<std::size_t>(y * 960 + x)].r < 60 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  EXPECT_NEAR(longest, 200 * view.fx, 6);  // 200 m
}

TEST(MapKey, StandsInItsBandAndLeavesTheMap) {
  const Aabb ground{{0, 0, 0}, {1000, 1000, 50}};
  const int band = geom::picture::key_band(960, 960);
  EXPECT_GT(band, 0);
  Picture picture{960, 960, std::vector<Colour>(960 * 960, Colour{90, 90, 90}), {}, {}};
  geom::picture::draw_map_key(picture, geom::picture::plan_view(ground, 960, 960 - band),
                              {ground, geom::picture::grid_lines(ground), true});
  const auto grey = std::find_if(picture.colour.begin(), picture.colour.end(), [](const Colour& c) {
    return c != Colour{90, 90, 90};
  });
  EXPECT_EQ((grey - picture.colour.begin()) / 960, 960 - band);
}

// Pixels of letters and marks of ways from one start, with these ids.
std::ptrdiff_t dark_pixels(const std::vector<std::string>& ids) {
  const Aabb ground{{0, 0, 0}, {1000, 1000, 50}};
  Picture picture{960, 960, std::vector<Colour>(960 * 960, Colour{255, 255, 255}), {}, {}};
  std::vector<geom::picture::Line> lines;
  for (const std::string& id : ids) {
    lines.push_back({{{500, 500, 5}, {500, 500, 5}}, {}, 3, true, id});
  }
  const geom::BoxMap map = support::map_of(ground, {{{0, 0, 0}, {1, 1, 1}}});
  geom::picture::draw_ends(picture, geom::picture::plan_view(ground, 960, 960),
                           geom::picture::PictureScene(map, {}), lines);
  return std::count_if(picture.colour.begin(), picture.colour.end(),
                       [](const Colour& c) { return c.r < 60; });
}

TEST(MapKey, NamesOfWaysFromOneStartAreAllRead) {
  const std::ptrdiff_t marks = dark_pixels({""});
  const std::ptrdiff_t east = dark_pixels({"east"}) - marks;
  const std::ptrdiff_t west = dark_pixels({"west"}) - marks;
  EXPECT_GT(east, 20);
  EXPECT_EQ(dark_pixels({"east", "west"}) - marks, east + west);
  EXPECT_EQ(dark_pixels({"east", "east"}) - marks, east) << "a path and its trajectory";
  EXPECT_EQ(dark_pixels({"east", "west", "east", "west"}) - marks, east + west);
}

TEST(MapKey, LettersAreAsWideAsTheyAreDrawn) {
  for (const char* words : {"grid 100 m, fine 10 m", "Wiesn-7", "a", "\u00fcber"}) {
    Picture picture{400, 40, std::vector<Colour>(400 * 40, Colour{255, 255, 255}), {}, {}};
    geom::picture::draw_text(picture, {10, 12}, words, {2, {0, 0, 0}});
    int first = 400;
    int last = 0;
    for (int i = 0; i < 400 * 40; ++i) {
      if (picture.colour[static_cast<std::size_t>(i)].r > 128) continue;
      first = std::min(first, i % 400);
      last = std::max(last, i % 400);
    }
    EXPECT_NEAR(first, 10, 3) << words;
    EXPECT_NEAR(last, 10 + geom::picture::text_width(words, 2), 3) << words;
  }
}

TEST(Marks, ADotWithinARingIsSeenAndSoIsTheRing) {
  Picture picture{40, 40, std::vector<Colour>(40 * 40, Colour{200, 60, 60}), {}, {}};
  geom::picture::draw_start(picture, {20, 20}, 1);
  geom::picture::draw_goal(picture, {20, 20}, 1);
  const auto at = [&](int x) { return picture.colour[static_cast<std::size_t>(20 * 40 + x)]; };
  EXPECT_LT(at(20).r, 60);   // the dot
  EXPECT_GT(at(24).g, 200);  // white between
  EXPECT_LT(at(26).r, 130);  // the ring
}

TEST(MapKey, IsLeftOutOfASmallPicture) {
  const Aabb ground{{0, 0, 0}, {1000, 1000, 50}};
  Picture picture{200, 150, std::vector<Colour>(200 * 150, Colour{90, 90, 90}), {}, {}};
  const Picture before = picture;
  geom::picture::draw_map_key(picture, geom::picture::plan_view(ground, 200, 150),
                              {ground, geom::picture::grid_lines(ground), true});
  EXPECT_EQ(picture.colour, before.colour);
}

}  // namespace
