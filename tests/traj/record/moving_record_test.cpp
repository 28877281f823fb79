#include "traj/record/moving_record.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace traj {
namespace {

std::string record(const std::string& without = "", const std::string& more = "") {
  std::string text = R"({"type":"moving","id":"balloon")";
  for (const auto& [key, value] : {std::pair<std::string, std::string>{"from", "10"},
                                   {"until", "70.5"},
                                   {"min", "[0,0,20]"},
                                   {"max", "[4,4,30]"},
                                   {"velocity", "[1.5,-0.5,0]"},
                                   {"growth", "[0.1,0.1,0]"}}) {
    if (key != without) text += ",\"" + key + "\":" + value;
  }
  return text + more + "}";
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { parse_moving_record(text, "m", 3); });
}

TEST(MovingRecord, HasWhatItSays) {
  const MovingRecord r = parse_moving_record(
      record("", R"(,"epoch":"2026-05-04T06:30:00.0Z","frame":"neu","map":"sha256:a")"), "m", 1);
  EXPECT_EQ(r.id, "balloon");
  EXPECT_EQ(r.epoch, "2026-05-04T06:30:00Z");
  EXPECT_EQ(r.frame, geom::Axes::neu);
  EXPECT_EQ(r.map, "sha256:a");
  EXPECT_EQ(r.box.from, 10);
  EXPECT_EQ(r.box.until, 70.5);
  EXPECT_EQ(r.box.box.max, Vec3(4, 4, 30));
  EXPECT_EQ(r.box.velocity, Vec3(1.5, -0.5, 0));
  EXPECT_EQ(r.box.growth, Vec3(0.1, 0.1, 0));
}

TEST(MovingRecord, RefusesWhatIsMissingOrNotKnown) {
  for (const char* key : {"from", "until", "min", "max", "velocity", "growth"}) {
    EXPECT_EQ(refusal(record(key)).rfind(std::string("m:3: expected \"") + key + "\"", 0), 0u)
        << refusal(record(key));
  }
  EXPECT_EQ(refusal(record("", R"(,"speed":3)")),
            "m:3: expected type, id, epoch, frame, map, from, until, min, max, velocity, growth, "
            "found \"speed\", which is not known here");
  EXPECT_EQ(refusal(record("until", R"(,"until":"2026-05-04T06:30:00Z")")),
            "m:3: until must be a finite number, found \"2026-05-04T06:30:00Z\"");
  EXPECT_EQ(refusal(record("until", ",\"until\":10")),
            "m:3: from must be before until, found 10 and 10");
  EXPECT_EQ(refusal(record("growth", ",\"growth\":[0,-1,0]")),
            "m:3: growth must be m/s from 0 to 10000 along each axis");
  EXPECT_NE(refusal(record("", ",\"epoch\":\"today\"")), "");
  EXPECT_NE(refusal(R"({"type":"path"})"), "");
}

TEST(MovingRecord, IsWrittenIntoCertificates) {
  ProvedMoving proved{"a", "balloon", {}};
  proved.proof.clear = true;
  proved.proof.stretches.push_back({{1, 2, 2}, {{0, true}, {1, false}, {2, true}}});
  EXPECT_EQ(certificate_line(proved),
            R"({"type":"clear_of","ids":["a","balloon"],"stretches":[{"pieces":[1,2,2],)"
            R"("sides":["+x","-y","+z"]}]})"
            "\n");
  MovingClaim claim;
  claim.flights = {"a"};
  claim.rooms = {{1, 1, 0.5}};
  claim.obstacles = {"balloon", "kite"};
  claim.parked = Parked::gone;
  claim.map = "sha256:b";
  EXPECT_EQ(certificate_line(claim),
            R"({"type":"clear_of_moving","flights":["a"],"obstacles":["balloon","kite"],)"
            R"("rooms":[[1,1,0.5]],"parked":"gone","map":"sha256:b"})"
            "\n");
}

TEST(MovingRecord, SaysWhichOfTheTwoChecksRefuses) {
  MovingConflict conflict{"a", "balloon", {}};
  EXPECT_EQ(reason_of(conflict), "moving");
  conflict.result.undecided = true;
  EXPECT_EQ(reason_of(conflict), "undecided");
  conflict.result = {};
  conflict.result.clear = true;
  EXPECT_EQ(reason_of(conflict), "exact");
  EXPECT_TRUE(support::says(in_words(conflict), "could not be shown"));
}

}  // namespace
}  // namespace traj
