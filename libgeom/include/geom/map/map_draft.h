#pragma once

// A map before it is made: the boxes that a reader found, and what it knows of their source.
//
// Example:
//   geom::MapDraft draft{.source = "mine", .history = "[]"};
//   draft.table.add({{0, 0, 0}, {10, 10, 8}}, 1);
//   draft.options.pad = 20;
//   const geom::BoxMap made = geom::make_map(std::move(draft)).map;

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "geom/map/make_map.h"

namespace geom {

// A number or a word about what was read, by its name: {"footprints", 12}.
using Fact = std::pair<std::string, std::variant<std::string, std::size_t, double>>;

// Parts of one source have drafts that differ in their tables alone.
struct MapDraft {
  std::string source;  // for messages
  BoxTable table;      // in the numbers of the source
  Frame frame;
  MakeMapOptions options;  // those that were asked for, completed by what the source says
  std::string history;     // JSON: a list of one step, which says what was read and how
  std::vector<Fact> facts;
};

// Throws InputError as the other make_map() does, and where there is no box.
MadeMap make_map(MapDraft draft, const Execution& run = {});

// How many obstacles the steps of a map's history left out.
std::size_t skipped_in(const BoxMapSpec& spec);

}  // namespace geom
