#pragma once

// The surfaces of a GML document: polygons, what is made of them, and links between these.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geom/import/city_model.h"

namespace geom::gis {

// A shape is polygons, other shapes, and links to shapes that may come later. Shapes with an id can
// be linked to.
class GmlShapes {
 public:
  using Index = std::size_t;

  // An empty shape; `id` may be empty.
  Index add_shape(const std::string& id);
  void add_polygon(Index to, CitySurface polygon);
  void add_part(Index to, Index shape);
  void add_link(Index to, std::string id);
  bool has(const std::string& id) const { return by_id_.contains(id); }

  struct Surfaces {
    std::vector<CitySurface> surfaces;  // each polygon once
    std::vector<Index> polygons;        // their numbers
    std::string lost;                   // a link that leads nowhere, or to two shapes

    bool within_reach() const;  // all corners, of kLargestCoordinate
  };
  // Once the document is read. `place`: for a shape in coordinates of its own.
  Surfaces surfaces_of(Index shape, const std::optional<Eigen::Matrix4d>& place = {}) const;

 private:
  struct Shape {
    std::vector<Index> polygons;
    std::vector<Index> parts;
    std::vector<std::string> links;
  };
  void collect(Index shape, std::set<Index>& seen, std::vector<Index>& polygons,
               std::string& lost) const;

  std::vector<CitySurface> polygons_;
  std::vector<Shape> shapes_;
  std::map<std::string, Index> by_id_;
  std::set<std::string> twice_;  // ids of more than one shape
};

// Points from the text of pos (which counts its own numbers), posList and coordinates. Nothing
// where it is no whole number of points of that dimension, or one is no finite number.
struct GmlNumbers {
  int dimension = 3;
  std::string between_numbers = " ";  // besides white space
  std::string between_points = " ";
  char decimal = '.';
  bool one = false;  // one point, of as many numbers as there are
};
std::optional<std::vector<double>> gml_numbers(std::string_view text, const GmlNumbers& form);

}  // namespace geom::gis
