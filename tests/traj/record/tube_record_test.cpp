#include "traj/record/tube_record.h"

#include <gtest/gtest.h>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "support/reading.h"
#include "traj/record/flight_report.h"

namespace traj {
namespace {

// As skyway-fly writes it.
std::string proved(const std::vector<double>& radius = {0.02, 0.03, 0.01}) {
  FlightReport report{.id = "a", .duration = 0.3, .trajectory = "abc"};
  report.disturbances = Disturbances{.wind = {1, 0, 0}, .wind_spread = 0.2, .gust_most = 0.5};
  report.options.law = ControlLaw::geometric;
  report.proved.radius = radius;
  report.proved.largest = 0.03;
  report.proved.tilt = 0.4;
  report.proved.cells = 2;
  report.provenance.vehicle = geom::Vehicle{"quad", {0.3, 0.3, 0.2}};
  return to_json_line(report, {}, nullptr);
}

std::string with(std::string text, const std::string& part, const std::string& other) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

std::optional<TubeRecord> tube_of(const std::string& json) {
  return parse_tube(json, "flights", 3);
}

TEST(TubeRecord, ReadsTheProvedTubeOfAReport) {
  const auto tube = tube_of(proved());
  ASSERT_TRUE(tube);
  EXPECT_EQ(tube->claim.kind, TubeKind::proved);
  EXPECT_EQ(tube->radius, (std::vector<double>{0.02, 0.03, 0.01}));
  EXPECT_EQ(tube->period, 0.1);
  EXPECT_EQ(tube->claim.largest, 0.03);
  EXPECT_EQ(tube->claim.tilt, 0.4);
  EXPECT_EQ(tube->trajectory, "abc");
  EXPECT_EQ(tube->claim.disturbances->gust_most, 0.5);
  EXPECT_EQ(tube->provenance.vehicle->name, "quad");
  EXPECT_TRUE(tube->refused.empty());
  EXPECT_EQ(tube->claim.model.size(), 64u);
  EXPECT_TRUE(support::says(in_words(tube->claim), "proved for the simulated vehicle (model " +
                                                       tube->claim.model.substr(0, 8) +
                                                       ") under the geometric controller"));
}

TEST(TubeRecord, NamesTheModelThatFlies) {
  const auto tube = tube_of(proved());
  ASSERT_TRUE(tube);
  geom::JsonLine line;
  add(line, tube->claim);
  const TubeClaim back = read_tube_claim(geom::JsonFields(line.object(), "r", 1));
  EXPECT_EQ(back.model, tube->claim.model);
  const auto older = tube_of(with(proved(), R"("model":")" + tube->claim.model + R"(",)", ""));
  ASSERT_TRUE(older);
  EXPECT_TRUE(support::says(in_words(older->claim), "of gains that the report does not name"));
}

// As skyway-fly --runs writes it, without what nobody reads.
const std::string kOfRuns =
    R"({"type":"flight","id":"a","controller":"cascade","monte_carlo":{"lost":0,"tube":{"share":0.999,)"
    R"("period":0.1,"largest":0.3,"tilt":0.2,"trajectory":"abc","radius":[0.2,0.3]}}})";

TEST(TubeRecord, NeverCallsTheTubeOfRunsProved) {
  const auto tube = tube_of(kOfRuns);
  ASSERT_TRUE(tube);
  EXPECT_EQ(tube->claim.kind, TubeKind::statistics);
  EXPECT_EQ(tube->radius, (std::vector<double>{0.2, 0.3}));
  EXPECT_EQ(tube->claim.largest, 0.3);
  const std::string words = in_words(tube->claim);
  EXPECT_TRUE(support::says(words, "not proved"));
  EXPECT_FALSE(support::says(words, "proved for"));
  geom::JsonLine line;
  add(line, tube->claim);
  EXPECT_EQ(line.object(),
            R"({"kind":"statistics","largest":0.3,"tilt":0.2,"controller":"cascade"})");
}

TEST(TubeRecord, IsNothingForAFlightWithoutATube) {
  EXPECT_FALSE(tube_of(R"({"type":"flight","id":"a"})"));
  EXPECT_FALSE(tube_of(R"({"type":"flight","id":"a","monte_carlo":{"lost":3}})"));
}

// Else the statistics beside it would stand for the proof that was asked for.
TEST(TubeRecord, OfARefusedProofHasNoRadius) {
  FlightReport report{.id = "a", .duration = 0.3};
  report.disturbances = Disturbances{};
  report.proved.trouble = TubeTrouble{.kind = TubeTrouble::Kind::motor, .motor = 1};
  std::string text = to_json_line(report, {}, nullptr);
  text = with(text, R"("proved_tube")",
              R"("monte_carlo":{"tube":{"period":0.1,"radius":[0.2]}},"proved_tube")");
  const auto tube = tube_of(text);
  ASSERT_TRUE(tube);
  EXPECT_EQ(tube->refused, "motor");
  EXPECT_TRUE(tube->radius.empty());
}

TEST(TubeRecord, RefusesProvedTubesThatCannotBe) {
  const std::string radius = "[0.02,0.03,0.01]";
  const std::pair<std::string, std::string> changes[] = {
      {radius, "[0.02,null,0.01]"},
      {radius, "[0.02,NaN,0.01]"},
      {radius, "[0.02,1e999,0.01]"},
      {radius, "[0.02,-0.03,0.01]"},
      {radius, "[0.02,0.03,\"0.01\"]"},
      {radius, "[]"},
      {radius, "0.03"},
      {radius, "[0.02,0.01]"},
      {radius, "[0.02,0.04,0.01]"},
      {"\"largest\":0.03", "\"largest\":0.02"},
      {"\"largest\":0.03,", ""},
      {"\"tilt\":0.4", "\"tilt\":7"},
      {"\"tilt\":0.4,", ""},
      {"\"period\":0.1", "\"period\":0.2"},
      {"\"period\":0.1", "\"period\":0"},
      {"\"trajectory\":\"abc\",", ""},
      {"\"controller\":\"geometric\",", ""},
      {"\"gust_most\":0.5", "\"gust_most\":-1"},
      {"\"wind_spread\":0.2,", ""},
      {"\"proved_tube\":{\"ok\":true", "\"proved_tube\":{\"ok\":1"},
      {"\"proved_tube\":{\"ok\":true", "\"proved_tube\":{\"ok\":true,\"rain\":0.1"},
      {"\"proved_tube\":{\"ok\":true", "\"proved_tube\":{\"ok\":false"},
  };
  for (const auto& [part, other] : changes) {
    const std::string text = with(proved(), part, other);
    EXPECT_TRUE(support::says(support::refusal_of([&] { tube_of(text); }), "flights:3"))
        << part << " -> " << other;
  }
  const std::string whole = proved();
  for (std::size_t n = 0; n + 2 < whole.size(); n += 7) {
    EXPECT_NE(support::refusal_of([&] { tube_of(whole.substr(0, n)); }), "") << "cut at " << n;
  }
}

TEST(TubeRecord, RefusesTubesOfRunsThatCannotBe) {
  const std::pair<std::string, std::string> changes[] = {
      {"\"period\":0.1", "\"period\":0"},
      {"\"period\":0.1", "\"period\":\"0.1\""},
      {"[0.2,0.3]", "[]"},
      {"[0.2,0.3]", "2"},
      {"[0.2,0.3]", "[0.2,\"0.3\"]"},
      {"[0.2,0.3]", "[-0.2,0.3]"},
      {"[0.2,0.3]", "[0.2,0.4]"},
      {"\"largest\":0.3,", ""},
      {"\"tilt\":0.2,", ""},
      {"\"trajectory\":\"abc\",", ""},
      {"\"controller\":\"cascade\",", ""},
      {"\"lost\":0", "\"lost\":1"},
      {"\"lost\":0", "\"lost\":\"0\""},
      {"\"tube\":{", "\"tube\":3,\"other\":{"},
  };
  for (const auto& [part, other] : changes) {
    const std::string text = with(kOfRuns, part, other);
    EXPECT_TRUE(support::says(support::refusal_of([&] { tube_of(text); }), "flights:3"))
        << part << " -> " << other;
  }
}

}  // namespace
}  // namespace traj
