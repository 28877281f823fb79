#include "import/sdf/sdf_loader.h"

#include <gtest/gtest.h>

#include <map>

#include "support/reading.h"
#include "support/sdf_text.h"

namespace geom {
namespace {

// Files by their URIs.
class Files {
 public:
  void add(const std::string& uri, const std::string& text) { files_[uri] = {uri, text}; }
  SdfOptions options() const {
    SdfOptions out;
    out.open = [this](const std::string& uri, const std::string&) {
      const auto at = files_.find(uri);
      return at == files_.end() ? nullptr : &at->second;
    };
    return out;
  }

 private:
  std::map<std::string, SdfFile> files_;
};

SdfWorld read(const Files& files, const std::string& world) {
  return read_sdf_world(support::Text(support::sdf(world)), "w", files.options());
}

std::string file(const std::string& model) { return "<sdf version='1.6'>" + model + "</sdf>"; }

std::string include(const std::string& uri, const std::string& more = "") {
  return "<include><uri>" + uri + "</uri>" + more + "</include>";
}

TEST(SdfLoader, IncludesModelsUnderTheirNamesAndPoses) {
  Files files;
  files.add("model://hut",
            file(support::sdf_model("hut", "1 0 0 0 0 0", support::sdf_box("2 2 2"))));
  const SdfWorld out =
      read(files, include("model://hut") +
                      include("model://hut", "<name>b</name><pose>9 0 0 0 0 0</pose>"));
  ASSERT_EQ(out.table.boxes.size(), 2u);
  EXPECT_EQ(out.table.boxes[0].min, Vec3(0, -1, -1));
  EXPECT_EQ(out.table.boxes[1].min, Vec3(8, -1, -1))
      << "the include's pose takes the model's place";
  EXPECT_EQ(out.table.labels, (std::vector<std::string>{"", "hut", "b"}));
  EXPECT_EQ(out.movable, 0u);
}

TEST(SdfLoader, NestsIncludes) {
  Files files;
  files.add("a", file("<model name='a'><pose>1 0 0 0 0 0</pose>" +
                      include("b", "<pose>0 1 0 0 0 0</pose>") + "</model>"));
  files.add("b", file(support::sdf_model("b", "", support::sdf_box("2 2 2"))));
  const SdfWorld out = read(files, include("a", "<static>true</static>"));
  ASSERT_EQ(out.table.boxes.size(), 1u);
  EXPECT_EQ(out.table.boxes[0].min, Vec3(0, 0, -1));
  EXPECT_EQ(out.table.labels.back(), "a::b");
}

TEST(SdfLoader, SkipsWhatIsNotFoundAndWhatIsChanged) {
  Files files;
  EXPECT_EQ(read(files, include("model://gone")).skipped.count(), 1u);
  files.add("b", file(support::sdf_model("b", "", support::sdf_box("2 2 2"))));
  EXPECT_EQ(
      read(files, include("b", "<experimental:params><x/></experimental:params>")).skipped.count(),
      1u);
  EXPECT_EQ(read(files, include("b", "<scale>2 2 2</scale>")).skipped.count(), 1u);
  EXPECT_EQ(read(files, include("b", "<plugin/><static>1</static>")).skipped.count(), 0u);
  files.add("c", file("<light name='c'/>"));
  EXPECT_EQ(read(files, include("c")).skipped.count(), 0u);
  files.add("d", file("<actor name='c'/>"));
  EXPECT_EQ(read(files, include("d")).skipped.count(), 1u);
}

TEST(SdfLoader, RefusesIncludesThatDoNotEnd) {
  Files files;
  files.add("a", file("<model name='a'>" + include("b") + "</model>"));
  files.add("b", file("<model name='b'>" + include("a") + "</model>"));
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { read(files, include("a")); }), "includes itself"));
  Files many;  // ten of ten of ten …
  for (int i = 0; i < 9; ++i) {
    std::string inside;
    for (int k = 0; k < 10; ++k) inside += include("m" + std::to_string(i + 1));
    many.add("m" + std::to_string(i), file("<model name='m'>" + inside + "</model>"));
  }
  many.add("m9", file("<model name='m'/>"));
  EXPECT_TRUE(support::says(support::refusal_of([&] { read(many, include("m0")); }),
                            "at most 1000000 models"));
}

TEST(SdfLoader, RefusesOtherFilesAndVersions) {
  const auto refusal = [](const std::string& text) {
    return support::refusal_of([&] { read_sdf_world(support::Text(text), "w", {}); });
  };
  EXPECT_TRUE(support::says(refusal("<gazebo/>"), "expected <sdf>"));
  EXPECT_TRUE(support::says(refusal("<sdf/>"), "found \"\""));
  EXPECT_TRUE(support::says(refusal("<sdf version='1.3'/>"), "found \"1.3\""));
  EXPECT_NE(refusal("<sdf version='2.0'/>"), "");
  EXPECT_TRUE(
      support::says(refusal("<sdf version='1.9'><world/><world/></sdf>"), "expected one <world>"));
  EXPECT_EQ(refusal("<sdf version='1.9'/>"), "");
}

TEST(SdfLoader, SkipsWhatStandsBesideTheWorld) {
  const auto skipped = [](const std::string& text) {
    return read_sdf_world(support::Text("<sdf version='1.9'>" + text + "</sdf>"), "w", {})
        .skipped.count();
  };
  EXPECT_EQ(skipped("<world name='w'/><model name='m'/>"), 1u);
  EXPECT_EQ(skipped("<model name='m'/><model name='n'/>"), 0u);
}

}  // namespace
}  // namespace geom
