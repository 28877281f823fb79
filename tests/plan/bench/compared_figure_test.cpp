#include "plan/bench/compared_figure.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"

namespace {

plan::bench::ShownReport parsed(const char* json) {
  return plan::bench::parse_report(geom::JsonFields(json, "report.json", 0), "set");
}

TEST(ComparedFigure, ShowsLengthOverTheBestOnlyWhereAllHaveIt) {
  const char* best = R"({"type":"benchmark","methods":[{"method":"a","trials":4,"found":3,)"
                     R"("time_ms":{"mean":0.2,"p50":0.1,"p99":1},)"
                     R"("length_over_reference":{"mean":1.01,"p50":1,"p99":1.1},)"
                     R"("length_over_straight":{"mean":1.3,"p50":1.2,"p99":2}}]})";
  const char* straight =
      R"({"type":"benchmark","methods":[{"method":"b","trials":4,"found":4,)"
      R"("time_ms":{"mean":0.2},"length_over_straight":{"mean":1.3,"p50":1.2,"p99":2}}]})";
  const plan::bench::ShownReport both[] = {parsed(best), parsed(straight)};
  EXPECT_TRUE(
      support::says(plan::bench::compared_figure(std::span(both, 1)), "over the best known"));
  EXPECT_TRUE(support::says(plan::bench::compared_figure(both), "over the straight line"));
  EXPECT_TRUE(support::says(plan::bench::compared_figure(both), "3 of 4"));
}

TEST(ComparedFigure, RefusesOtherRecords) {
  for (const char* json :
       {R"({"type":"path"})", R"({"type":"benchmark"})", R"({"type":"benchmark","methods":[]})",
        R"({"type":"benchmark","methods":[{"method":"a"}]})",
        R"({"type":"benchmark","methods":[{"method":"a","trials":-1,"found":0}]})"}) {
    EXPECT_THROW(parsed(json), geom::InputError) << json;
  }
}

}  // namespace
