#include "cloud/moved_comment.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

CoordinateReference told_by(const std::vector<std::string>& comments) {
  MovedComments out;
  for (const std::string& comment : comments) out.take(comment);
  return out.told();
}

TEST(MovedComments, SayThatCoordinatesAreShiftedOrScaled) {
  for (const char* comment :
       {"shift 500000 5000000 0", "Global shift: (-500000, -5000000, 0)", "offsetx 500000",
        "local_offset = [1.5; 0; 0]", "translation 0 0 -3"}) {
    EXPECT_EQ(told_by({"made by hand", comment}).moved, comment);
    EXPECT_FALSE(told_by({comment}).scaled) << comment;
  }
  EXPECT_TRUE(told_by({"scale 0.001"}).scaled);
}

TEST(MovedComments, SayNothingInOtherWords) {
  for (const char* comment : {"shift 0 0 0", "scale 1", "offset", "camera offset 1 2 3", "X Y Z",
                              "shift 500000 of colours", "Created by CloudCompare v2.13", ""}) {
    EXPECT_EQ(told_by({comment}), CoordinateReference()) << comment;
  }
  EXPECT_EQ(told_by({"reporting all LAS header entries:", "offset x y z: 500000 5000000 0"}),
            CoordinateReference());
}

}  // namespace
}  // namespace geom
