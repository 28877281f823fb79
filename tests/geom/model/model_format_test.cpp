#include "geom/model/model_format.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"

namespace geom {
namespace {

TEST(ModelFormatOf, TellsTilesFromGltfByTheirRoot) {
  EXPECT_EQ(&model_format_of(R"( {"root": {}})", "a"), &kTilesModel);
  EXPECT_EQ(&model_format_of(R"({"asset": {}})", "a"), &kGltfModel);
  EXPECT_THROW(model_format_of(R"({"asset")", "a"), InputError);
}

TEST(ModelFormatOf, TakesTheNameWhereTheContentTellsNothing) {
  EXPECT_EQ(&model_format_of("v 1 2 3", "a/house.OBJ"), &kObjModel);
  EXPECT_EQ(&model_format_of("?", "house.3ds"), &k3dsModel);
  EXPECT_EQ(&model_format_of("solid house\n", "house.txt"), &kStlModel);
  EXPECT_EQ(&model_format_of("glTF", "house.obj"), &kGltfModel);
}

TEST(ModelFormatOf, RefusesWhatItCannotTell) {
  for (const char* bytes : {"", "b3dm", "v 1 2 3"}) {
    EXPECT_THROW(model_format_of(bytes, "house"), InputError) << bytes;
  }
  EXPECT_THROW(model_format_of("", "house.obj"), InputError);
}

TEST(ModelFormatByEnding, KnowsNoNameWithoutOne) {
  EXPECT_EQ(model_format_by_ending("obj"), nullptr);
  EXPECT_EQ(model_format_by_ending("house."), nullptr);
  EXPECT_EQ(model_format_by_ending("a.obj/house"), nullptr);
  EXPECT_EQ(model_format_by_ending("house.Stl"), &kStlModel);
}

}  // namespace
}  // namespace geom
