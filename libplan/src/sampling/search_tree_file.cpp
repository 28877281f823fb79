#include "plan/sampling/search_tree_file.h"

#include <ostream>

#include "geom/text/json_line.h"

namespace plan {

void write_jsonl(std::ostream& out, const SearchTree& tree, std::string_view id,
                 const geom::Provenance& provenance) {
  geom::JsonLine head;
  head.add("type", "tree").add("id", id);
  add(head, provenance);
  out << head.add("nodes", tree.points.size()).line();
  for (std::size_t i = 0; i < tree.points.size(); ++i) {
    geom::JsonLine node;
    node.add("index", i).add("parent", tree.parent[i]).add("first_parent", tree.first_parent[i]);
    node.add("tree", tree.tree[i]).add("cost", tree.cost[i]).add("point", tree.points[i]);
    out << node.line();
  }
}

}  // namespace plan
