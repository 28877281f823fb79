#include "geom/record/flight_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geom/base/error.h"
#include "geom/record/record.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "support/refusal.h"

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
  EXPECT_NE(why_not("\"start\":\"2026-05-04T06:30:00Z\"").find("seconds after the epoch"),
            std::string::npos);
  EXPECT_NE(why_not("\"start\":\"2026-05-04T06:30:00Z\"").find("\"epoch\""), std::string::npos);
  EXPECT_NE(why_not("\"epoch\":1777876200").find("RFC 3339"), std::string::npos);
  EXPECT_NE(why_not("\"epoch\":\"2026-05-04T08:30:00+02:00\"").find("UTC"), std::string::npos);
  EXPECT_NE(why_not("\"start\":100,\"latest\":90").find("at most latest, found 100 and 90"),
            std::string::npos);
  EXPECT_NE(why_not("\"latest\":-1").find("at most latest"), std::string::npos);
  EXPECT_NE(why_not("\"start\":10,\"earliest\":20").find("at least earliest"), std::string::npos);
  EXPECT_NE(why_not("\"earliest\":9,\"latest\":8").find("earliest must be at most"),
            std::string::npos);
  EXPECT_NE(why_not("\"start\":1.7e12").find("within"), std::string::npos);
  EXPECT_NE(why_not("\"start\":1e-12").find("0 or at least"), std::string::npos);
  EXPECT_NE(why_not("\"start\":[1]").find("must be a number"), std::string::npos);
  EXPECT_NE(why_not("\"earliest\":true").find("must be a number"), std::string::npos);
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
