#include "traj/home/contingency_record.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace traj {
namespace {

ContingencyRecord way() {
  ContingencyRecord record{.id = "q1", .from = 1.5, .until = 7};
  record.site = "pad-2";
  record.points = {{1, 1, 9}, {4, 1, 5}, {4, 1, 0}};
  record.length = 30;
  record.duration = 12.25;
  record.bounds_energy = true;
  record.latest_departure = 6;
  record.autopilot = "px4:1.17";
  record.provenance.map = "sha256:0";
  record.provenance.margin = 0.5;
  return record;
}

TEST(ContingencyRecord, ReadsWhatItWrites) {
  const std::string line = to_json_line(way());
  EXPECT_EQ(line,
            R"({"type":"contingency","id":"q1","status":"found","from":1.5,"until":7,)"
            R"("autopilot":"px4:1.17","map":"sha256:0","margin":0.5,"site":"pad-2","length":30,)"
            R"("duration":12.25,"latest_departure":6,"points":[[1,1,9],[4,1,5],[4,1,0]]})"
            "\n");
  EXPECT_EQ(to_json_line(parse_contingency_record(line, "h", 1)), line);
  ContingencyRecord none = way();
  none.latest_departure.reset();
  const std::string null = to_json_line(none);
  EXPECT_TRUE(support::says(null, R"("latest_departure":null)"));
  EXPECT_EQ(to_json_line(parse_contingency_record(null, "h", 1)), null);
  none.bounds_energy = false;
  EXPECT_FALSE(support::says(to_json_line(none), "latest_departure"));
}

TEST(ContingencyRecord, IsOfTheFlightWhoseHashItNames) {
  ContingencyRecord record = way();
  const auto refusal = [&](const char* hash) {
    return support::refusal_of([&] {
      require_of_flight(record.id, record.flight_hash, {"cc", hash}, "h", 2);
    });
  };
  EXPECT_EQ(refusal("aa"), "");
  record.flight_hash = "aa";
  EXPECT_EQ(parse_contingency_record(to_json_line(record), "h", 1).flight_hash, "aa");
  EXPECT_EQ(refusal("aa"), "");
  EXPECT_EQ(refusal(""), "");
  EXPECT_NO_THROW(require_of_flight("q1", "aa", {}, "h", 2));
  EXPECT_EQ(refusal("bb"),
            "h:2: expected ways home of the flight \"q1\" that is given, found ones of another "
            "flight with this id: plan them anew for this flight (skyway-plan --home)");
}

TEST(ContingencyRecord, ThatIsAGapHasNoWay) {
  ContingencyRecord gap{.id = "q1", .from = 1, .until = 2};
  gap.message = "no way";
  const std::string line = to_json_line(gap);
  EXPECT_EQ(line, R"({"type":"contingency","id":"q1","status":"unreachable","from":1,"until":2,)"
                  R"("message":"no way"})"
                  "\n");
  const ContingencyRecord back = parse_contingency_record(line, "h", 1);
  EXPECT_FALSE(back.found());
  EXPECT_EQ(back.message, "no way");
}

TEST(ContingencyRecord, IsGoodAsLongAsThereIsEnergy) {
  ContingencyRecord record = way();
  EXPECT_EQ(record.good_until(), 6);
  record.latest_departure.reset();
  EXPECT_FALSE(record.good_until());
  record.bounds_energy = false;
  EXPECT_EQ(record.good_until(), 7);
  record.points.clear();
  EXPECT_FALSE(record.good_until());
}

TEST(ContingencyRecord, WithoutAStatusIsAWay) {
  const ContingencyRecord back = parse_contingency_record(
      R"({"type":"contingency","id":"a","from":0,"until":1,"site":"s","points":[[0,0,1],[0,0,0]]})",
      "h", 1);
  EXPECT_TRUE(back.found());
  EXPECT_FALSE(back.bounds_energy);
}

TEST(ContingencyRecord, RefusesWhatCannotBe) {
  const auto refused = [](const std::string& members) {
    return support::refusal_of([&] {
      parse_contingency_record(R"({"type":"contingency","id":"a",)" + members + "}", "h", 3);
    });
  };
  const std::string points = R"(,"site":"s","points":[[0,0,1],[0,0,0]])";
  EXPECT_TRUE(refused(R"("from":0)" + points).starts_with("h:3: "));
  EXPECT_TRUE(support::says(refused(R"("from":2,"until":1)" + points), "until must be >= 2"));
  EXPECT_TRUE(support::says(refused(R"("from":-1,"until":1)" + points), "from"));
  EXPECT_TRUE(support::says(refused(R"("from":0,"until":1e10)" + points), "until"));
  EXPECT_TRUE(support::says(refused(R"("from":0,"until":1,"site":"s","points":[[0,0,1]])"),
                            "at least two"));
  EXPECT_TRUE(support::says(refused(R"("from":0,"until":1,"points":[[0,0,1],[0,0,0]])"), "site"));
  EXPECT_NE(refused(R"("from":0,"until":1,"latest_departure":2)" + points), "");
  EXPECT_NE(refused(R"("from":0,"until":1,"length":-2)" + points), "");
  EXPECT_NE(refused(R"("from":0,"until":1,"status":"maybe")" + points), "");
}

}  // namespace
}  // namespace traj
