// Tracks that real autopilots flew, against what the check says of their missions.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "flown_return.h"
#include "flown_track.h"
#include "traj/scenes.h"

namespace firmware {
namespace {

std::vector<Flight> flights() {
  std::vector<Flight> out = read_flights(SKYWAY_SOURCE_DIR "/tests/firmware/tracks/flights.csv");
  const char* const shared = std::getenv("SKYWAY_REALDATA");
  if (!shared || !std::filesystem::exists(std::string(shared) + "/flown")) return out;
  for (Flight& one : read_flights(SKYWAY_SOURCE_DIR "/tests/firmware/shared_flights.csv")) {
    const std::string folder = std::string(shared) + "/flown/";
    const auto moved = [&](const std::string& path) {
      return folder + std::filesystem::path(path)
                          .lexically_relative(SKYWAY_SOURCE_DIR "/tests/firmware")
                          .string();
    };
    one.track = moved(one.track);
    one.mission = moved(one.mission);
    out.push_back(one);
  }
  return out;
}

class Flown : public ::testing::TestWithParam<Flight> {};

TEST_P(Flown, StaysInsideTheClaim) {
  const Replay flight = replay(GetParam());
  ASSERT_GT(flight.samples.size(), 10u);
  for (const Sample& sample : flight.samples) {
    EXPECT_EQ(outside(GetParam(), flight, sample.place), 0)
        << "at " << sample.time << " s, " << sample.place.transpose();
  }
}

// A vehicle so small that only its track counts, over flat ground, and ground as high as the landing.
geom::CollisionScene scene_with(const Vec3& cube, const traj::Flown& file) {
  const Vec3 half = Vec3::Constant(0.01);
  const traj::FlownLegs& legs = *traj::legs_of(file);
  const double landing = legs.ends.landing_on.value_or(0);
  const Vec3 aside(50, 50, 0);
  const Vec3 foot(legs.path.back().x(), legs.path.back().y(), 0);
  std::vector<geom::Aabb> boxes{{cube - half, cube + half}};
  const double floor = std::min(0.0, landing);
  if (landing > floor) {
    boxes.push_back({foot - aside + Vec3(0, 0, floor), foot + aside + Vec3(0, 0, landing)});
  }
  const geom::BoxMap map =
      traj::testing::scene_of(boxes, {{-9000, -9000, floor}, {9000, 9000, 2000}}).map();
  return {map, {"point", Vec3::Constant(1e-3)}, 0};
}

// Wherever it was in the air, a cube there turns the verdict.
TEST_P(Flown, ACubeOnItsTrackIsACollision) {
  const Replay flight = replay(GetParam());
  const traj::Flown file = flown(GetParam(), flight);
  const Vec3 away(-3000, -3000, 100);
  const auto alone =
      judge(scene_with(away, file), file, {}, traj::Clearance::left_out);
  if (!alone.ok) {  // so low that the autopilot may stray to the ground
    EXPECT_NE(alone.strayed, "");
    EXPECT_EQ(alone.reason, traj::Reason::bounds);
    return;
  }
  const std::size_t step = std::max<std::size_t>(1, flight.samples.size() / 60);
  for (std::size_t i = 0; i < flight.samples.size(); i += step) {
    const Vec3& place = flight.samples[i].place;
    if (place.z() < 0.5) continue;
    const auto result =
        judge(scene_with(place, file), file, {}, traj::Clearance::left_out);
    EXPECT_EQ(result.reason, traj::Reason::collision)
        << "at " << flight.samples[i].time << " s, " << place.transpose();
  }
}

std::string name_of(const ::testing::TestParamInfo<Flight>& info) {
  std::string out = info.param.autopilot + "_" + info.param.name;
  for (char& c : out) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return out + "_" + std::to_string(info.index);
}

// --- returns --------------------------------------------------------------------------------

class ReturnFlown : public ::testing::TestWithParam<FlownReturn> {};

TEST_P(ReturnFlown, StaysInsideTheClaim) {
  const ReturnClaim claim = claim_of(GetParam());
  const auto ways = ways_of(GetParam(), claim, stages_there(claim));
  const std::vector<Sample> samples = samples_after(GetParam(), claim);
  ASSERT_GT(samples.size(), 50u);
  for (const Sample& sample : samples) {
    EXPECT_EQ(exit_of(claim, ways, sample.place).outside, 0)
        << "at " << sample.time << " s, " << sample.place.transpose();
  }
}

// Over flat ground, for a vehicle so small that only its track counts.
std::vector<traj::ReturnGap> gaps_with(const Vec3& cube, const ReturnClaim& claim) {
  const Vec3 half = Vec3::Constant(0.01);
  const geom::BoxMap map =
      traj::testing::scene_of({{cube - half, cube + half}}, {{-9000, -9000, 0}, {9000, 9000, 2000}})
          .map();
  const geom::CollisionScene scene(map, {"point", Vec3::Constant(1e-3)}, 0);
  const std::vector<traj::FlightStage> stages = stages_there(claim);
  return traj::prove_return(scene, {&stages, 1}, claim.task).gaps;
}

TEST_P(ReturnFlown, ACubeOnItsTrackIsAGap) {
  const ReturnClaim claim = claim_of(GetParam());
  ASSERT_TRUE(gaps_with({-3000, -3000, 100}, claim).empty());
  const std::vector<Sample> samples = samples_after(GetParam(), claim);
  const std::size_t step = std::max<std::size_t>(1, samples.size() / 40);
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const Vec3& place = samples[i].place;
    if (place.z() < 0.5) continue;
    EXPECT_FALSE(gaps_with(place, claim).empty())
        << "at " << samples[i].time << " s, " << place.transpose();
  }
}

std::string name_of_return(const ::testing::TestParamInfo<FlownReturn>& info) {
  std::string out = info.param.flight.name;
  for (char& c : out) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return out;
}

INSTANTIATE_TEST_SUITE_P(
    Tracks, ReturnFlown,
    ::testing::ValuesIn(read_returns(SKYWAY_SOURCE_DIR "/tests/firmware/tracks/returns.csv")),
    name_of_return);

INSTANTIATE_TEST_SUITE_P(Tracks, Flown, ::testing::ValuesIn(flights()), name_of);

}  // namespace
}  // namespace firmware
