#include "geom/cloud/cloud_format.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace geom {
namespace {

struct Told {
  std::size_t references = 0;
  std::size_t points_before = 0;  // before the first reference
  std::size_t points = 0;
};

Told read(const CloudFormat& format, const std::string& text) {
  std::istringstream in(text);
  Told told;
  const PointSink sink = [&](std::span<const CloudPoint> chunk) { told.points += chunk.size(); };
  const ReferenceSink reference = [&](const CoordinateReference&) {
    if (told.references++ == 0) told.points_before = told.points;
  };
  format.read(in, "it", sink, reference, {});
  return told;
}

TEST(CloudFormat, TellsOneReferenceBeforeThePoints) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n1 2 3\n";
  const std::string pcd =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
      "POINTS 1\nDATA ascii\n1 2 3\n";
  for (const auto& [format, text] :
       {std::pair{&kXyzCloud, std::string("1 2 3\n")}, {&kPlyCloud, ply}, {&kPcdCloud, pcd}}) {
    EXPECT_EQ(row_recognised(text, cloud_formats()), format) << text;
    const Told told = read(*format, text);
    EXPECT_EQ(told.references, 1u) << text;
    EXPECT_EQ(told.points_before, 0u) << text;
    EXPECT_EQ(told.points, 1u) << text;
  }
}

TEST(CloudFormat, ReadsWithoutAnybodyToTell) {
  std::istringstream in("1 2 3\n");
  EXPECT_EQ(kXyzCloud.read(in, "it", [](std::span<const CloudPoint>) {}, {}, {}).read, 1u);
}

TEST(CloudFormat, IsXyzWhereNothingElseFits) {
  EXPECT_EQ(row_recognised("Northing Easting Height\n", cloud_formats()), &kXyzCloud);
  EXPECT_EQ(row_recognised("ply ", cloud_formats()), &kPlyCloud);
}

}  // namespace
}  // namespace geom
