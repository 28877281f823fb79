#include "geom/record/search_report.h"

#include <gtest/gtest.h>

#include "geom/record/record.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

std::optional<SearchReport> read(const std::string& search) {
  return read_search_report(JsonFields("{\"search\":" + search + "}", "s", 1));
}

SearchReport full() {
  SearchReport report;
  report.method = "roadmap";
  report.expanded = 42;
  report.resolution = 2.5;
  report.steps = {{"search", 9, 12.5}, {"taut", 2, 10}};
  report.layer = {20, 30};
  report.snapped_start = Vec3(1, 2, 3);
  report.snapped_goal = Vec3(4, 5, 6.5);
  return report;
}

TEST(SearchReport, IsWrittenInThisOrder) {
  EXPECT_EQ(json_of(full()).object(),
            R"({"method":"roadmap","expanded":42,"resolution":2.5,"steps":[)"
            R"({"step":"search","points":9,"length":12.5},{"step":"taut","points":2,"length":10}],)"
            R"("layer":[20,30],"snapped_start":[1,2,3],"snapped_goal":[4,5,6.5]})");
  EXPECT_EQ(json_of({}).object(), "{}");
}

TEST(SearchReport, ComesBack) {
  for (const SearchReport& report : {full(), SearchReport{}}) {
    EXPECT_EQ(read(json_of(report).object()), report);
  }
}

TEST(SearchReport, LeavesOutWhatItDoesNotKnow) {
  for (const char* none : {"\"A*\"", "null", "[]"}) EXPECT_EQ(read(none), std::nullopt) << none;
  EXPECT_EQ(
      read(R"({"planner":"theirs","method":5,"expanded":-1,"steps":[1,{"step":2}],"layer":[1],)"
           R"("snapped_goal":[1,2,"3"]})"),
      SearchReport{});
}

TEST(SearchReport, TravelsInAPathRecord) {
  PathRecord record;
  record.id = "q";
  record.search = full();
  const std::string line = to_json_line(record);
  EXPECT_EQ(parse_path_record(line, "s", 1).search, full());
  EXPECT_EQ(to_json_line(parse_path_record(line, "s", 1)), line);
}

}  // namespace
}  // namespace geom
