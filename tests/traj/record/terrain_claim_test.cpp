#include "traj/record/terrain_claim.h"

#include <gtest/gtest.h>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "support/reading.h"

namespace traj {
namespace {

const TerrainClaim kClaim{"sha256:ab", 9, 100, 10, 43.5};

std::string text_of(const TerrainClaim& claim) {
  geom::JsonLine line;
  add(line, claim);
  return line.line();
}

TEST(TerrainClaim, ComesBackAsItWasWritten) {
  const std::string text = text_of(kClaim);
  EXPECT_EQ(text, R"({"model":"sha256:ab","error":9,"spacing":100,"lag":10,"band":43.5})"
                  "\n");
  EXPECT_EQ(text_of(read_terrain_claim({text, "c", 1})), text);
}

TEST(TerrainClaim, ThatFollowsTheSurfaceHasItsBandAlone) {
  const TerrainClaim claim{.model = "flat", .band = 31, .surface = {{40, 70.5}}};
  const std::string text = text_of(claim);
  EXPECT_EQ(text, R"({"model":"flat","surface_band":[40,70.5],"band":31})"
                  "\n");
  EXPECT_EQ(text_of(read_terrain_claim({text, "c", 1})), text);
  const auto refusal = [](const std::string& inside) {
    const std::string other = R"({"model":"flat","band":31,)" + inside + "}";
    return support::refusal_of([&] { read_terrain_claim({other, "c", 1}); });
  };
  EXPECT_EQ(refusal(R"("surface_band":[40,70],"lag":3)"),
            "c:1: lag must be none beside surface_band, found 3");
  for (const char* wrong : {"[0,70]", "[70,40]", "[40]", "[40,10001]", "[40,50,60]"}) {
    EXPECT_EQ(refusal(std::string(R"("surface_band":)") + wrong),
              std::string("c:1: surface_band must be [low, high], 0 < low <= high <= 10000, "
                          "found ") +
                  wrong);
  }
  EXPECT_NE(refusal(R"("surface_band":["a",3])"), "");
}

TEST(TerrainClaim, RefusesWhatIsMissingOrIsNoLength) {
  const auto refusal = [](const std::string& text) {
    return support::refusal_of([&] { read_terrain_claim({text, "c", 1}); });
  };
  EXPECT_EQ(refusal(R"({"model":"m","error":9,"spacing":100,"lag":10})"),
            "c:1: band must be metres from 0 to 1e6, found none");
  EXPECT_EQ(refusal(R"({"model":"m","error":-1,"spacing":100,"lag":10,"band":2})"),
            "c:1: error must be metres from 0 to 1e6, found -1");
  EXPECT_NE(refusal(R"({"error":1,"spacing":100,"lag":10,"band":2})"), "");
}

}  // namespace
}  // namespace traj
