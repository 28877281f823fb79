#pragma once

// The objects of a GML document, what they are parts of, and links from one to another.

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geom/import/city_model.h"
#include "text/xml_events.h"

namespace geom::gis {

// A link in a property of an object, or of the model itself, in place of what would stand there.
struct GmlLink {
  std::optional<std::size_t> from;  // the object
  std::string property;
  std::string target;  // an id in this file, or whatever else was written
  std::size_t line = 0;
};

class GmlObjects {
 public:
  using Index = std::size_t;

  // Opens an object within the innermost open one. `member`: it stands by itself, though it is
  // written in a group. `kept`: it counts as an object even if it has no surfaces.
  Index begin(const XmlTag& tag, bool member, bool kept);
  void end();  // the innermost

  bool any_open() const { return !open_.empty(); }
  Index innermost() const { return open_.back(); }
  CityObject& operator[](Index i) { return entries_[i].object; }
  // Something was said of the innermost object, so that its number must stay.
  CityObject& use();

  // The object of this id; nothing where there is none, or two.
  std::optional<Index> find(const std::string& id) const;

  // Makes `part` a part of `whole`, where its type is of parts, and it stands by itself.
  void join(Index whole, Index part);

  // The objects once all is read: without those that only hold data, and without interiors that
  // have no shape.
  std::vector<CityObject> settle();

 private:
  struct Entry {
    CityObject object;
    std::optional<Index> within;  // the object that it is a part of
    bool kept = false;
    bool used = false;
  };
  Index whole_of(Index i) const;

  std::vector<Entry> entries_;
  std::vector<std::pair<Index, Index>> joined_;  // a whole and its part
  std::vector<Index> open_;
  std::map<std::string, Index> by_id_;
  std::set<std::string> twice_;
};

}  // namespace geom::gis
