#include "plan/sampling/search_tree_file.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "plan/sampling/rrt.h"
#include "plan/scenes.h"
#include "support/reading.h"

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

}  // namespace
}  // namespace plan
