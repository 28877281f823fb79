#pragma once

// What the tags of an OpenStreetMap object say of the obstacle that it is.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geom::gis {

// Tags in small letters, those of one key together: "disused:man_made" is `man_made`, as what is
// disused, abandoned, a ruin or being built stands there, and "tower;antenna" is two values.
class OsmTags {
 public:
  void add(std::string_view key, std::string_view value);
  bool empty() const { return tags_.empty(); }

  // All values of a key, in any case, as text, with semicolons between; empty where there is none.
  std::string text(std::string_view key) const;
  std::vector<std::string> values(std::string_view key) const;
  bool has(std::string_view key, std::string_view value) const;

 private:
  struct Tag {
    std::string key;
    std::string text;  // as it stands
  };
  std::vector<Tag> tags_;
};

// Whether it stands on an area, and is built from its outline: a building, a part of one, or a
// tower, mast, chimney, silo or the like.
bool is_built(const OsmTags& tags);

// What that is, in a word: "building", "building:part", or the value of `man_made`, as "tower".
// Empty where it is not built.
std::string type_of_built(const OsmTags& tags);

// Whether it is high, and drawn as a point or a line whose width nothing tells.
bool is_high_line(const OsmTags& tags);

// The tag of another obstacle, such as "bridge=yes" or "historic=monument with a height": a list of
// what is known to be flat decides, so that words nobody has listed are obstacles. "thing with a
// height" where nothing else tells what it is. Nothing of what is no obstacle.
std::optional<std::string> other_obstacle(const OsmTags& tags);

}  // namespace geom::gis
