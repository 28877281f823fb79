#include "geom/gis/footprint_source.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"

namespace geom::gis {
namespace {

Source with(std::size_t given, std::size_t by_default) {
  Source source;
  if (given > 0) source.counts["heights_given"] = given;
  if (by_default > 0) source.counts["heights_by_default"] = by_default;
  return source;
}

TEST(HeightsFault, LetsATenthGoByDefault) {
  EXPECT_EQ(heights_fault(with(9, 1)), "");
  EXPECT_EQ(heights_fault(with(9, 0)), "");
  EXPECT_EQ(heights_fault({}), "");
  EXPECT_NE(heights_fault(with(8, 1)), "");
  EXPECT_NE(heights_fault(with(0, 1)), "");
}

TEST(HeightsFault, CountsAllThatHaveAHeight) {
  Source source = with(3, 1);
  source.counts["heights_from_levels"] = 3;
  source.counts["heights_from_corners"] = 3;
  EXPECT_EQ(heights_fault(source), "");
  source.counts["heights_from_corners"] = 2;
  EXPECT_NE(heights_fault(source), "");
}

TEST(HeightsFault, NamesTheNumbersThatMostHave) {
  Source source = with(0, 2);
  note_attribute("use", "flats", source);
  note_attribute("floor area", " 90 ", source);
  note_attribute("h_max", "31.5", source);
  note_attribute("h_max", "12", source);
  note_attribute("h_max", "nan", source);
  const std::string text = heights_fault(source);
  EXPECT_TRUE(support::says(text, "\"h_max\" (12 to 31.5, in 2), \"floor area\" (90 to 90, in 1)"));
  EXPECT_FALSE(support::says(text, "flats"));
}

TEST(LabelOf, NumbersEachLabelOnce) {
  Source source;
  ReadOptions options;
  EXPECT_EQ(label_of("Building", "A", options, source), 1u);
  EXPECT_EQ(label_of("Road", "B", options, source), 2u);
  EXPECT_EQ(label_of("Building", "C", options, source), 1u);
  options.label_by = LabelBy::object;
  EXPECT_EQ(label_of("Building", "C", options, source), 3u);
  EXPECT_EQ(source.labels.at("Building: C"), 3u);
}

TEST(RequireTypes, NamesTheTypesOfTheFile) {
  ReadOptions options;
  options.types = {"Building"};
  require_types({{"Building", 3}, {"Road", 1}}, options, "city");
  options.types = {"Buildings"};
  EXPECT_EQ(support::refusal_of([&] {
              require_types({{"Building", 3}, {"Road", 1}}, options, "city");
            }),
            "city: expected types of the file in --types: Building (3), Road (1), found "
            "\"Buildings\"");
}

TEST(CountHeight, NamesWhatIsNotUnderstood) {
  Source source;
  geom::BuildingHeight height;
  height.junk = height.unread = true;
  count_height(height, "way 7", source);
  EXPECT_EQ(source.counts["heights_by_default"], 1u);
  EXPECT_EQ(source.counts["heights_not_understood"], 1u);
  EXPECT_TRUE(support::says(source.skipped.text(), "way 7"));
}

}  // namespace
}  // namespace geom::gis
