#include "geom/model/tileset.h"

#include <gtest/gtest.h>

#include <map>

#include "support/glb_file.h"
#include "support/reading.h"
#include "support/subtree_file.h"
#include "support/triangle_shapes.h"

namespace geom {
namespace {

using support::GltfFile;
using support::json;
using Files = std::map<std::string, std::string>;

std::string house(const Vec3& at = Vec3::Zero()) {
  return GltfFile(support::cuboid({at, at + Vec3(1, 2, 3)})).bytes();
}

json tileset(json root) {
  return {{"asset", {{"version", "1.0"}}}, {"geometricError", 1}, {"root", std::move(root)}};
}
json tile(const std::string& uri, json children = json::array()) {
  json out = {{"geometricError", 1}, {"children", std::move(children)}};
  if (!uri.empty()) out["content"]["uri"] = uri;
  return out;
}
json refined(json root, const char* how) {
  root["refine"] = how;
  return root;
}

TilesModel read(const Files& files) {
  return read_tileset("tileset.json", [&](const std::string& path) {
    const auto at = files.find(path);
    if (at == files.end()) throw InputError(path, {.says = "not there"});
    return at->second;
  });
}
TilesModel read(const json& root, Files files) {
  files["tileset.json"] = tileset(root).dump();
  return read(files);
}

template <class... Args>
void expect_refusal(const std::string& message, const Args&... args) {
  const std::string found = support::refusal_of([&] { read(args...); });
  EXPECT_TRUE(support::says(found, message));
}

TEST(ReadTileset, AddsTheTilesThatAddAndTheFinestOfThoseThatReplace) {
  const Files files = {
      {"a.glb", house()}, {"b.glb", house({5, 0, 0})}, {"c.glb", house({9, 0, 0})}};
  const json root = tile("a.glb", {tile("b.glb"), tile("c.glb")});
  const TilesModel added = read(refined(root, "ADD"), files);
  EXPECT_EQ(added.model.mesh.triangles.size(), 36u);
  EXPECT_EQ(added.tiles, 3u);
  EXPECT_EQ(added.coarser, 0u);
  EXPECT_FALSE(added.on_earth);
  const TilesModel replaced = read(refined(root, "REPLACE"), files);
  EXPECT_EQ(replaced.model.mesh.triangles.size(), 24u);
  EXPECT_EQ(replaced.tiles, 2u);
  EXPECT_EQ(replaced.coarser, 1u);
}

TEST(ReadTileset, KeepsATileOfWhichAChildHasNothing) {
  const Files files = {{"a.glb", house()}, {"b.glb", house({5, 0, 0})}};
  const TilesModel made = read(refined(tile("a.glb", {tile("b.glb"), tile("")}), "REPLACE"), files);
  EXPECT_EQ(made.tiles, 2u);
  EXPECT_EQ(made.coarser, 0u);
}

// A tile without content stands for those below it, one of which has nothing either.
TEST(ReadTileset, KeepsATileOfWhichAPartFurtherBelowHasNothing) {
  const Files files = {{"a.glb", house()}, {"b.glb", house({5, 0, 0})}};
  const auto made = [&](json second) {
    const json between = tile("", {tile("b.glb"), std::move(second)});
    return read(refined(tile("a.glb", {between}), "REPLACE"), files);
  };
  EXPECT_EQ(made(tile("")).coarser, 0u);
  EXPECT_EQ(made(tile("b.glb")).coarser, 1u);
}

TEST(ReadTileset, KeepsATilesetThatHasChildrenBesideIt) {
  const Files files = {{"a.json", tileset(refined(tile("a.glb"), "ADD")).dump()},
                       {"a.glb", house()},
                       {"b.glb", house({5, 0, 0})}};
  EXPECT_EQ(read(refined(tile("a.json", {tile("b.glb")}), "REPLACE"), files).tiles, 2u);
}

TEST(ReadTileset, PlacesContentByTransformCentreAndTheUpwardAxisOfGltf) {
  GltfFile file(TriangleMesh{{{0, 0, 0}, {1, 2, 3}, {0, 1, 0}}, {{{0, 1, 2}, 0}}});
  json inner = tile("b.b3dm");
  inner["transform"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1};
  json root = refined(tile("", {inner}), "ADD");
  root["transform"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1000, 1};
  const Files files = {
      {"b.b3dm",
       support::b3dm(file.bytes(), {{"BATCH_LENGTH", 0}, {"RTC_CENTER", {100, 0, 0}}}, {})}};
  // z up: (1, -3, 2); centre: (101, -3, 2); turned: (3, 101, 2), and moved.
  EXPECT_EQ(read(root, files).model.mesh.vertices[1], Vec3(13, 101, 1002));
}

TEST(ReadTileset, KeepsContentUprightThatIsZUpAlready) {
  json set = tileset(refined(tile("a.glb"), "ADD"));
  Files files = {{"a.glb", house()}};
  const auto top = [&](const char* up) {
    set["asset"]["gltfUpAxis"] = up;
    files["tileset.json"] = set.dump();
    return read(files).model.mesh.vertices[7];
  };
  EXPECT_EQ(top("Y"), Vec3(1, -3, 2));
  EXPECT_EQ(top("Z"), Vec3(1, 2, 3));
  set["asset"]["gltfUpAxis"] = "X";
  files["tileset.json"] = set.dump();
  expect_refusal("expected gltfUpAxis Y or Z", files);
  json outer = tileset(refined(tile("inner.json"), "ADD"));
  set["asset"]["gltfUpAxis"] = "Z";
  files["inner.json"] = set.dump();
  files["tileset.json"] = outer.dump();
  expect_refusal("one gltfUpAxis in all tilesets", files);
}

TEST(ReadTileset, NamesPartsByTheBatchTable) {
  GltfFile file(support::cuboid({{0, 0, 0}, {1, 1, 1}}));
  const std::size_t at = file.binary.size();
  for (int i = 0; i < 8; ++i) append_bytes(file.binary, i >= 4 ? 1.0f : 0.0f);
  file.text["buffers"][0]["byteLength"] = file.binary.size();
  file.text["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", 32}});
  file.text["accessors"].push_back(
      {{"bufferView", 2}, {"componentType", 5126}, {"type", "SCALAR"}, {"count", 8}});
  file.text["meshes"][0]["primitives"][0]["attributes"]["_BATCHID"] = 2;
  const json batch = {{"id", {11, 22}}, {"name", {"town hall", "tower"}}};
  const Files files = {{"b.b3dm", support::b3dm(file.bytes(), {{"BATCH_LENGTH", 2}}, batch)},
                       {"c.b3dm", support::b3dm(file.bytes(), {{"BATCH_LENGTH", 2}}, {})}};
  const auto parts =
      read(refined(tile("", {tile("b.b3dm"), tile("c.b3dm")}), "ADD"), files).model.parts;
  EXPECT_EQ(parts, (std::vector<std::string>{"town hall", "tower", "c.b3dm 0", "c.b3dm 1"}));
}

TEST(ReadTileset, GoesIntoOtherTilesetsByTheirFolders) {
  Files files = {
      {"sub/inner.json", tileset(refined(tile("../a.glb", {tile("b.glb")}), "ADD")).dump()},
      {"a.glb", house()},
      {"sub/b.glb", house()}};
  EXPECT_EQ(read(refined(tile("sub/inner.json"), "ADD"), files).tiles, 2u);
  files["sub/b.glb"] = files["sub/inner.json"];
  files["sub/b.glb"] = tileset(refined(tile("inner.json"), "ADD")).dump();
  expect_refusal("this tileset is within itself", refined(tile("sub/inner.json"), "ADD"), files);
  expect_refusal("this tileset is within itself", refined(tile("tileset.json"), "ADD"), files);
}

TEST(ReadTileset, CountsContentThatItDoesNotKnow) {
  const Files files = {{"a.i3dm", "i3dm...."}, {"b.pnts", "pnts"}, {"c.cmpt", "cmpt"}, {"d", "xx"}};
  const json root =
      refined(tile("", {tile("a.i3dm"), tile("b.pnts"), tile("c.cmpt"), tile("d")}), "ADD");
  EXPECT_EQ(read(root, files).model.skipped.count(), 4u);
}

TEST(ReadTileset, SaysWhichTileHoldsWhatCannotBeBuilt) {
  GltfFile file(TriangleMesh{{{0, 0, 0}, {1, 2, 3}, {0, 1, 0}}, {{{0, 1, 2}, 0}}});
  file.text["meshes"][0]["primitives"][0]["mode"] = 1;
  const Files files = {{"a.glb", house()}, {"b.glb", file.bytes()}};
  const json root = refined(tile("", {tile("a.glb"), tile("b.glb")}), "ADD");
  EXPECT_EQ(read(root, files).model.skipped.text(), "1 x points or lines (b.glb: mode 1)");
}

TEST(ReadTileset, RefusesWhatItWouldReadWrongly) {
  const Files files = {{"a.glb", house()}};
  const json good = refined(tile("a.glb"), "ADD");
  json root = good;
  root["extensions"]["3DTILES_implicit_tiling"] = json::object();
  expect_refusal("3DTILES_implicit_tiling is not read", root, files);
  root = good;
  root.erase("refine");
  expect_refusal("expected refine ADD or REPLACE, found \"\"", root, files);
  root = good;
  root["transform"] = {1, 2, 3};
  expect_refusal("expected 16 numbers as \"transform\"", root, files);
  root = good;
  root["transform"] = std::vector<double>(16, 1);
  expect_refusal("expected a transform whose last row", root, files);
  expect_refusal("not there", refined(tile("missing.glb"), "ADD"), files);
  for (const char* uri : {"../a.glb", "/a.glb", "https://host/a.glb"}) {
    expect_refusal("expected the path of a file beside this one", refined(tile(uri), "ADD"), files);
  }
  json all = tileset(good);
  all["asset"]["version"] = "0.0";
  Files other = files;
  other["tileset.json"] = all.dump();
  expect_refusal("expected version 1.0 or 1.1", other);
  all = tileset(good);
  all["extensionsRequired"] = {"3DTILES_implicit_tiling"};
  other["tileset.json"] = all.dump();
  expect_refusal("it requires the extension", other);
}

// Two subtrees of two levels: the root; (0, 0) and (1, 1) below; (3, 2) and (2, 3) below the last.
json implicit_root(const char* refine) {
  json root = refined(tile("c/{level}-{x}-{y}.glb"), refine);
  root.erase("children");
  root["implicitTiling"] = {{"subdivisionScheme", "QUADTREE"},
                            {"subtreeLevels", 2},
                            {"availableLevels", 3},
                            {"subtrees", {{"uri", "s/{level}/{x}/{y}.subtree"}}}};
  return root;
}
Files implicit_files() {
  return {{"s/0/0/0.subtree", support::SubtreeFile("11001", {"11001"}, "0000000000000110").bytes()},
          {"s/2/3/2.subtree", support::SubtreeFile("10000", {"1"}, "0").bytes()},
          {"s/2/2/3.subtree", support::SubtreeFile("10000", {"10000"}, "0").bytes()},
          {"c/0-0-0.glb", house()},
          {"c/1-0-0.glb", house({5, 0, 0})},
          {"c/1-1-1.glb", house({6, 0, 0})},
          {"c/2-3-2.glb", house({7, 0, 0})},
          {"c/2-2-3.glb", house({8, 0, 0})}};
}

TEST(ReadTileset, ReadsTheTilesOfSubtrees) {
  EXPECT_EQ(read(implicit_root("ADD"), implicit_files()).tiles, 5u);
  const TilesModel finest = read(implicit_root("REPLACE"), implicit_files());
  EXPECT_EQ(finest.tiles, 3u);
  EXPECT_EQ(finest.coarser, 2u);
  EXPECT_EQ(finest.model.mesh.vertices[0].x(), 5);
  EXPECT_EQ(finest.model.mesh.vertices[8].x(), 7);
  EXPECT_EQ(finest.model.mesh.vertices[16].x(), 8);
}

TEST(ReadTileset, KeepsATileOfWhichAnImplicitChildHasNothing) {
  Files files = implicit_files();
  files["s/2/2/3.subtree"] = support::SubtreeFile("10000", {"0"}, "0").bytes();
  const TilesModel made = read(implicit_root("REPLACE"), files);
  EXPECT_EQ(made.coarser, 1u) << "the root alone";
  EXPECT_EQ(made.tiles, 3u);
}

TEST(ReadTileset, RefusesImplicitTilesThatAreNotThereOrNotAsTheySay) {
  for (const auto& [path, bytes] : implicit_files()) {
    Files files = implicit_files();
    files.erase(path);
    expect_refusal(path + ": not there", implicit_root("ADD"), files);
  }
  const Files files = implicit_files();
  const auto refused = [&](const char* key, const json& value, const char* message) {
    json root = implicit_root("ADD");
    root["implicitTiling"][key] = value;
    expect_refusal(message, root, files);
  };
  refused("availableLevels", 2, "expected tiles on 2 levels, as it says, found one on level 2");
  refused("availableLevels", 61, "expected availableLevels from 1 to 60");
  refused("subtreeLevels", 0, "expected subtreeLevels from 1 to 13, found 0");
  refused("subtreeLevels", 40, "expected subtreeLevels from 1 to 13, found 40");
  refused("subdivisionScheme", "KD", "expected subdivisionScheme QUADTREE or OCTREE");
  refused("subdivisionScheme", "OCTREE", "expected {z} in the URI");
  refused("subtrees", {{"uri", "s/{level}/{x}.subtree"}}, "expected {y} in the URI");
  json root = implicit_root("ADD");
  root["children"] = json::array({tile("c/0-0-0.glb")});
  expect_refusal("expected no children beside implicitTiling", root, files);
  root = implicit_root("ADD");
  root["content"]["uri"] = "c/0-0-0.glb";
  expect_refusal("expected {level} in the URI", root, files);
}

TEST(ReadTileset, RefusesTilesThatAreDeeperThanAnyone) {
  json root = tile("a.glb");
  for (int i = 0; i < 40; ++i) root = tile("", {root});
  const Files files = {{"a.glb", house()}};
  EXPECT_EQ(read(refined(root, "ADD"), files).tiles, 1u);
}

TEST(ReadTileset, RefusesSomeCoordinatesOnEarthAndSomeNot) {
  const Files files = {{"a.glb", house()}, {"b.glb", house({6.4e6, 0, 0})}};
  expect_refusal("found both: 8 of 16 vertices",
                 refined(tile("", {tile("a.glb"), tile("b.glb")}), "ADD"), files);
  EXPECT_TRUE(read(refined(tile("b.glb"), "ADD"), files).on_earth);
}

TEST(ReadTileset, RefusesBatchedModelsWhoseLengthsLie) {
  const std::string good = support::b3dm(house(), {{"BATCH_LENGTH", 0}}, {});
  const json root = refined(tile("b.b3dm"), "ADD");
  EXPECT_EQ(read(root, {{"b.b3dm", good}}).tiles, 1u);
  expect_refusal("of which its tables take", root, Files{{"b.b3dm", good + "x"}});
  for (std::size_t n = 4; n < good.size(); n += 11) {
    expect_refusal("b.b3dm", root, Files{{"b.b3dm", good.substr(0, n)}});
  }
  for (const std::size_t at : {8u, 12u, 16u, 20u, 24u}) {
    std::string bytes = good;
    bytes[at + 1] = 120;
    expect_refusal("b.b3dm", root, Files{{"b.b3dm", bytes}});
  }
  std::string bytes = good;
  bytes[4] = 2;
  expect_refusal("expected a b3dm of version 1, found 2", root, Files{{"b.b3dm", bytes}});
  bytes = support::b3dm(house(), {{"RTC_CENTER", {{"byteOffset", 4}}}}, {});
  expect_refusal("RTC_CENTER: it lies outside the table", root, Files{{"b.b3dm", bytes}});
}

// Its own tiles may be finer than those beside it.
TEST(ReadTileset, KnowsATilesetByItsBytesAndNotByItsName) {
  for (const char* name : {"a.json", "a.JSON", "a.tiles", "a"}) {
    const Files files = {{name, tileset(refined(tile("a.glb"), "ADD")).dump()},
                         {"a.glb", house()},
                         {"b.glb", house({5, 0, 0})}};
    const TilesModel made = read(refined(tile(name, {tile("b.glb")}), "REPLACE"), files);
    EXPECT_EQ(made.tiles, 2u) << name;
    EXPECT_EQ(made.coarser, 0u) << name;
  }
}

}  // namespace
}  // namespace geom
