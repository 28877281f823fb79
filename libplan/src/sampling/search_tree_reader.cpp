#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "geom/base/error.h"
#include "geom/text/counted.h"
#include "geom/text/json_fields.h"
#include "plan/sampling/search_tree_file.h"

namespace plan {
namespace {

// A whole number below `end`.
std::uint32_t index(const geom::JsonFields& fields, const char* key, std::uint64_t end) {
  const nlohmann::json& object = fields.object();
  if (!object.contains(key) || !object[key].is_number_unsigned() ||
      object[key].get<std::uint64_t>() >= end) {
    fields.refuse({.key = std::string(key),
                   .expected = fmt::format("a whole number from 0 to below {}", end),
                   .found = object.contains(key) ? object[key].dump() : "none"});
  }
  return object[key].get<std::uint32_t>();
}

}  // namespace

SearchTreeReader::SearchTreeReader(std::string_view header, std::string_view source,
                                   std::size_t line) {
  const geom::JsonFields fields(header, source, line);
  fields.require_type("tree");
  record_.id = fields.text("id");
  record_.provenance = geom::read_provenance(fields);
  nodes_ = index(fields, "nodes", std::uint64_t{1} << 32);
}

void SearchTreeReader::add(std::string_view node, std::string_view source, std::size_t line) {
  SearchTree& tree = record_.tree;
  const std::size_t i = tree.points.size();
  const geom::JsonFields fields(node, source, line);
  if (complete()) fields.refuse({.expected = fmt::format("{} nodes", nodes_), .found = "one more"});
  if (index(fields, "index", nodes_) != i) {
    fields.refuse({.expected = fmt::format("index {}", i), .found = fields.value("index").dump()});
  }
  tree.parent.push_back(index(fields, "parent", nodes_));
  tree.first_parent.push_back(index(fields, "first_parent", i + 1));
  tree.tree.push_back(static_cast<std::uint8_t>(index(fields, "tree", 2)));
  const auto cost = fields.number("cost");
  if (!cost || *cost < 0) fields.refuse({.key = "cost", .expected = "a number of metres >= 0"});
  tree.cost.push_back(*cost);
  tree.points.push_back(fields.point("point"));
}

SearchTreeRecord SearchTreeReader::finish(std::string_view source, std::size_t line) && {
  if (!complete()) {
    throw geom::InputError(source, line,
                           {.expected = fmt::format("a tree of {}", geom::counted(nodes_, "node")),
                            .found = fmt::to_string(record_.tree.points.size())});
  }
  return std::move(record_);
}

}  // namespace plan
