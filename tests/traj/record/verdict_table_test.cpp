#include "traj/record/verdict_table.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

constexpr auto npos = std::string::npos;

ReportRecord report(const std::string& id, bool ok) {
  ReportRecord out{id, "trajectory", {}, {}, {}, {}, {}};
  out.result.ok = ok;
  out.result.looked = true;
  out.result.reason = ok ? Reason::none : Reason::collision;
  out.result.box = 0;
  out.result.duration = 20;
  return out;
}

class Table : public ::testing::Test {
 protected:
  void add(const std::string& id, bool ok) { table_.add(report(id, ok), city_); }

  const geom::BoxMap city_ = support::random_city(1, 3, 50);
  VerdictTable table_;
};

TEST_F(Table, IsASentenceForOneRecord) {
  EXPECT_EQ(table_.text(), "");
  add("a", true);
  EXPECT_EQ(table_.text(), "a: proved: clear for 20 s\n");
}

TEST_F(Table, HasALineARecordAndCountsForSeveral) {
  add("north", true);
  add("b", false);
  const std::string text = table_.text();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_NE(text.find("\nnorth  ok  "), npos) << text;
  EXPECT_NE(text.find("\nb      collision  "), npos) << text;
  EXPECT_NE(text.find("\n1 of 2 records are refused: 1 collision\n"), npos) << text;
}

// What a yes rests on stands beside it, of one record and of several.
TEST_F(Table, SaysWhatIsReserved) {
  ReportRecord loose = report("loose", true);
  loose.overridden = {"vehicle"};
  loose.limits[Limit::jerk] = 5;
  table_.add(loose, city_);
  add("b", true);
  const std::string text = table_.text();
  EXPECT_NE(
      text.find(
          "  not measured: jerk; looser than its record says (--override or --spare): vehicle\n"),
      npos)
      << text;
}

TEST_F(Table, HasColoursForTerminalsAlone) {
  add("a", true);
  add("b", false);
  EXPECT_EQ(table_.text().find('\x1b'), npos);
  const std::string text = table_.text(Colour::terminal);
  EXPECT_NE(text.find("\x1b[32mok\x1b[0m"), npos) << text;
  EXPECT_NE(text.find("\x1b[31mcollision\x1b[0m"), npos) << text;
}

TEST_F(Table, SaysHowTheFlightsAreTogether) {
  add("a", true);
  TogetherResult result;
  result.pairs = 3;
  table_.add(result, {}, 0);
  table_.add(result, {}, 1);
  TogetherTask task;
  task.rule.spacing.zone = cylinder(15, 5);
  task.overridden = true;
  task.dropped = {"d"};
  table_.add(result, task, 0);
  table_.add({}, MovingSummary{.flights = 2, .obstacles = 1});
  EXPECT_NE(table_.text().find("proved: 3 pairs are proved to keep apart at every instant, so that "
                               "no two vehicles touch\n"),
            npos);
  EXPECT_NE(table_.text().find(
                "by more than 15 m across or more than 5 m in height, with a vehicle "
                "or margin smaller than its record says (--override or --spare), without 1 "
                "refused flight that is left out\n"),
            npos)
      << table_.text();
  EXPECT_NE(table_.text().find("refused: 1 record has no trajectory"), npos);
  EXPECT_NE(table_.text().find("proved: 2 flights are proved clear of 1 obstacle that moves"),
            npos);
}

// An id from a file cannot steer a terminal, and letters beyond ASCII count as one each.
TEST_F(Table, KeepsItsColumnsWhateverIdsAre) {
  add("Gr\xC3\xBC\xC3\x9F", true);
  add("\x1b[31mred", true);
  EXPECT_EQ(table_.text().find('\x1b'), npos);
  EXPECT_NE(table_.text().find("\nGr\xC3\xBC\xC3\x9F         ok "), npos) << table_.text();
}

}  // namespace
}  // namespace traj
