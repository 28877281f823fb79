#pragma once

// Obstacles, or possible ones, that a reader could not build.
//
// Example:
//   geom::Skipped skipped;
//   skipped.add("unknown keyword", "line 7: window");
//   skipped.add("unknown keyword", "line 9: blok");
//   assert(skipped.text() == "2 x unknown keyword (line 7: window, line 9: blok)");

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace geom {

// Counts by kind, and the names of the first few of each. Code that makes a map of the rest
// either refuses, or writes the count into the map (`allow_skipped` of the readers).
class Skipped {
 public:
  // `kind`: "unknown keyword"; `which`: "line 7: window".
  void add(const std::string& kind, std::string which);
  void add(const Skipped& other);
  void add_of(std::string_view file, const Skipped& other);  // its names say that they are of that

  bool empty() const { return kinds_.empty(); }
  std::size_t count() const;

  std::map<std::string, std::size_t> by_kind() const;

  // "2 x unknown keyword (line 7: window, line 9: blok), 1 x Point (feature 3)"; of more than a
  // dozen kinds the eight most frequent with one name each, "and 31 of 20 more kinds".
  std::string text() const;

 private:
  struct Kind {
    std::size_t count = 0;
    std::vector<std::string> first;
  };
  std::map<std::string, Kind> kinds_;
};

}  // namespace geom
