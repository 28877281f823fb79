#include "geom/record/path_csv.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"

namespace geom {
namespace {

std::vector<PathRecord> read(const std::string& text) {
  return read_path_csv(support::Text(text), "p.csv");
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { read(text); });
}

TEST(PathCsv, ReadsPathsByTheirIds) {
  const auto paths = read("id,x_m,y_m,z_m\r\na,1,2,3\r\na,4,5,6\r\nb;7;8;9\r\n");
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_EQ(paths[0].id, "a");
  EXPECT_EQ(paths[0].status, geom::PathStatus::found);
  EXPECT_EQ(paths[0].points, (Polyline{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(paths[1].points, (Polyline{{7, 8, 9}}));
}

TEST(PathCsv, ReadsOnePathWithoutIdOrHeader) {
  const auto paths = read("0.0,0.25,1e1\n\n0,1,2\n");
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].id, "path");
  EXPECT_EQ(paths[0].points, (Polyline{{0, 0.25, 10}, {0, 1, 2}}));
}

TEST(PathCsv, RefusesBadTables) {
  EXPECT_EQ(refusal(""), "p.csv: expected points id,x,y,z, found none");
  EXPECT_EQ(refusal("id,x,y,z\n"), "p.csv: expected points id,x,y,z, found none");
  EXPECT_EQ(refusal("1,2\n"), "p.csv:1: expected id,x,y,z or x,y,z, found 2 columns");
  EXPECT_EQ(refusal("a,1,2,3\n1,2,3\n"), "p.csv:2: expected id,x,y,z, found 3 columns");
  EXPECT_EQ(refusal("a,1,2,nan\n"),
            "p.csv:1: z must be a finite number within 1e8 m, found \"nan\"");
  EXPECT_EQ(refusal("a,1,2,3\nb,1,2,3\na,1,2,3\n"),
            "p.csv:3: expected the points of a path together, found \"a\" again");
}

TEST(PathCsv, RefusesAFirstColumnThatNumbersRowsOrIsATime) {
  EXPECT_EQ(refusal(",x,y,z\n0,1,2,3\n1,4,5,6\n"),
            "p.csv:1: expected the columns id,x,y,z or x,y,z, found the first of four named \"\": "
            "name it id if it says which path a point is of, or leave it out");
  EXPECT_NE(refusal("t_s,x_m,y_m,z_m\n0,1,2,3\n"), "");
  EXPECT_EQ(refusal("0.0,1,2,3\n0.1,4,5,6\n"),
            "p.csv: expected the points of a path in rows with the same id, found 2 rows with as "
            "many ids: leave the first column out if it is a number of the row or a time");
  EXPECT_EQ(refusal("a,1,2,3\n"), "");
  EXPECT_EQ(refusal("a,1,2,3\nb,4,5,6\nb,7,8,9\n"), "");
  // A flight that rises: x, y, z and a time.
  EXPECT_EQ(refusal("0.5,1,2,0\n0.5,1,9,1\n4.5,1,9,2\n"),
            "p.csv: expected ids of paths in the first of four columns, found \"0.5\": begin with "
            "the header id,x,y,z if that is an id, else leave only the columns x,y,z");
  EXPECT_EQ(refusal("id,x,y,z\n0.5,1,2,0\n0.5,1,9,1\n"), "");
}

TEST(PathCsv, ReadsColumnsAndUnitsInAComment) {
  EXPECT_EQ(read("# x_m,y_m,z_m\n0,1,2\n").front().points, (Polyline{{0, 1, 2}}));
  EXPECT_EQ(read("#\n# Units: metres\n# id,x,y,z\n0.5,1,2,3\n").front().id, "0.5");
  EXPECT_EQ(read("# made by hand, on a Monday, in metres\n0,1,2\n").size(), 1u);
  EXPECT_EQ(refusal("# t,x,y,z\n0,1,2,3\n0,4,5,6\n"),
            "p.csv:1: expected the columns id,x,y,z or x,y,z, found the first of four named \"t\": "
            "name it id if it says which path a point is of, or leave it out");
  EXPECT_EQ(refusal("# y,x,z\n0,1,2\n"),
            "p.csv:1: expected the columns id,x,y,z or x,y,z, found others in a comment, "
            "\"# y,x,z\": put the columns in this order, or leave the comment out");
  EXPECT_EQ(refusal("# units: feet\n0,1,2\n"),
            "p.csv:1: expected coordinates in metres, found a comment that names another unit, "
            "\"# units: feet\": convert the coordinates to metres, and leave the comment out");
}

TEST(PathCsv, TakesPointsInTheAxesThatACommentNames) {
  EXPECT_EQ(read("# frame: ned\n1,2,-3\n").front().points, (Polyline{{2, 1, 3}}));
  EXPECT_EQ(read("# ENU\n1,2,3\n").front().points, (Polyline{{1, 2, 3}}));
  const auto on_neu = [](const char* text) {
    return read_path_csv(support::Text(text), "p.csv", Axes::neu).front().points;
  };
  EXPECT_EQ(on_neu("# NED\n1,2,-3\n"), (Polyline{{1, 2, 3}}));
  EXPECT_EQ(on_neu("# frame: enu\n1,2,3\n"), (Polyline{{2, 1, 3}}));
  EXPECT_EQ(on_neu("1,2,3\n"), (Polyline{{1, 2, 3}}));
  EXPECT_EQ(refusal("# FLU\n1,2,3\n"),
            "p.csv:1: expected axes enu, neu or ned, found a comment that names other axes, "
            "\"# FLU\": convert the coordinates, or leave the comment out if it is wrong");
  EXPECT_NE(refusal("# NED\n# ENU\n1,2,3\n"), "");
  EXPECT_NE(refusal("# all in feet\n1,2,3\n"), "");
}

}  // namespace
}  // namespace geom
