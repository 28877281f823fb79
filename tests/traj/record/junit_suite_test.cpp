#include "traj/record/junit_suite.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

ReportRecord report(const std::string& id, bool ok) {
  ReportRecord out{id, "path", {}, {}, {}, {}, {}};
  out.result.ok = ok;
  out.result.looked = true;
  out.result.reason = ok ? Reason::none : Reason::collision;
  out.result.box = 0;
  out.result.place = {1, 2, 3};
  return out;
}

TEST(JUnitSuite, HasACaseARecordWithWhereItFailed) {
  const geom::BoxMap city = support::random_city(1, 3, 50);
  JUnitSuite suite;
  suite.add(report("a", true), city);
  suite.add(report("b & c", false), city);
  const std::string xml = suite.xml();
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<testcase classname=\"skyway-check\" name=\"a\"/>"), std::string::npos);
  EXPECT_NE(xml.find("name=\"b &amp; c\""), std::string::npos);
  EXPECT_NE(xml.find("<failure type=\"collision\""), std::string::npos);
  EXPECT_NE(xml.find("near [1.000, 2.000, 3.000]"), std::string::npos);
}

TEST(JUnitSuite, SkipsWhatIsDropped) {
  const geom::BoxMap city = support::random_city(1, 3, 50);
  JUnitSuite suite;
  ReportRecord dropped = report("b", false);
  dropped.dropped = true;
  suite.add(dropped, city);
  const std::string xml = suite.xml();
  EXPECT_NE(xml.find("tests=\"1\" failures=\"0\" skipped=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<skipped message=\"the vehicle touches obstacle "), std::string::npos) << xml;
}

// One of the checks is wrong then: that is no pass.
TEST(JUnitSuite, FailsWhatOnlyTheExactCheckRefuses) {
  const geom::BoxMap city = support::random_city(1, 3, 50);
  ReportRecord one = report("a", true);
  one.exact = ExactResult{};
  JUnitSuite suite;
  suite.add(one, city);
  EXPECT_NE(suite.xml().find("<failure type=\"exact\""), std::string::npos) << suite.xml();
}

TEST(JUnitSuite, SaysThatFlightsWereLeftOut) {
  TogetherResult result;
  result.pairs = 3;
  JUnitSuite suite;
  suite.add(result, {}, 0);
  suite.add(result, {}, 2);
  EXPECT_NE(suite.xml().find("together: the other 3 pairs"), std::string::npos);
  EXPECT_NE(suite.xml().find("2 of the flights have no trajectory"), std::string::npos);
  EXPECT_NE(suite.xml().find("failures=\"1\""), std::string::npos);
}

}  // namespace
}  // namespace traj
