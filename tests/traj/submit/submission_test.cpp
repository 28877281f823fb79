#include "traj/submit/submission.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "traj/submit/summary_page.h"

namespace {

traj::Submission submission() {
  traj::Submission out{.made_by = "skyway 1", .missions = {"a.plan"}, .flights = 2};
  out.method.made_for = {"sha256:00", geom::Axes::enu, {}, 0.5};
  out.method.origin = {47.4, 8.5, 400};
  out.method.limits[traj::Limit::speed] = 9;
  out.method.risk.dimension = 0.7;
  out.method.navigation = traj::Uncertainty{0.5, 1};
  out.method.energy = traj::Energy{1000, 100, 0.2, 0};
  out.method.begins = "2026-05-04T06:30:00Z";
  out.population = traj::SourceFile{"pop.tif", "ab"};
  out.zones = {{"zones.json", "cd", "2026-01-01"}};
  return out;
}

TEST(Submission, ComesBackAsItWasWritten) {
  for (const auto rule : {traj::ContingencyRule::stop, traj::ContingencyRule::ways_home}) {
    traj::Submission out = submission();
    out.method.risk.contingency = rule;
    const std::string text = traj::to_json_line(out);
    EXPECT_EQ(traj::to_json_line(traj::read_submission(text, "s")), text);
  }
}

traj::TubeClaim tube() {
  return {traj::TubeKind::proved, 0.031, 0.4, traj::ControlLaw::geometric,
          traj::Disturbances{.gust_most = 0.5}};
}

TEST(Submission, NamesTheTubesThatItsVolumesHold) {
  traj::Submission out = submission();
  out.method.tubes = traj::SourceFile{"proved.jsonl", "ef"};
  out.method.risk.geography = traj::GeographyRule::proved_tube;
  const std::string text = traj::to_json_line(out);
  EXPECT_NE(text.find(R"("tubes":{"name":"proved.jsonl","sha256":"ef"})"), std::string::npos);
  EXPECT_NE(text.find("the simulated vehicle in its proved tube"), std::string::npos);
  EXPECT_EQ(traj::to_json_line(traj::read_submission(text, "s")), text);
}

TEST(Submission, NamesTheGroundOfMissionsAboveTerrain) {
  traj::Submission out = submission();
  out.method.ground_model = traj::SourceFile{"hill.ground", "ef"};
  out.method.terrain_error = 16;
  const std::string text = traj::to_json_line(out);
  const std::string part =
      R"("ground_model":{"name":"hill.ground","sha256":"ef"},"terrain_error":16)";
  ASSERT_NE(text.find(part), std::string::npos);
  EXPECT_EQ(traj::to_json_line(traj::read_submission(text, "s")), text);
  const auto with = [&](const char* other) {
    std::string changed = text;
    return changed.replace(changed.find(part), part.size(), other);
  };
  EXPECT_THROW(
      traj::read_submission(with(R"("ground_model":{"name":"hill.ground","sha256":"ef"})"), "s"),
      geom::InputError)
      << "an error of 0 is said";
  const std::string alone = with(R"("terrain_error":16)");
  EXPECT_NE(traj::to_json_line(traj::read_submission(alone, "s")), alone)
      << "so that the check refuses it";
}

TEST(Submission, IsRefusedWithoutWhatItNeeds) {
  EXPECT_THROW(traj::read_submission("{}", "s"), geom::InputError);
  EXPECT_THROW(traj::read_submission(R"({"type":"submission","made_by":"x"})", "s"),
               geom::InputError);
}

TEST(FlightClaims, ComeBackAsTheyWereWritten) {
  traj::FlightClaims claims{.id = "q1", .kind = "trajectory", .volumes = "v", .risk = "r"};
  claims.duration = 12.5;
  claims.clearance = 0.3;
  claims.people = 4;
  claims.people_unknown = 1;
  const std::string text = traj::to_json_line(claims);
  EXPECT_EQ(traj::to_json_line(traj::parse_flight_claims(text, "c", 1)), text);
}

TEST(FlightClaims, ComeBackWithTheirTube) {
  traj::FlightClaims claims{.id = "q1", .kind = "trajectory", .volumes = "v", .risk = "r"};
  claims.tube = tube();
  const std::string text = traj::to_json_line(claims);
  EXPECT_EQ(traj::to_json_line(traj::parse_flight_claims(text, "c", 1)), text);
  for (const auto& [part, other] : {std::pair("\"largest\":0.031", "\"largest\":-1"),
                                    {"\"kind\":\"proved\"", "\"kind\":\"sure\""},
                                    {"\"gust_most\":0.5,", ""},
                                    {"\"gust_most\":0.5", "\"gust_most\":0.5,\"rain\":1"}}) {
    std::string changed = text;
    changed.replace(changed.find(part), std::string_view(part).size(), other);
    EXPECT_THROW(traj::parse_flight_claims(changed, "c", 1), geom::InputError) << other;
  }
}

TEST(FlightClaims, ComeBackWithTheirTerrain) {
  traj::FlightClaims claims{.id = "q1", .kind = "mission", .volumes = "v", .risk = "r"};
  claims.terrain = traj::TerrainClaim{"sha256:ab", 16, 100, 10, 80};
  const std::string text = traj::to_json_line(claims);
  EXPECT_EQ(traj::to_json_line(traj::parse_flight_claims(text, "c", 1)), text);
}

TEST(SummaryPage, SaysWhatHeightsAboveTerrainRestOn) {
  traj::Submission out = submission();
  out.method.ground_model = traj::SourceFile{"hill.ground", "ef"};
  out.method.terrain_error = 16;
  traj::FlightClaims claims{.id = "q1", .kind = "mission", .begins = "2026-05-04T06:30:00Z"};
  claims.terrain = traj::TerrainClaim{"sha256:ab", 16, 30, 10, 80.25};
  const std::string html = traj::summary_page({}, out, {&claims, 1});
  for (const char* part : {"within 16 m of the ground at its posts, 30 m apart", "hill.ground",
                           "up to 10 m behind its terrain", "a band of heights of up to 80.2 m"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(traj::summary_page({}, submission(), {}).find("Heights above terrain"),
            std::string::npos);
}

// What is simulated, believed and assumed stands on the page.
TEST(SummaryPage, SaysWhatATubeIs) {
  traj::Submission out = submission();
  out.method.tubes = traj::SourceFile{"proved.jsonl", "ef"};
  out.method.buffer = 2;
  traj::FlightClaims claims{.id = "q1", .kind = "trajectory", .begins = "2026-05-04T06:30:00Z"};
  claims.tube = tube();
  const traj::Operation operation{.by = {"Ann", "AUT1"}, .lost_link = "returns"};
  const std::string html = traj::summary_page(operation, out, {&claims, 1});
  for (const char* part : {"a tube of at most 0.031 m", "the simulated vehicle never leaves it",
                           "gusts towards at most 0.5 m/s", "or strays 2 m more.", "proved.jsonl",
                           "does not prove them again"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(html.find("by no more than the margin"), std::string::npos);
}

TEST(SummaryPage, SaysWhoFliesAndWhatIsNotProved) {
  traj::Operation operation{.by = {"Ann <Air>", "AUT1"}, .lost_link = "returns"};
  traj::FlightClaims claims{.id = "q\"1", .kind = "trajectory", .begins = "2026-05-04T06:30:00Z"};
  const std::string html = traj::summary_page(operation, submission(), {&claims, 1});
  for (const char* part : {"Ann &lt;Air&gt;", "AUT1", "q&quot;1", "What was assumed", "zones.json",
                           "pop.tif", "S_GRB"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  for (const char* outside : {"http:", "https:", "<script", "src=", "@import"}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
}

TEST(SummaryPage, HasThoseFlightsOfVeryManyThatMatterMost) {
  std::vector<traj::FlightClaims> claims(3 * traj::kMostRows);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    claims[i].id = "flight-" + std::to_string(i);
    claims[i].kind = "trajectory";
    claims[i].people = static_cast<double>(i);
  }
  const std::string html = traj::summary_page({}, submission(), claims);
  EXPECT_NE(html.find(">flight-299<"), std::string::npos);
  EXPECT_EQ(html.find(">flight-199<"), std::string::npos);
}

}  // namespace
