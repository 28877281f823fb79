#pragma once

// The second pass over a city model: links are followed, and surfaces come to their objects.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geom/import/city_model.h"
#include "gml_drawn.h"
#include "gml_geometry.h"
#include "gml_objects.h"

namespace geom::gis {

// What was read of a document, and where its links lead. Filled while it is read, settled once.
class GmlDrawing {
 public:
  GmlObjects objects;
  GmlShapes shapes;

  // A geometry of an object, within the boundaries of these ids; some may be empty.
  void add(GmlDrawn drawn, const std::vector<std::string>& boundaries);
  void place_last(const Eigen::Matrix4d& place) { drawn_.back().place = place; }
  void add_link(GmlLink link) { links_.push_back(std::move(link)); }
  void add_id(std::string_view id) { ids_.emplace(id); }  // of what is no shape

  // Gives `model` the objects with their surfaces, and counts what links do not lead to. Throws
  // geom::InputError(source, …) for surfaces beyond 1e8, and more than 50 million of them.
  void settle(CityModel& model, const std::string& source);

 private:
  void follow(const GmlLink& link, CityModel& model);
  void place(const GmlDrawn& drawn, CityModel& model, const std::string& source);
  void drop_known(const GmlDrawn& drawn, GmlShapes::Surfaces& found);

  std::vector<GmlDrawn> drawn_;
  std::map<std::string, std::vector<std::size_t>> drawn_of_;  // boundaries, by their ids
  std::vector<GmlLink> links_;                                // to objects and boundaries
  std::set<std::string, std::less<>> ids_;
  std::size_t taken_ = 0;  // surfaces of objects
  std::map<std::pair<std::size_t, double>, std::set<GmlShapes::Index>> known_;
};

}  // namespace geom::gis
