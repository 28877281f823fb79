#include "cloud/las_references.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "support/reading.h"

namespace geom {
namespace {

const std::string kUser = "LASF_Projection";

std::string keys(std::uint16_t unit) {  // a projected system whose unit this is
  const std::uint16_t values[] = {1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, unit};
  return {reinterpret_cast<const char*>(values), sizeof values};
}
const std::string kMetres = keys(9001);
const std::string kFeet = keys(9003);

// A record as it stands after the points.
std::string later(const std::string& user, std::uint16_t id, const std::string& data) {
  std::string out(60, '\0');
  const std::uint64_t length = data.size();
  std::copy(user.begin(), user.end(), out.begin() + 2);
  std::memcpy(out.data() + 18, &id, 2);
  std::memcpy(out.data() + 20, &length, 8);
  return out + data;
}

LasReferences told(const std::vector<std::string>& all) {
  LasReferences out("t.las");
  for (const std::string& data : all) out.take(kUser, 34735, data);
  return out;
}

std::string refusal_of_tail(const LasReferences& before, const std::string& tail,
                            std::size_t piece) {
  return support::refusal_of([&] {
    LaterReferences looks(before, false);
    for (std::size_t at = 0; at < tail.size(); at += piece) {
      const std::string some = tail.substr(at, piece);
      looks.take({reinterpret_cast<const unsigned char*>(some.data()), some.size()});
    }
    looks.finish();
  });
}

TEST(LasReferences, RefuseTwoRecordsThatDiffer) {
  EXPECT_DOUBLE_EQ(*told({kMetres, kMetres}).reference(false).plane, 1);
  EXPECT_TRUE(support::says(support::refusal_of([&] { told({kFeet, kMetres}); }), "and differ"));
  EXPECT_TRUE(support::says(support::refusal_of([&] {
                              LasReferences out("t.las");
                              out.take(kUser, 2112, "PROJCS[\"a\"]");
                              out.take(kUser, 2112, "PROJCS[\"b\"]");
                            }),
                            "and differ"));
}

TEST(LasReferences, RefuseATransformOfThePoints) {
  const std::string found = support::refusal_of(
      [&] { LasReferences("t.las").take(kUser, 2111, "PARAM_MT[\"Affine\"]"); });
  EXPECT_TRUE(support::says(found, "2111"));
}

TEST(LaterReferences, SeeARecordWhateverStandsBeforeIt) {
  const std::string other = later("someone", 7, std::string(40, 'x'));
  const std::string record = later(kUser, 34735, kFeet);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{17}, std::size_t{1000}}) {
    for (const std::string& tail : {record, other + record, "odd" + record, record + other}) {
      EXPECT_TRUE(support::says(refusal_of_tail(told({}), tail, piece), "after its points"));
      EXPECT_TRUE(support::says(refusal_of_tail(told({kMetres}), tail, piece), "and differ"));
      EXPECT_EQ(refusal_of_tail(told({kFeet}), tail, piece), "");
    }
    EXPECT_EQ(refusal_of_tail(told({}), other + later(kUser, 7, "x"), piece), "");
    EXPECT_EQ(refusal_of_tail(told({}), record.substr(0, 20), piece), "");
  }
}

}  // namespace
}  // namespace geom
