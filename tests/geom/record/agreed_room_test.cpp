#include "geom/record/agreed_room.h"

#include <gtest/gtest.h>

#include <random>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "support/cases.h"
#include "support/reading.h"

namespace geom {
namespace {

using support::says;

Limits vmax(double value) {
  Limits out;
  out[Limit::speed] = value;
  return out;
}

Vehicle quad(const Limits& limits = {}, double half = 1) {
  return {"quad", Vec3::Constant(half), limits};
}

Provenance record_of(const std::optional<Vehicle>& vehicle,
                     const std::optional<double>& margin = {}) {
  return {{}, {}, vehicle, margin};
}

Room agreed(const Provenance& record, const AskedRoom& asked, Differences differences) {
  return agreed_room(record, asked, differences, "paths.jsonl", 7);
}

std::string refusal(const Provenance& record, const AskedRoom& asked,
                    Differences differences = Differences::refused) {
  return support::refusal_of([&] { agreed(record, asked, differences); });
}

TEST(AgreedRoom, IsTheRecordsWhereTheOptionsSayNothing) {
  const Room room = agreed(record_of(quad(vmax(12)), 0.5), {}, Differences::refused);
  EXPECT_EQ(room.vehicle, quad(vmax(12)));
  EXPECT_EQ(room.margin, 0.5);
  EXPECT_THROW(agreed(record_of({}), {}, Differences::refused), UsageError);
}

TEST(AgreedRoom, IsTheOptionsWhereTheRecordSaysNothing) {
  const Room room = agreed(record_of({}), {quad(vmax(12)), 0.5}, Differences::refused);
  EXPECT_EQ(room.vehicle, quad(vmax(12)));
  EXPECT_EQ(room.margin, 0.5);
  // A record from before vehicles had limits, and a box that says none.
  EXPECT_EQ(agreed(record_of(quad()), {quad(vmax(12)), {}}, Differences::refused).vehicle.limits,
            vmax(12));
  EXPECT_EQ(agreed(record_of(quad(vmax(12))), {quad(), {}}, Differences::refused).vehicle.limits,
            vmax(12));
}

TEST(AgreedRoom, RefusesOtherLimitsAndNamesBoth) {
  const std::string said = refusal(record_of(quad(vmax(8))), {quad(vmax(12)), {}});
  EXPECT_TRUE(says(
      said, "paths.jsonl:7: expected the vehicle quad with vmax 12 m/s, as asked, found 8 m/s"));
  Limits other;
  other[Limit::acceleration] = 5;
  EXPECT_TRUE(says(refusal(record_of(quad(vmax(8))), {quad(other), {}}), "vmax unlimited"));
}

TEST(AgreedRoom, HoldsTheStricterLimitsOfBothInACheck) {
  const auto stricter = Differences::stricter_allowed;
  for (const double asked : {8.0, 12.0}) {
    EXPECT_EQ(
        agreed(record_of(quad(vmax(20 - asked))), {quad(vmax(asked)), {}}, stricter).vehicle.limits,
        vmax(8));
  }
  EXPECT_EQ(agreed(record_of(quad(vmax(8))), {quad({}, 2), {}}, stricter).vehicle.limits, vmax(8));
}

TEST(AgreedRoom, OverriddenIsTheOptions) {
  const Room room =
      agreed(record_of(quad(vmax(8), 2), 1), {quad(vmax(12)), 0}, Differences::allowed);
  EXPECT_EQ(room.vehicle, quad(vmax(12)));
  EXPECT_EQ(room.margin, 0);
  EXPECT_TRUE(smaller_than_asked(room, record_of(quad(vmax(8), 2), 1)));
  EXPECT_FALSE(smaller_than_asked(room, record_of(quad())));
}

TEST(AgreedRoom, KeepsTheMarginOfARecordThatNamesNoVehicle) {
  EXPECT_TRUE(says(refusal(record_of({}, 0.5), {quad(), 0.1}), "with margin 0.5"));
  EXPECT_NE(refusal(record_of({}, 0.5), {quad(), 0.1}, Differences::stricter_allowed), "");
  EXPECT_EQ(agreed(record_of({}, 0.5), {quad(), {}}, Differences::refused).margin, 0.5);
}

TEST(AgreedRoom, HasLessMarginByWhatIsToSpareAndNoMore) {
  const auto record = record_of(quad(), 0.5);
  EXPECT_EQ(agreed(record, {{}, {}, 0.125}, Differences::refused).margin, 0.375);
  EXPECT_EQ(agreed(record, {quad(), 0.5, 0.5}, Differences::refused).margin, 0);
  EXPECT_EQ(agreed(record, {{}, 1, 0.5}, Differences::stricter_allowed).margin, 0.5);
  EXPECT_TRUE(says(refusal(record, {{}, {}, 0.75}),
                   "paths.jsonl:7: expected a margin of 0.75 m or more, which --spare takes from "
                   "it, found 0.5 m"));
  // It takes from the margin that is agreed on, and makes no other margin agree.
  EXPECT_NE(refusal(record, {quad(), 0.4, 0.1}), "");
  EXPECT_EQ(agreed(record, {{}, {}, 0.125}, Differences::refused).vehicle, quad());
}

TEST(AgreedRoom, NeverHasLessRoomOrLooserLimitsThanEither) {
  constexpr std::uint64_t kSeed = 15;
  std::mt19937_64 random(kSeed);
  const auto some = [&] { return 1 + static_cast<double>(random() % 3); };
  const auto limits = [&] { return random() % 2 ? vmax(some()) : Limits{}; };
  int passed = 0;
  for (int i = 0; i < support::cases(10000); ++i) {
    const Vehicle had = quad(limits(), some());
    const AskedRoom asked{quad(limits(), some()),
                          random() % 2 ? std::optional(some()) : std::nullopt};
    const double margin = some();
    Room room;
    try {
      room = agreed(record_of(had, margin), asked, Differences::stricter_allowed);
    } catch (const InputError&) {
      continue;
    }
    ++passed;
    ASSERT_GE(room.vehicle.half.x() + room.margin, had.half.x() + margin) << "case " << i;
    ASSERT_GE(room.vehicle.half.x(), asked.vehicle->half.x()) << "case " << i;
    const Limits& held = room.vehicle.limits;
    ASSERT_EQ(stricter(held, had.limits), held) << "case " << i;
    ASSERT_EQ(stricter(held, asked.vehicle->limits), held) << "case " << i;
  }
  EXPECT_GT(passed, 3000);
}

// --- what is solved and checked for -------------------------------------------------------------

TEST(LimitsToSolve, RefuseMoreThanTheVehicleMayDoAndNameBoth) {
  Limits asked = vmax(30);
  asked[Limit::acceleration] = 6;
  std::string said;
  try {
    limits_to_solve(asked, quad(vmax(12)));
  } catch (const UsageError& error) {
    said = error.what();
  }
  EXPECT_TRUE(says(said, "vmax: asked for 30 m/s, but the vehicle quad may do at most 12 m/s"));
  asked[Limit::speed] = 8;
  EXPECT_EQ(limits_to_solve(asked, quad(vmax(12)))[Limit::speed], 8);
  asked[Limit::speed].reset();
  EXPECT_EQ(limits_to_solve(asked, quad(vmax(12)))[Limit::speed], 12);
}

TEST(LimitsToCheck, RefuseToTiltBeyondTheBox) {
  Limits asked;
  Limits held;
  asked[Limit::tilt] = 1;
  held[Limit::tilt] = 0.5;
  EXPECT_THROW(limits_to_check({asked, {}, held, true}, "quad"), UsageError);
  EXPECT_EQ(limits_to_check({asked, {}, held, false}, "quad")[Limit::tilt], 0.5);
}

}  // namespace
}  // namespace geom
