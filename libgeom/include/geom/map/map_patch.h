#pragma once

// A map with boxes added and boxes removed, step by step.
//
// Example:
//   geom::MapPatch patch(map, "city.boxmap");
//   patch.remove({map.ids()[0]});
//   geom::BoxTable crane;
//   crane.add({{7, 7, 0}, {8, 8, 9}}, 0);
//   patch.add("added", crane);
//   assert(patch.made().size() == map.size());

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>

#include "geom/map/box_map.h"

namespace geom {

// Whole numbers between white space and commas. Throws InputError(source, line, …) for anything
// else.
std::set<std::uint64_t> parse_ids(std::string_view text, std::string_view source);

// Says which of the ids names several boxes of a joined map, and where these are, because each of
// its maps counts ids anew: the boxes may be of different obstacles. Empty where none does.
std::string shared_ids(const BoxMap& map, const std::set<std::uint64_t>& ids);

class MapPatch {
 public:
  // `source`: what messages call the map.
  MapPatch(const BoxMap& map, std::string source);
  ~MapPatch();

  // Takes out all boxes that have one of the ids, and returns how many. Throws
  // InputError(source, …) for an id that no box has.
  std::size_t remove(const std::set<std::uint64_t>& ids);

  // Adds boxes, with ids above all that are there, and returns how many. The history counts them
  // under `what`.
  std::size_t add(const char* what, BoxTable fresh);

  // The instant that the map's times count from, as geom::epoch_from() has it. Throws
  // InputError(source, …) where the map has another, which it keeps.
  void set_epoch(const std::string& epoch);

  // Says in the history what the boxes under `what` come from.
  void note(const char* what, const nlohmann::ordered_json& value);

  // Says in the history that boxes were cut to the bounds that the map has now (closed_within.h).
  void note_cut_to_bounds();
  // The same of their floor or ceiling alone.
  void note_cut_to_heights(bool below, bool above);

  const BoxMapSpec& spec() const { return spec_; }  // as far as it was changed

  // The map that was made, whose history says in one step more what was done. Throws
  // InputError(source, …) where no box is left.
  BoxMap made() const;

 private:
  struct Step;
  void note_closed_within(const Aabb& box);

  std::string source_;
  BoxMapSpec spec_;
  BoxTable table_;
  std::optional<Aabb> closed_;  // within which this patch closed what it was asked to
  std::unique_ptr<Step> step_;
};

}  // namespace geom
