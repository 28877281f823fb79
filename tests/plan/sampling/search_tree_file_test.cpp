#include "plan/sampling/search_tree_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geom/base/error.h"
#include "plan/sampling/rrt.h"
#include "plan/scenes.h"
#include "support/refusal.h"

namespace plan {
namespace {

// From the start: 0 - 1 - 3, the last rewired from 0; from the goal: 2 - 4.
SearchTree small_tree() {
  SearchTree tree;
  tree.points = {{0, 0, 0}, {3, 4, 0}, {10, 0.1, 7}, {3, 4, 2}, {10, 0.1, 5}};
  tree.parent = {0, 0, 2, 1, 2};
  tree.first_parent = {0, 0, 2, 0, 2};
  tree.cost = {0, 5, 0, 7, 2};
  tree.tree = {0, 0, 1, 0, 1};
  return tree;
}

SearchTree grown_tree() {
  const auto scene =
      scene_of({{{45, 20, -1}, {55, 80, 101}}}, {{0, 0, 0}, {100, 100, 100}}, Vec3::Zero());
  return sample_path(scene, {20, 45, 50}, {80, 45, 50}, SamplingMethod::rrt_connect).tree;
}

std::string jsonl(const SearchTree& tree) {
  std::ostringstream out;
  write_jsonl(out, tree, "q1", {.frame = geom::Axes::neu, .margin = 0.5});
  return out.str();
}

std::string ply(const SearchTree& tree, geom::Axes axes) {
  std::ostringstream out;
  write_ply(out, tree, axes);
  return out.str();
}

std::string glb(const SearchTree& tree, geom::Axes axes) {
  std::ostringstream out;
  write_glb(out, tree, axes);
  return out.str();
}

Vec3 vector_of(const nlohmann::json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

// Reads numbers off a string of bytes.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  T next() {
    T value;
    EXPECT_GE(bytes_.size(), sizeof value);
    if (bytes_.size() < sizeof value) return {};
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  std::string_view next_text(std::size_t size) {
    const std::string_view text = bytes_.substr(0, size);
    bytes_.remove_prefix(text.size());
    return text;
  }
  bool done() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

TEST(SearchTreeJsonl, IsAHeaderAndALineANode) {
  EXPECT_EQ(jsonl(small_tree()),
            R"({"type":"tree","id":"q1","frame":"neu","margin":0.5,"nodes":5}
{"index":0,"parent":0,"first_parent":0,"tree":0,"cost":0,"point":[0,0,0]}
{"index":1,"parent":0,"first_parent":0,"tree":0,"cost":5,"point":[3,4,0]}
{"index":2,"parent":2,"first_parent":2,"tree":1,"cost":0,"point":[10,0.1,7]}
{"index":3,"parent":1,"first_parent":0,"tree":0,"cost":7,"point":[3,4,2]}
{"index":4,"parent":2,"first_parent":2,"tree":1,"cost":2,"point":[10,0.1,5]}
)");
}

TEST(SearchTreeJsonl, ComesBackBitForBit) {
  const SearchTree tree = grown_tree();
  std::istringstream in(jsonl(tree));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(nlohmann::json::parse(line).at("nodes"), tree.points.size());
  SearchTree back;
  while (std::getline(in, line)) {
    const auto node = nlohmann::json::parse(line);
    EXPECT_EQ(node.at("index"), back.points.size());
    back.points.push_back(vector_of(node.at("point")));
    back.parent.push_back(node.at("parent"));
    back.first_parent.push_back(node.at("first_parent"));
    back.cost.push_back(node.at("cost"));
    back.tree.push_back(node.at("tree"));
  }
  EXPECT_EQ(back, tree);
}

// The tree in these lines; a line after the last node is not asked for.
SearchTreeRecord read(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  SearchTreeReader reader(line, "t.jsonl", 1);
  std::size_t number = 1;
  while (std::getline(in, line)) reader.add(line, "t.jsonl", ++number);
  return std::move(reader).finish("t.jsonl", number);
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { read(text); });
}

TEST(SearchTreeReader, ReadsWhatWasWritten) {
  for (const SearchTree& tree : {SearchTree{}, small_tree(), grown_tree()}) {
    const SearchTreeRecord record = read(jsonl(tree));
    EXPECT_EQ(record.tree, tree);
    EXPECT_EQ(record.id, "q1");
    EXPECT_EQ(record.provenance.frame, geom::Axes::neu);
    EXPECT_EQ(record.provenance.margin, 0.5);
  }
}

TEST(SearchTreeReader, RefusesWhatIsNoTree) {
  const std::string head = "{\"type\":\"tree\",\"id\":\"a\",\"nodes\":2}\n";
  const auto node = [](const char* index, const char* parent, const char* first,
                       const char* which) {
    return std::string("{\"index\":") + index + ",\"parent\":" + parent +
           ",\"first_parent\":" + first + ",\"tree\":" + which + ",\"cost\":0,\"point\":[0,0,0]}\n";
  };
  const std::string good = node("0", "0", "0", "0");
  EXPECT_EQ(refusal(head + good + node("1", "0", "0", "1")), "");
  EXPECT_EQ(refusal(head + good), "t.jsonl:2: expected a tree of 2 nodes, found 1");
  EXPECT_EQ(refusal(head + good + good), "t.jsonl:3: expected index 1, found 0");
  EXPECT_EQ(refusal(head + node("0", "2", "0", "0")),
            "t.jsonl:2: parent must be a whole number from 0 to below 2, found 2");
  EXPECT_EQ(refusal(head + node("0", "0", "1", "0")),
            "t.jsonl:2: first_parent must be a whole number from 0 to below 1, found 1");
  EXPECT_EQ(refusal(head + node("0", "0", "0", "2")),
            "t.jsonl:2: tree must be a whole number from 0 to below 2, found 2");
  EXPECT_EQ(refusal(head + node("0", "-1", "0", "0")),
            "t.jsonl:2: parent must be a whole number from 0 to below 2, found -1");
  EXPECT_EQ(refusal(head + good + node("1", "0", "0", "0") + good),
            "t.jsonl:4: expected 2 nodes, found one more");
  EXPECT_NE(refusal("{\"type\":\"tree\",\"id\":\"a\",\"nodes\":1e300}\n"), "");
}

TEST(SearchTreePly, HasAVertexANodeAndAnEdgeAParent) {
  for (const SearchTree& tree : {small_tree(), grown_tree()}) {
    const std::string text = ply(tree, geom::Axes::neu);
    const std::string_view mark = "end_header\n";
    const std::size_t body = text.find(mark) + mark.size();
    const std::size_t nodes = tree.points.size();
    const std::string head = text.substr(0, body);
    EXPECT_NE(head.find("element vertex " + std::to_string(nodes) + "\n"), std::string::npos);
    EXPECT_NE(head.find("element edge " + std::to_string(nodes - 2) + "\n"), std::string::npos);
    Bytes bytes(std::string_view(text).substr(body));
    for (std::size_t i = 0; i < nodes; ++i) {
      for (const int axis : {1, 0, 2}) EXPECT_EQ(bytes.next<double>(), tree.points[i][axis]);
      EXPECT_EQ(bytes.next<std::uint8_t>(), tree.tree[i] ? 204 : 86);
      bytes.next_text(2);
      EXPECT_EQ(bytes.next<std::int32_t>(), static_cast<int>(tree.first_parent[i]));
    }
    for (std::size_t i = 0; i < nodes; ++i) {
      if (tree.parent[i] == i) continue;
      EXPECT_EQ(bytes.next<std::int32_t>(), static_cast<int>(tree.parent[i]));
      EXPECT_EQ(bytes.next<std::int32_t>(), static_cast<int>(i));
    }
    EXPECT_TRUE(bytes.done());
  }
}

TEST(SearchTreeGlb, DrawsEveryEdgeAsALineInYUp) {
  for (const SearchTree& tree : {small_tree(), grown_tree()}) {
    const std::string text = glb(tree, geom::Axes::enu);
    Bytes bytes(text);
    EXPECT_EQ(bytes.next_text(4), "glTF");
    EXPECT_EQ(bytes.next<std::uint32_t>(), 2u);
    EXPECT_EQ(bytes.next<std::uint32_t>(), text.size());
    const auto json_size = bytes.next<std::uint32_t>();
    EXPECT_EQ(bytes.next_text(4), "JSON");
    const auto json = nlohmann::json::parse(bytes.next_text(json_size));
    EXPECT_EQ(bytes.next<std::uint32_t>(), json.at("buffers").at(0).at("byteLength"));
    EXPECT_EQ(bytes.next_text(4), std::string_view("BIN\0", 4));
    const Vec3 middle = vector_of(json.at("nodes").at(0).at("translation"));
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < tree.points.size(); ++i) {
      Vec3 p;
      for (int k = 0; k < 3; ++k) p[k] = middle[k] + bytes.next<float>();
      const Vec3& q = tree.points[i];
      EXPECT_LT((p - Vec3(q.x(), q.z(), -q.y())).norm(), 1e-4);
    }
    const auto& primitives = json.at("meshes").at(0).at("primitives");
    ASSERT_EQ(primitives.size(), 2u);
    std::size_t edges = 0;
    for (std::size_t which = 0; which < 2; ++which) {
      EXPECT_EQ(primitives.at(which).at("mode"), 1);  // LINES
      const auto& accessor =
          json.at("accessors").at(primitives.at(which).at("indices").get<std::size_t>());
      const std::size_t count = accessor.at("count");
      std::uint32_t before = 0;
      for (std::size_t i = 0; i < count; i += 2) {
        const auto parent = bytes.next<std::uint32_t>();
        const auto node = bytes.next<std::uint32_t>();
        EXPECT_EQ(tree.parent[node], parent);
        EXPECT_EQ(tree.tree[node], which);
        EXPECT_LT(before, node);  // in the order of insertion
        before = node;
        ++edges;
      }
    }
    EXPECT_EQ(edges, tree.points.size() - 2);
    EXPECT_TRUE(bytes.done());
  }
}

TEST(SearchTreeFiles, TakeTreesWithoutEdges) {
  SearchTree root;
  root.points = {{1, 2, 3}};
  root.parent = root.first_parent = {0};
  root.cost = {0};
  root.tree = {0};
  for (const SearchTree& tree : {SearchTree{}, root}) {
    EXPECT_NE(jsonl(tree).find("\"nodes\":" + std::to_string(tree.points.size())),
              std::string::npos);
    EXPECT_NE(ply(tree, geom::Axes::enu).find("element edge 0\n"), std::string::npos);
    const std::string text = glb(tree, geom::Axes::enu);
    EXPECT_EQ(nlohmann::json::parse(text.substr(20)).at("scenes"), nlohmann::json::parse("[{}]"));
  }
}

}  // namespace
}  // namespace plan
