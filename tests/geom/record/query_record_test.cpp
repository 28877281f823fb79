#include "geom/record/query_record.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "support/random_city.h"
#include "support/reading.h"

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

TEST(PlanQueries, KnowWhenTheyBegin) {
  std::istringstream json(
      "{\"from\":[1,2,3],\"to\":[4,5,6],\"epoch\":\"2026-05-04T06:30:00Z\",\"start\":12.5,"
      "\"latest\":60}");
  const FlightTime time = read_plan_queries(json, "q")[0].time;
  EXPECT_EQ(time, (FlightTime{"2026-05-04T06:30:00Z", 12.5, {}, 60}));
  std::istringstream csv(
      "id,from_x,from_y,from_z,to_x,to_y,to_z,start_s,latest_s,earliest_s,epoch\n"
      "a,1,2,3,4,5,6,12.5,60,,2026-05-04T06:30:00Z\nb,1,2,3,4,5,6,,,,\n");
  const auto queries = read_plan_queries(csv, "q");
  EXPECT_EQ(queries[0].time, time);
  EXPECT_FALSE(queries[1].time.any());
}

TEST(PlanQueries, HaveAPriority) {
  std::istringstream json("{\"from\":[1,2,3],\"to\":[4,5,6],\"priority\":4}");
  EXPECT_EQ(read_plan_queries(json, "q")[0].time.priority, 4);
  const std::string head = "id,from_x,from_y,from_z,to_x,to_y,to_z,priority\n";
  std::istringstream csv(head + "a,1,2,3,4,5,6,-3\nb,1,2,3,4,5,6,\n");
  const auto queries = read_plan_queries(csv, "q");
  EXPECT_EQ(queries[0].time.priority, -3);
  EXPECT_FALSE(queries[1].time.any());
  for (const char* wrong : {"1.5", "high", "nan", "2000000"}) {
    std::istringstream bad(head + "a,1,2,3,4,5,6," + wrong + "\n");
    EXPECT_THROW(read_plan_queries(bad, "q"), InputError) << wrong;
  }
}

TEST(PlanQueries, RefuseTimesThatCannotBe) {
  for (const char* row : {"a,1,2,3,4,5,6,06:30:00,", "a,1,2,3,4,5,6,90,60", "a,1,2,3,4,5,6,nan,"}) {
    std::istringstream csv(
        std::string("id,from_x,from_y,from_z,to_x,to_y,to_z,start_s,latest_s\n") + row + "\n");
    EXPECT_THROW(read_plan_queries(csv, "q"), InputError) << row;
  }
  std::istringstream json("{\"from\":[1,2,3],\"to\":[4,5,6],\"start\":\"2026-05-04T06:30:00Z\"}");
  EXPECT_THROW(read_plan_queries(json, "q"), InputError);
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

// Whoever answers compares them.
TEST(PlanQueries, SayWhatTheyAreAskedOf) {
  std::istringstream json(
      R"({"from":[1,2,3],"to":[4,5,6],"map":"sha256:1","frame":"neu","margin":3,)"
      R"("vehicle":{"half":[1,2,3]}})"
      "\n"
      R"({"from":[1,2,3],"to":[4,5,6]})");
  const auto queries = read_plan_queries(json, "q");
  EXPECT_EQ(queries[0].asked_of.map, "sha256:1");
  EXPECT_EQ(queries[0].asked_of.frame, Axes::neu);
  EXPECT_EQ(queries[0].asked_of.vehicle->half, Vec3(1, 2, 3));
  EXPECT_EQ(queries[0].asked_of.margin, 3);
  EXPECT_FALSE(mismatch(queries[1].asked_of, {}));
  std::istringstream csv(
      "id,from_x,from_y,from_z,to_x,to_y,to_z,margin\na,1,2,3,4,5,6,30\nb,1,2,3,4,5,6,\n");
  const auto rows = read_plan_queries(csv, "q");
  EXPECT_EQ(rows[0].asked_of.margin, 30);
  EXPECT_FALSE(rows[1].asked_of.margin);
}

TEST(PlanQueries, AreAskedOfTheAxesThatACommentNames) {
  const auto read = [](const std::string& text) {
    return read_plan_queries(support::Text(text), "q");
  };
  const std::string csv = "id,from_x,from_y,from_z,to_x,to_y,to_z\na,1,1,1,2,2,2\n";
  EXPECT_EQ(read("# frame: neu\n" + csv)[0].asked_of.frame, Axes::neu);
  EXPECT_EQ(read("#\n\n# made by hand\n" + csv)[0].asked_of.frame, std::nullopt);
  EXPECT_NE(support::refusal_of([&] { read("# NED\n" + csv); }), "");
  const std::string json = R"({"from":[1,1,1],"to":[2,2,2],"frame":"neu"})"
                           "\n";
  EXPECT_EQ(read("# NEU\n" + json)[0].asked_of.frame, Axes::neu);
  EXPECT_NE(support::refusal_of([&] { read("# ENU\n" + json); }), "");
}

TEST(PlanQueries, RefuseAColumnThatComesTwiceAndTwoPlacesOfOneEnd) {
  for (const char* head :
       {"id,from_x,from_y,from_z,to_x,to_y,to_z,to_z", "id,from_x,from_y,from_z,to_x,to_y,to_z,id",
        "id,from_x,from_y,from_z,to_x,to_y,to_z,margin,margin"}) {
    std::istringstream csv(std::string(head) + "\na,1,2,3,4,5,6,7,8\n");
    EXPECT_NE(support::refusal_of([&] { read_plan_queries(csv, "q"); }).find("expected one column"),
              std::string::npos)
        << head;
  }
  std::istringstream unused("id,from_x,from_y,from_z,to_x,to_y,to_z,n,n\na,1,2,3,4,5,6,7,8\n");
  EXPECT_EQ(read_plan_queries(unused, "q").size(), 1u);
  std::istringstream both(
      "id,from_x,from_y,from_z,to_x,to_y,to_z,to_latitude,to_longitude,to_height\n"
      "a,1,2,3,4,5,6,60,24,3\n");
  EXPECT_THROW(read_plan_queries(both, "q"), InputError);
}

// --- on Earth -----------------------------------------------------------------------------------

const GeodeticOrigin kHelsinki{60.17, 24.94, 0};

BoxMap helsinki(double zero = 0) {
  BoxMapSpec spec;
  spec.bounds = {{-1000, -1000, 0}, {1000, 1000, 100}};
  spec.frame.origin = kHelsinki;
  spec.frame.origin->height = zero;
  return BoxMap(spec, support::table_of({{{-10, -10, 0}, {10, 10, 15}}}));
}

std::vector<PlanQuery> read(const std::string& text, double zero = 0) {
  const BoxMap map = helsinki(zero);
  const Locator locator(map);
  std::istringstream in(text);
  return read_plan_queries(in, "q", &locator);
}

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_NEAR((a - b).norm(), 0, 1e-6); }

TEST(PlanQueriesOnEarth, AreTextsColumnsOrGeoJson) {
  const Vec3 to = GeographicFrame(kHelsinki).enu({60.171, 24.945, 30});
  const auto json = read(R"({"id":"a","from":"60.17N,24.94E,2above","to":"60.171N,24.945E,30"})"
                         "\n"
                         R"({"from":[1,2,3],"to":"24.94E,60.17N,40"})");
  ASSERT_EQ(json.size(), 2u);
  expect_near(json[0].from, {0, 0, 17});
  expect_near(json[0].to, to);
  expect_near(json[1].from, {1, 2, 3});
  expect_near(json[1].to, {0, 0, 40});
  const auto csv = read(
      "id,from_latitude,from_longitude,from_height,to_x,to_y,to_z\na,60.171,24.945,30,1,2,3\n");
  expect_near(csv[0].from, to);
  expect_near(csv[0].to, {1, 2, 3});
  const auto lines = read(
      "{\n\"type\": \"FeatureCollection\", \"features\": [\n"
      R"({"type":"Feature","id":7,"geometry":{"type":"LineString","coordinates":[[24.94,60.17,20],[24.9,60.1,5],[24.945,60.171,30]]}},)"
      R"({"type":"Feature","properties":{"id":"p","height":"3above"},"geometry":{"type":"Point","coordinates":[24.94,60.17]}},)"
      R"({"type":"Feature","properties":{"height":4},"geometry":{"type":"LineString","coordinates":[[24.94,60.17],[24.945,60.171]]}},)"
      R"({"type":"Feature","properties":{"id":"p"},"geometry":{"type":"Point","coordinates":[24.945,60.171,30]}}]})");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].id, "7");
  expect_near(lines[0].from, {0, 0, 20});
  expect_near(lines[0].to, to);
  EXPECT_EQ(lines[1].id, "q3");
  expect_near(lines[1].from, {0, 0, 4});
  EXPECT_EQ(lines[2].id, "p");
  expect_near(lines[2].from, {0, 0, 18});
  expect_near(lines[2].to, to);
}

TEST(PlanQueriesOnEarth, SayWhichEndsAreInDegrees) {
  const auto expect = [](const PlanQuery& query, bool from, bool to) {
    EXPECT_EQ(query.from_on_earth, from);
    EXPECT_EQ(query.to_on_earth, to);
  };
  expect(read(R"({"from":[1,2,3],"to":"24.94E,60.17N,40"})")[0], false, true);
  expect(read(R"({"from":"24.94E,60.17N,40","to":"1,2,3"})")[0], true, false);
  expect(read("id,from_latitude,from_longitude,from_height,to_x,to_y,to_z\na,60.171,24.945,30,1,2,"
              "3\n")[0],
         true, false);
  expect(read(R"({"type":"Feature","geometry":{"type":"LineString",)"
              R"("coordinates":[[24.94,60.17,20],[24.945,60.171,30]]}})")[0],
         true, true);
}

// As skyway-export writes it, a third coordinate has the datum of the map's origin.
TEST(PlanQueriesOnEarth, HaveTheThirdCoordinateOfGeoJsonOnEarthAndHeightsOnTheMap) {
  const std::string line =
      R"("geometry":{"type":"LineString","coordinates":[[24.94,60.17,20],[24.94,60.17,30]]}})";
  const auto given = read(R"({"type":"Feature",)" + line, 12);
  expect_near(given[0].from, {0, 0, 8});
  expect_near(given[0].to, {0, 0, 18});
  const auto height = read(
      R"({"type":"Feature","properties":{"height":20},"geometry":{"type":"LineString","coordinates":)"
      R"([[24.94,60.17],[24.94,60.17]]}})",
      12);
  expect_near(height[0].from, {0, 0, 20});
  expect_near(read(R"({"from":"60.17N,24.94E,20","to":[1,2,3]})", 12)[0].from, {0, 0, 20});
}

TEST(PlanQueriesOnEarth, RefuseTwoHeightsThatDoNotAgree) {
  const auto line = [](const char* height) {
    return std::string(R"({"type":"Feature","properties":{"height":)") + height +
           R"(},"geometry":{"type":"LineString","coordinates":[[24.94,60.17,20],[24.94,60.17,20]]}})";
  };
  expect_near(read(line("8"), 12)[0].from, {0, 0, 8});
  expect_near(read(line("null"), 12)[0].from, {0, 0, 8});
  for (const char* other : {"20", "\"2above\""}) {
    EXPECT_NE(support::refusal_of([&] {
                read(line(other), 12);
              }).find("expected one height above the map's zero, found 8"),
              std::string::npos)
        << other;
  }
}

TEST(PlanQueriesOnEarth, AreRefusedWithAReason) {
  const auto refused = [](const std::string& text) {
    return support::refusal_of([&] { read(text); });
  };
  const auto has = [&](const std::string& text, const char* why) {
    EXPECT_NE(refused(text).find(why), std::string::npos) << text << ": " << refused(text);
  };
  const std::string feature = R"({"type":"Feature","geometry":{"type":)";
  has(R"({"from":"60.17,24.94,3","to":"60.17N"})", "to: expected x,y,z in metres");
  has("id,from_latitude,from_longitude,from_height,to_x,to_y,to_z\na,91,24,3,1,2,3\n",
      "from_latitude must be degrees within 90, found 91");
  has("id,from_latitude,from_longitude,from_height,to_x,to_y,to_z\na,60,24,3m,1,2,3\n",
      "from_height must be metres");
  has("id,from_latitude,from_longitude,to_x,to_y,to_z\na,60,24,1,2,3\n",
      "expected a column from_height");
  has(feature + R"("LineString","coordinates":[[24.94,60.17],[24.95,60.17]]}})",
      "expected a height");
  has(feature + R"("LineString","coordinates":[[24.94,60.17,1]]}})", "at least 2 positions");
  has(feature + R"("LineString","coordinates":[[24.94,160.17,1],[24.9,60,1]]}})",
      "must be degrees");
  has(feature + R"("Polygon","coordinates":[]}})", "expected a LineString or a Point, found");
  has(feature + R"("Point","coordinates":[24.94,60.17,1]}})", "expected an id");
  has(R"({"type":"Feature","id":"a","geometry":{"type":"Point","coordinates":[24.94,60.17,1]}})",
      "expected a second point of id \"a\"");
  const std::string crs = R"("crs":{"type":"name","properties":{"name":"EPSG:3857"}},)";
  const std::string line = R"("type":"LineString","coordinates":[[24.9,60,1],[24.9,60,1]]})";
  has(R"({"type":"FeatureCollection",)" + crs + R"("features":[]})", "crs must be CRS84");
  has(R"({"type":"Feature",)" + crs + R"("geometry":{)" + line + "}", "crs must be CRS84");
  has(R"({"type":"Feature","geometry":{)" + crs + line + "}", "crs must be CRS84");
  has(R"({"type":"FeatureCollection","features":[]})", "expected at least one query");
  has(R"({"type":"FeatureCollection"})", "expected \"features\"");
  std::istringstream in(R"({"from":"60.17N,24.94E,3","to":[1,2,3]})");
  EXPECT_THROW(read_plan_queries(in, "q"), InputError);
}

}  // namespace
}  // namespace geom
