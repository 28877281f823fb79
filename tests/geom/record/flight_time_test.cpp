#include "geom/record/flight_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geom/base/error.h"
#include "geom/record/record.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "support/reading.h"

namespace geom {
namespace {

FlightTime read(const std::string& members) {
  return read_flight_time(JsonFields("{" + members + "}", "t", 1));
}

std::string why_not(const std::string& members) {
  return support::refusal_of([&] { read(members); });
}

TEST(FlightTime, ComesBackAsItWas) {
  for (const char* members :
       {"", "\"start\":12.5", "\"epoch\":\"2026-05-04T06:30:00Z\",\"start\":-0.1",
        "\"epoch\":\"2026-05-04T06:30:00Z\",\"start\":30,\"earliest\":0,\"latest\":90"}) {
    JsonLine line;
    add(line, read(members));
    EXPECT_EQ(line.object(), "{" + std::string(members) + "}");
  }
}

TEST(FlightTime, BeginsAtTheEarliestWhereNoStartIsSaid) {
  EXPECT_EQ(read("").starts(), 0);
  EXPECT_EQ(read("\"latest\":5").starts(), 0);
  EXPECT_EQ(read("\"earliest\":60,\"latest\":90").starts(), 60);
  EXPECT_EQ(read("\"earliest\":60,\"start\":70").starts(), 70);
  EXPECT_FALSE(read("").any());
  EXPECT_TRUE(read("\"earliest\":60").any());
}

TEST(FlightTime, SaysWhatIsWrong) {
  EXPECT_TRUE(
      support::says(why_not("\"start\":\"2026-05-04T06:30:00Z\""), "seconds after the epoch"));
  EXPECT_TRUE(support::says(why_not("\"start\":\"2026-05-04T06:30:00Z\""), "\"epoch\""));
  EXPECT_TRUE(support::says(why_not("\"epoch\":1777876200"), "RFC 3339"));
  EXPECT_TRUE(support::says(why_not("\"epoch\":\"2026-05-04T08:30:00+02:00\""), "UTC"));
  EXPECT_TRUE(
      support::says(why_not("\"start\":100,\"latest\":90"), "at most latest, found 100 and 90"));
  EXPECT_TRUE(support::says(why_not("\"latest\":-1"), "at most latest"));
  EXPECT_TRUE(support::says(why_not("\"start\":10,\"earliest\":20"), "at least earliest"));
  EXPECT_TRUE(support::says(why_not("\"earliest\":9,\"latest\":8"), "earliest must be at most"));
  EXPECT_TRUE(support::says(why_not("\"start\":1.7e12"), "within"));
  EXPECT_TRUE(support::says(why_not("\"start\":1e-12"), "0 or at least"));
  EXPECT_TRUE(support::says(why_not("\"start\":[1]"), "must be a number"));
  EXPECT_TRUE(support::says(why_not("\"earliest\":true"), "must be a number"));
}

TEST(FlightTime, IsNoneThatIsNotANumber) {
  EXPECT_TRUE(time_fault({{}, std::nan(""), {}, {}}));
  EXPECT_TRUE(time_fault({{}, INFINITY, {}, {}}));
  EXPECT_TRUE(time_fault({{}, {}, std::nan(""), {}}));
  EXPECT_FALSE(time_fault({{}, kLargestTime, {}, {}}));
  EXPECT_FALSE(time_fault({{}, -kLeastTime, {}, {}}));
}

TEST(FlightTime, AgreesOnlyWithTheSameEpoch) {
  const auto refused = [](const std::optional<std::string>& a,
                          const std::optional<std::string>& b) {
    return !support::refusal_of([&] { require_epoch_agrees(a, b, "t", 3); }).empty();
  };
  EXPECT_FALSE(refused({}, {}));
  EXPECT_FALSE(refused("2026-05-04T06:30:00Z", "2026-05-04T06:30:00Z"));
  EXPECT_TRUE(refused("2026-05-04T06:30:00Z", {}));
  EXPECT_TRUE(refused({}, "2026-05-04T06:30:00Z"));
  EXPECT_TRUE(refused("2026-05-04T06:30:01Z", "2026-05-04T06:30:00Z"));
}

TEST(FlightTime, IsOfAPathRecord) {
  const std::string line =
      "{\"type\":\"path\",\"id\":\"a\",\"status\":\"found\",\"epoch\":\"2026-05-04T06:30:00Z\","
      "\"start\":7.5,\"length\":1,\"points\":[[0,0,0],[1,0,0]]}\n";
  EXPECT_EQ(to_json_line(parse_path_record(line, "t", 1)), line);
}

TEST(FlightTime, HasAPriorityThatIsAWholeNumber) {
  EXPECT_EQ(read("\"priority\":3").priority, 3);
  EXPECT_EQ(read("\"priority\":-2.0").priority, -2);
  EXPECT_EQ(read("\"priority\":null").priority, std::nullopt);
  EXPECT_TRUE(read("\"priority\":0").any());
  for (const char* wrong : {"2.5", "\"high\"", "true", "1000001", "1e300", "[1]"}) {
    EXPECT_EQ(why_not(std::string("\"priority\":") + wrong)
                  .find("t:1: priority must be a whole number within 1000000, found "),
              0u)
        << wrong;
  }
}

}  // namespace
}  // namespace geom
