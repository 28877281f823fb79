#include "geom/import/fcnd_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "geom/base/error.h"
#include "support/built_and_skipped.h"
#include "support/reading.h"

namespace geom {
namespace {

const std::string kHeader = "posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n";

FcndTable fcnd(const std::string& text) { return read_fcnd_csv(support::Text(text), "t.csv"); }

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { fcnd(text); });
}

TEST(FcndCsv, ReadsEveryHeaderVariant) {
  const std::string row = "1,2,3,1,1,3\n";
  for (const std::string& head :
       {std::string(), kHeader, "lat0 37.5, lon0 -122.25\n" + kHeader,
        "37.5,-122.25,,,,\n" + kHeader, "lat0 37.5 lon0 -122.25\n" + kHeader,
        "lat0 37.5, lon0 -122.25, lat1 37.6, lon1 -122.5\n" + kHeader, "37.5 -122.25\n" + kHeader,
        "lat0, 37.5, lon0, -122.25\n" + kHeader, "lat0,lon0\n37.5,-122.25\n" + kHeader}) {
    const FcndTable t = fcnd(head + row);
    ASSERT_EQ(t.table.boxes.size(), 1u) << head;
    EXPECT_EQ(t.table.boxes[0], (Aabb{{0, 1, 0}, {2, 3, 6}})) << head;
    if (head.find("37.5") != std::string::npos) {
      ASSERT_TRUE(t.origin) << head;
      EXPECT_EQ(t.origin->longitude, -122.25);
    }
  }
}

// Long enough for many blocks of lines.
std::string long_table(std::size_t rows) {
  std::string text = "lat0 37.5, lon0 -122.25\n" + kHeader;
  for (std::size_t i = 0; i < rows; ++i) {
    text += i % 7 == 0   ? std::to_string(i) + " , 2 ,3.5, 1,1 ,0\n"
            : i % 7 == 1 ? "\n-0.1;" + std::to_string(i) + ";+3e1;.5;1;1.000000000000000001\r\n"
                         : std::to_string(i) + ".25,-20776.993,2.6355,4.2575,11.007,2.6355\n";
  }
  return text;
}

FcndTable fcnd(const std::string& text, unsigned threads) {
  return read_fcnd_csv(support::Text(text), "t.csv", {threads, {}}, text.size());
}

TEST(FcndCsv, IsTheSameForAnyNumberOfThreads) {
  const std::string text = long_table(60000);
  const FcndTable one = fcnd(text, 1);
  ASSERT_EQ(one.table.boxes.size(), 60000u);
  EXPECT_EQ(one.table.boxes[1].max.z(), 31);  // of the rows with semicolons
  EXPECT_EQ(one.table.ids[0], 3u);
  EXPECT_EQ(one.table.ids.back(), 2u + 60000 + (60000 + 5) / 7);  // and the blank lines
  EXPECT_EQ(one.flat, (60000u + 6) / 7);
  for (const unsigned threads : {2u, 7u}) {
    const FcndTable other = fcnd(text, threads);
    EXPECT_TRUE(other.table.boxes == one.table.boxes);
    EXPECT_EQ(other.table.ids, one.table.ids);
    EXPECT_EQ(other.table.label, one.table.label);
    EXPECT_EQ(other.flat, one.flat);
    EXPECT_EQ(other.largest_change, one.largest_change);
  }
}

TEST(FcndCsv, RefusesTheFirstBadLineForAnyNumberOfThreads) {
  const std::string good = long_table(30000);
  const auto lines = static_cast<std::size_t>(std::count(good.begin(), good.end(), '\n'));
  const std::string text =
      good + "1,2,3,1,-1,3\n" + good.substr(good.find('\n', 200) + 1) + "west\n";
  for (const unsigned threads : {1u, 2u, 7u}) {
    try {
      fcnd(text, threads);
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.line(), lines + 1);
      EXPECT_EQ(error.fault().key, "half size y");
    }
  }
}

TEST(FcndCsv, RefusesALineThatNamesTwoOriginsOrHalfOfOne) {
  for (const char* head :
       {"lat0 37.5, lon0 -122.25, lat0 38, lon0 -121\n", "lat0 37.5, lat1 38, lon1 -121\n",
        "lat0 37.5, lon0\n", "lat0 37.5, lon0 west\n", "37.5, -122.25, 10\n"}) {
    EXPECT_NE(refusal(std::string(head) + kHeader + "1,2,3,1,1,3\n"), "") << head;
  }
}

TEST(FcndCsv, TakesColumnsByNameInAnyOrder) {
  const FcndTable t = fcnd("halfSizeZ,posX,note,posY,posZ,halfSizeX,halfSizeY\n3,1,tree,2,3,1,1\n");
  EXPECT_EQ(t.table.boxes[0], (Aabb{{0, 1, 0}, {2, 3, 6}}));
}

TEST(FcndCsv, RoundsOutward) {
  const FcndTable t = fcnd("0.1,0.2,0.3,0.7,0.1,0.3\n");
  const Aabb& box = t.table.boxes[0];
  EXPECT_LE(box.min.x(), 0.1 - 0.7);
  EXPECT_GE(box.max.z(), 0.6);
  EXPECT_GT(t.largest_change, 0);
  EXPECT_LT(t.largest_change, 1e-12);
}

TEST(FcndCsv, NamesLineExpectationAndFinding) {
  EXPECT_EQ(refusal(""), "t.csv: expected an FCND table, found an empty file");
  EXPECT_EQ(refusal(kHeader), "t.csv:1: expected at least one box after the header, found none");
  EXPECT_EQ(refusal(kHeader + "1,2,3,1,-2,1\n"), "t.csv:2: half size y must be >= 0, found \"-2\"");
  EXPECT_EQ(refusal(kHeader + "1,x,3,1,2,1\n"),
            "t.csv:2: position y must be a finite number within 1e8 m, found \"x\"");
  EXPECT_TRUE(support::says(refusal(kHeader + "1,2,3,1,2\n"), "expected 6 fields, found 5"));
  EXPECT_TRUE(support::says(refusal(kHeader + "1,nan,3,1,2,1\n"), "found \"nan\""));
  EXPECT_TRUE(support::says(refusal(kHeader + "1,1e999,3,1,2,1\n"), "found \"1e999\""));
  EXPECT_TRUE(support::says(refusal("37.7,-122.3,0,0,0,0\n"), "three zeros"));
  EXPECT_TRUE(support::says(refusal("lat0 137, lon0 0\n" + kHeader), "latitude"));
}

TEST(FcndCsv, KeepsFlatBoxesAndCountsThem) {
  const FcndTable t = fcnd(kHeader + "1,2,3,0,1,1\n1,2,3,0,0,1\n1,2,3,1,1,1\n");
  EXPECT_EQ(t.table.boxes.size(), 3u);
  EXPECT_EQ(t.flat, 2u);
}

TEST(FcndCsv, ColumnsThatMayPlaceBoxesAndFieldsWithoutOneAreSkipped) {
  const std::string header = "posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ";
  const auto read = [](std::istream& in, std::string_view source) {
    return read_fcnd_csv(in, source);
  };
  EXPECT_EQ(support::built_and_skipped(read, header + ",label\n1,1,1,1,1,1,hut\n").second, 0u);
  for (const char* column : {"Yaw", "theta", "azimuth", "halfSizeW", "baseZ", "unit"}) {
    EXPECT_EQ(
        support::built_and_skipped(read, header + "," + column + "\n1,1,1,1,1,1,0.5\n").second, 1u)
        << column;
  }
  EXPECT_EQ(support::built_and_skipped(read, "1,5,1,5,1,5,2,5\n").second, 2u);
  EXPECT_EQ(support::built_and_skipped(read, "1,5,1,5,1,5,,\n").second, 0u);
}

TEST(FcndCsv, ComesBackFromWhatWasWritten) {
  const std::vector<CenteredBox> boxes = {{{1.5, -2.25, 3}, {0.5, 0.25, 3}},
                                          {{0.1, 1e5, 1e-3}, {0.7, 0, 1}}};
  std::ostringstream out;
  write_fcnd_csv(out, {37.5, -122.25, 0}, boxes);
  const FcndTable t = fcnd(out.str());
  ASSERT_TRUE(t.origin);
  EXPECT_EQ(t.origin->latitude, 37.5);
  EXPECT_EQ(t.origin->longitude, -122.25);
  ASSERT_EQ(t.table.boxes.size(), boxes.size());
  EXPECT_EQ(t.table.boxes[0], (Aabb{{1, -2.5, 0}, {2, -2, 6}}));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_LT((t.table.boxes[i].min - (boxes[i].center - boxes[i].half)).norm(), 1e-10) << i;
    EXPECT_LT((t.table.boxes[i].max - (boxes[i].center + boxes[i].half)).norm(), 1e-10) << i;
  }
}

TEST(FcndCsv, RefusesNamesInACommentAndNamesTwice) {
  EXPECT_TRUE(
      support::says(refusal("# posY,posX,posZ,halfSizeX,halfSizeY,halfSizeZ\n1,2,3,1,1,3\n"),
                    "found them in a comment"));
  EXPECT_TRUE(
      support::says(refusal("posX,posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n9,1,2,3,1,1,3\n"),
                    "expected one column posX"));
  EXPECT_EQ(fcnd("# a city\n" + kHeader + "1,2,3,1,1,3\n").table.boxes.size(), 1u);
}

}  // namespace
}  // namespace geom
