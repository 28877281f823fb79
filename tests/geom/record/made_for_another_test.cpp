#include "geom/record/made_for_another.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

Provenance provenance() {
  return {"sha256:1", Axes::enu, Vehicle{"drone", {0.123456789, 1, 2}, {}}, 0.5};
}

TEST(MadeForAnother, SaysNothingWhereAllAgrees) {
  EXPECT_EQ(made_for_another(provenance(), provenance()), std::nullopt);
}

TEST(MadeForAnother, NamesBothValuesOfWhatDiffersFirst) {
  Provenance other = provenance();
  other.margin = 0;
  EXPECT_EQ(made_for_another(other, provenance()), "made for another margin, 0 m, not 0.5 m");
  other.vehicle->name = "box:1,1,1";
  other.vehicle->half = {1, 1, 1};
  EXPECT_EQ(made_for_another(other, provenance()),
            "made for another vehicle, box:1,1,1 (half sizes 1, 1, 1 m), not drone (half sizes "
            "0.1235, 1, 2 m)");
  other.frame = Axes::neu;
  EXPECT_EQ(made_for_another(other, provenance()), "made for another frame, neu, not enu");
  other.map.reset();
  EXPECT_EQ(made_for_another(other, provenance()), "made for another map, none, not sha256:1");
}

TEST(MadeForAnother, GivesAllDigitsWhereFewHideTheDifference) {
  Provenance other = provenance();
  other.vehicle->half.x() = 0.123456788;
  EXPECT_EQ(made_for_another(other, provenance()),
            "made for another vehicle, drone (half sizes 0.123456788, 1, 2 m), not drone (half "
            "sizes 0.123456789, 1, 2 m)");
}

TEST(MadeForAnother, SaysOfWhatAQueryIsAskedWhereNobodySaysWhichIsOurs) {
  const auto refusal = [](const Provenance& asked, const Provenance& ours) {
    return support::refusal_of([&] { require_asked_of(asked, ours, "q.jsonl", 2); });
  };
  EXPECT_EQ(refusal({}, {}), "");
  EXPECT_EQ(refusal({.margin = 0.5}, provenance()), "");
  EXPECT_EQ(refusal({.margin = 30}, provenance()),
            "q.jsonl:2: made for another margin, 30 m, not 0.5 m: ask for that one, or take it out "
            "of the record");
  EXPECT_EQ(refusal({.margin = 30}, {}),
            "q.jsonl:2: asked of the margin 30 m, and nobody says which is ours: give the scene "
            "that it is asked of");
}

}  // namespace
}  // namespace geom
