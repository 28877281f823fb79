#include "geom/vehicle/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "geom/base/error.h"
#include "geom/record/record.h"
#include "geom/text/json_fields.h"
#include "support/cases.h"
#include "support/reading.h"

namespace geom {
namespace {

// Of each field the k-th number in the list (0: none).
Limits with(double vmax, double vmax_v, double tilt) {
  Limits out;
  if (vmax > 0) out[Limit::speed] = vmax;
  if (vmax_v > 0) out[Limit::vertical_speed] = vmax_v;
  if (tilt > 0) out[Limit::tilt] = tilt;
  return out;
}

TEST(Limits, HoldStricterOfEach) {
  EXPECT_EQ(limits_that_hold({with(8, 0, 0), with(0, 3, 0), with(12, 4, 0.6)}), with(8, 3, 0.6));
  EXPECT_EQ(limits_that_hold({with(30, 30, 1), {}, with(12, 4, 0.6)}), with(12, 4, 0.6));
  EXPECT_EQ(limits_that_hold({}), Limits{});
}

TEST(Limits, AreLoosenedByOverridingAloneAndOnlyWhereOptionsNameThem) {
  const LimitSources sources{with(30, 0, 0), with(8, 3, 0), with(12, 4, 0.6), true};
  EXPECT_EQ(limits_that_hold(sources), with(30, 3, 0.6));
}

TEST(Limits, NeverTiltBeyondWhatTheBoxHolds) {
  EXPECT_EQ(limits_that_hold({with(0, 0, 1), {}, with(0, 0, 0.6), true})[Limit::tilt], 0.6);
  EXPECT_EQ(limits_that_hold({with(0, 0, 1), {}, {}, true})[Limit::tilt],
            1);  // it holds every attitude
}

TEST(Limits, NameTheFirstThatIsAbove) {
  EXPECT_EQ(first_above(with(8, 0, 0), with(8, 4, 0)), std::nullopt);
  EXPECT_EQ(first_above(with(9, 5, 0), with(8, 4, 0)), Limit::speed);
  EXPECT_EQ(first_above(with(9, 0, 0), {}), std::nullopt);
}

// --- as they travel -----------------------------------------------------------------------------

PathRecord through_a_line(const PathRecord& record) {
  return parse_path_record(to_json_line(record), "line", 1);
}

TEST(Limits, TravelWithTheVehicleOfARecord) {
  PathRecord record;
  record.id = "q1";
  record.status = PathStatus::found;
  record.points = {{0, 0, 0}};
  record.provenance.vehicle = {"quad", {1, 1, 1}, with(12, 4, 0.6)};
  EXPECT_EQ(through_a_line(record).provenance.vehicle, record.provenance.vehicle);
  record.provenance.vehicle->limits = {};
  EXPECT_FALSE(support::says(to_json_line(record), "limits"));
}

TEST(Limits, OfARecordAreWhatItSays) {
  const auto read = [](const char* json) { return read_limits(JsonFields(json, "r.jsonl", 3)); };
  EXPECT_EQ(read("{}"), Limits{});
  EXPECT_EQ(read(R"({"limits":{"vmax":8,"tilt":1.5,"thrust":9.8067}})"),
            (Limits{{Limit::speed, 8}, {Limit::tilt, 1.5}, {Limit::thrust, 9.8067}}));
  EXPECT_THROW(read(R"({"limits":{"tilt":1.5708}})"), InputError);
  EXPECT_THROW(read(R"({"limits":{"thrust":9.80665}})"), InputError);
}

TEST(Limits, OfARecordAreObeyedOrRefused) {
  const auto refusal = [](const std::string& limits) {
    return support::refusal_of(
        [&] { read_limits(JsonFields("{\"limits\":" + limits + "}", "r.jsonl", 3)); });
  };
  EXPECT_EQ(refusal(R"({"vmax":8})"), "");
  EXPECT_TRUE(support::says(refusal(R"({"vmx":8})"), "limits has \"vmx\", which is no limit"));
  EXPECT_TRUE(support::says(refusal(R"({"vmax":0})"), "limits.vmax must be > 0, found 0"));
  EXPECT_TRUE(support::says(refusal(R"({"vmax":null})"), "limits.vmax must be a finite number"));
  EXPECT_TRUE(support::says(refusal(R"({"tilt":1.6})"), "below a right angle"));
  EXPECT_TRUE(support::says(refusal(R"({"thrust":9})"), "limits.thrust must be > 9.80665"));
  EXPECT_TRUE(support::says(refusal("8"), "limits must be an object, found 8"));
  EXPECT_THROW(
      parse_path_record(R"({"type":"path","id":"q","points":[[0,0,0]],"vehicle":{"half":[1,1,1],)"
                        R"("limits":{"climb":4}}})",
                        "r.jsonl", 1),
      std::exception);
}

// --- no limit is lost, whoever says it ----------------------------------------------------------

class RandomLimits {
 public:
  explicit RandomLimits(std::uint64_t seed) : engine_(seed) {}

  Limits next() {
    Limits out;
    for (std::optional<double>& limit : out.values) {
      if (coin()) limit = 0.25 + 0.25 * static_cast<double>(engine_() % 5);
    }
    if (out[Limit::thrust]) *out[Limit::thrust] += kGravity;
    return out;
  }
  bool coin() { return engine_() % 2; }

 private:
  std::mt19937_64 engine_;
};

// What the words in limits.h say, a limit at a time.
std::optional<double> oracle(const LimitSources& sources, Limit limit) {
  const auto& asked = sources.options[limit];
  std::vector<double> said;
  if (!asked || !sources.overridden) {
    for (const Limits* who : {&sources.record, &sources.vehicle}) {
      if ((*who)[limit]) said.push_back(*(*who)[limit]);
    }
  }
  if (asked) said.push_back(*asked);
  if (limit == Limit::tilt && sources.vehicle[Limit::tilt]) {
    said.push_back(*sources.vehicle[Limit::tilt]);
  }
  if (said.empty()) return std::nullopt;
  return *std::min_element(said.begin(), said.end());
}

TEST(Limits, HoldWhateverSaysThem) {
  constexpr std::uint64_t kSeed = 15;
  RandomLimits random(kSeed);
  for (int i = 0; i < support::cases(20000); ++i) {
    PathRecord record;
    record.id = "q1";
    record.status = PathStatus::found;
    record.points = {{0, 0, 0}};
    record.provenance.vehicle = {"v", {1, 1, 1}, random.next()};
    const LimitSources sources{random.next(), random.next(),
                               through_a_line(record).provenance.vehicle->limits, random.coin()};
    ASSERT_EQ(sources.vehicle, record.provenance.vehicle->limits);
    const Limits held = limits_that_hold(sources);
    for (const LimitKind& kind : kLimitKinds) {
      ASSERT_EQ(held[kind.limit], oracle(sources, kind.limit))
          << kind.name << ", seed " << kSeed << ", case " << i;
    }
    if (!sources.overridden) {
      for (const Limits* who : {&sources.options, &sources.record, &sources.vehicle}) {
        ASSERT_EQ(stricter(held, *who), held) << "seed " << kSeed << ", case " << i;
      }
    }
  }
}

}  // namespace
}  // namespace geom
