// Readers of tables, texts and queries: what they accept, and what they say of the rest.

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "geom/import/block_text.h"
#include "geom/import/box_csv.h"
#include "geom/import/fcnd_csv.h"
#include "geom/map/synth_city.h"
#include "geom/record/query_record.h"

namespace geom {
namespace {

const std::string kHeader = "posX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n";

FcndTable fcnd(const std::string& text) {
  std::istringstream in(text);
  return read_fcnd_csv(in, "t.csv");
}

std::string refusal(const std::string& text) {
  try {
    fcnd(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FcndCsv, ReadsEveryHeaderVariant) {
  const std::string row = "1,2,3,1,1,3\n";
  for (const std::string& head :
       {std::string(), kHeader, "lat0 37.5, lon0 -122.25\n" + kHeader,
        "37.5,-122.25,,,,\n" + kHeader, "lat0,lon0\n37.5,-122.25\n" + kHeader}) {
    const FcndTable t = fcnd(head + row);
    ASSERT_EQ(t.table.boxes.size(), 1u) << head;
    EXPECT_EQ(t.table.boxes[0], (Aabb{{0, 1, 0}, {2, 3, 6}})) << head;
    if (head.find("37.5") != std::string::npos) {
      ASSERT_TRUE(t.origin) << head;
      EXPECT_EQ(t.origin->longitude, -122.25);
    }
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
  EXPECT_NE(refusal(kHeader + "1,2,3,1,2\n").find("expected 6 fields, found 5"), std::string::npos);
  EXPECT_NE(refusal(kHeader + "1,nan,3,1,2,1\n").find("found \"nan\""), std::string::npos);
  EXPECT_NE(refusal(kHeader + "1,1e999,3,1,2,1\n").find("found \"1e999\""), std::string::npos);
  EXPECT_NE(refusal("37.7,-122.3,0,0,0,0\n").find("three zeros"), std::string::npos);
  EXPECT_NE(refusal("lat0 137, lon0 0\n" + kHeader).find("latitude"), std::string::npos);
}

TEST(FcndCsv, KeepsFlatBoxesAndCountsThem) {
  const FcndTable t = fcnd(kHeader + "1,2,3,0,1,1\n1,2,3,0,0,1\n1,2,3,1,1,1\n");
  EXPECT_EQ(t.table.boxes.size(), 3u);
  EXPECT_EQ(t.flat, 2u);
}

TEST(BoxCsv, ComesBackBitForBit) {
  std::istringstream in(
      "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n"
      "0.1,-0,1e-300,0.30000000000000004,2,3,\"a \"\"b\"\", c\"\n");
  const BoxTable table = read_box_csv(in, "b.csv");
  EXPECT_EQ(table.labels[1], "a \"b\", c");
  std::ostringstream once;
  write_box_csv(once, table);
  std::istringstream again(once.str());
  const BoxTable back = read_box_csv(again, "b.csv");
  EXPECT_EQ(back.boxes[0], table.boxes[0]);
  EXPECT_EQ(back.labels, table.labels);
}

TEST(BlockText, ReadsColoursCommentsAndUnknownWords) {
  std::istringstream in("# map\n boundary\t0 0 0 9 9 9\nblock 1 1 1 2 2 2 255 0 0 # red\nfog 3\n");
  const BlockText text = read_block_text(in, "m.txt");
  EXPECT_EQ(text.boundary.max, Vec3(9, 9, 9));
  EXPECT_EQ(text.table.labels[1], "255 0 0");
  EXPECT_EQ(text.skipped.text(), "1 x unknown keyword (line 4: fog)");
}

TEST(BlockText, WantsOneBoundaryAndUprightBlocks) {
  for (const char* bad :
       {"block 0 0 0 1 1 1\n", "boundary 0 0 0 1 1 1\n",
        "boundary 0 0 0 1 1 1\nboundary 0 0 0 1 1 1\nblock 0 0 0 1 1 1\n",
        "boundary 0 0 0 1 1 1\nblock 1 0 0 0 1 1\n", "boundary 0 0 0 1 1 1\nblock 1 0 0 1 1\n"}) {
    std::istringstream in(bad);
    EXPECT_THROW(read_block_text(in, "m.txt"), InputError) << bad;
  }
}

TEST(PlanQueries, ReadsBothForms) {
  std::istringstream json(
      "{\"from\":[1,2,3],\"to\":[4,5,6]}\n\n{\"id\":\"b\",\"from\":[1,2,3],\"to\":[4,5,6]}");
  const auto a = read_plan_queries(json, "q");
  EXPECT_EQ(a[0].id, "q1");
  EXPECT_EQ(a[1].id, "b");
  std::istringstream csv("set,id,to_z,from_x,from_y,from_z,to_x,to_y\ns,7,6,1,2,3,4,5\n");
  const auto b = read_plan_queries(csv, "q");
  EXPECT_EQ(b[0].id, "s-7");
  EXPECT_EQ(b[0].to, Vec3(4, 5, 6));
}

TEST(PlanQueries, StopAtTheFirstMalformedLine) {
  std::istringstream twice(
      "{\"id\":\"b\",\"from\":[1,2,3],\"to\":[4,5,6]}\n{\"id\":\"b\",\"from\":[1,2,3],\"to\":[4,5,"
      "6]}\n");
  EXPECT_THROW(read_plan_queries(twice, "q"), InputError);
  std::istringstream empty("\n");
  EXPECT_THROW(read_plan_queries(empty, "q"), InputError);
}

TEST(PlanQueries, KnowTheBestLengthWhereItIsGiven) {
  std::istringstream json("{\"from\":[1,2,3],\"to\":[4,5,6],\"best_known\":5.5}");
  EXPECT_EQ(read_plan_queries(json, "q")[0].best_known, 5.5);
  std::istringstream csv(
      "id,from_x,from_y,from_z,to_x,to_y,to_z,best_known_m\na,1,2,3,4,5,6,7.5\nb,1,2,3,4,5,6,\n");
  const auto queries = read_plan_queries(csv, "q");
  EXPECT_EQ(queries[0].best_known, 7.5);
  EXPECT_FALSE(queries[1].best_known);
  std::istringstream zero("{\"from\":[1,2,3],\"to\":[4,5,6],\"best_known\":0}");
  EXPECT_THROW(read_plan_queries(zero, "q"), InputError);
}

TEST(ReferenceLengths, AreReadById) {
  std::istringstream in("length,set,id\n5,s,1\n\n6,s,2\n");
  const auto lengths = read_reference_lengths(in, "r");
  EXPECT_EQ(lengths, (std::map<std::string, double>{{"s-1", 5}, {"s-2", 6}}));
  for (const char* bad : {"", "id\n1\n", "id,length\n", "id,length\n1,-2\n", "id,length\n1,x\n",
                          "id,length\n1,2\n1,2\n", "id,length\n1\n"}) {
    std::istringstream bad_in(bad);
    EXPECT_THROW(read_reference_lengths(bad_in, "r"), InputError) << bad;
  }
}

TEST(SynthCity, IsTheSameForASeedAndAnotherForAnother) {
  const auto a = synth_city({1});
  const auto b = synth_city({1});
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
    return x.center == y.center && x.half == y.half;
  }));
  EXPECT_NE(a.size(), synth_city({2}).size());
}

TEST(SynthCity, HasAtLeast3000BoxesThatStandInsideIts900Metres) {
  const auto boxes = synth_city({0});
  EXPECT_GE(boxes.size(), 3000u);
  for (const auto& box : boxes) {
    EXPECT_GT(box.half.minCoeff(), 0);
    EXPECT_GE(box.center.z() - box.half.z(), -1e-9);
    EXPECT_LE(box.center.cwiseAbs().head<2>().maxCoeff(), 450);
    EXPECT_LE(box.center.z() + box.half.z(), 230);
  }
}

}  // namespace
}  // namespace geom
