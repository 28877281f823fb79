#pragma once

// A map, and which records are of it.
//
// Example:
//   geom::NamedMap named(map);
//   named.require(geom::provenance_of(scene), "paths.jsonl", 1);  // throws for another map

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "geom/map/box_map.h"
#include "geom/record/record.h"

namespace geom {

class NamedMap {
 public:
  explicit NamedMap(BoxMap map) : map_(std::move(map)) {}

  const BoxMap& map() const { return map_; }

  // Throws InputError(source, line, …) where the record names another map or frame. One of
  // the map without its boxes that are there for a time is of this one: whoever decides looks at
  // them.
  void require(const Provenance& record, std::string_view source, std::size_t line);

 private:
  bool is_of_always_there(const Provenance& record);

  BoxMap map_;
  std::optional<std::string> always_there_;  // the hash, once it was asked for
};

}  // namespace geom
