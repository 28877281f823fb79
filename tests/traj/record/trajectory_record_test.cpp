#include "traj/record/trajectory_record.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

#include "geom/base/error.h"
#include "support/random_city.h"

namespace traj {
namespace {

Trajectory flight() {
  return {{hermite({{0, 20, 0}, {3, 0, 0}}, {{9, 20.3, 0.7}, {3, 0.2, 0}}, 8)}};
}

TEST(TrajectoryRecord, ComesBackBitForBit) {
  TrajectoryRecord record{
      "a \"b\"", TrajectoryStatus::solved, flight(), {}, {{Limit::speed, 8}}, "", Rung::ipopt, {}};
  record.trajectory.segments[0].yaw = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  const std::string line = to_json_line(record);
  EXPECT_EQ(to_json_line(parse_trajectory_record(line, "t", 1)), line);
}

// What it says, or nothing where it is refused.
std::optional<std::string> read(const std::string& line) {
  try {
    return to_json_line(parse_trajectory_record(line, "t", 1));
  } catch (const geom::InputError&) {
    return std::nullopt;
  }
}

std::string good_line() {
  TrajectoryRecord record;
  record.id = "a";
  record.status = TrajectoryStatus::solved;
  record.trajectory = flight();
  return to_json_line(record);
}

TEST(TrajectoryRecord, IsRefusedIfItLastsAnotherTimeThanItsSegments) {
  const auto with = [](const char* lasts) {
    std::string line = good_line();
    const std::string own = "\"duration\":8,\"segments\"";
    const auto at = line.find(own);
    if (at == line.npos) throw std::logic_error(line);
    return line.replace(at, own.size(), std::string(lasts) + "\"segments\"");
  };
  EXPECT_TRUE(read(with("\"duration\":8.004,")));
  EXPECT_TRUE(read(with("")));
  EXPECT_FALSE(read(with("\"duration\":8.1,")));
  EXPECT_FALSE(read(with("\"duration\":0,")));
  EXPECT_FALSE(read(with("\"duration\":\"8\",")));
}

TEST(TrajectoryRecord, IsRefusedWhereverItIsCut) {
  std::string line = good_line();
  line.pop_back();  // the newline, which a reader of lines takes away
  ASSERT_TRUE(read(line));
  for (std::size_t size = 0; size < line.size(); ++size) {
    EXPECT_FALSE(read(line.substr(0, size))) << size;
  }
}

// One byte changed: refused, or the record that it says now, which reads back as itself. A byte
// that is structure is always refused.
TEST(TrajectoryRecord, IsRefusedOrAnotherWhereAByteIsChanged) {
  const std::string good = good_line();
  support::Random random(55);
  for (std::size_t at = 0; at + 1 < good.size(); ++at) {
    std::string text = good;
    while (text[at] == good[at]) text[at] = static_cast<char>(random.below(256));
    const auto said = read(text);
    if (said) {
      EXPECT_EQ(read(*said), said) << at;
    }
    if (std::string("{}[]:\"").find(good[at]) != std::string::npos) {
      EXPECT_FALSE(said) << at << ": " << text;
    }
  }
}

TEST(TrajectoryRecord, KnowsNoOtherStatusAndRung) {
  const std::string good = good_line();
  std::string odd = good;
  odd.replace(odd.find("solved"), 6, "proved");
  EXPECT_FALSE(read(odd));
  odd = good;
  odd.insert(odd.find("\"segments\""), "\"rung\":\"magic\",");
  EXPECT_FALSE(read(odd));
}

}  // namespace
}  // namespace traj
