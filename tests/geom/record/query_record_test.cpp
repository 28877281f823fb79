#include "geom/record/query_record.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"

namespace geom {
namespace {

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

}  // namespace
}  // namespace geom
