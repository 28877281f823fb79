#pragma once

// One polygon of a GML document, as its elements come by.

#include <optional>
#include <string>
#include <string_view>

#include "geom/import/city_model.h"
#include "gml_geometry.h"
#include "text/xml_events.h"

namespace geom::gis {

// Whether an element of this name holds coordinates.
bool is_gml_numbers(std::string_view name);

struct GmlPolygon {
  CitySurface rings;
  bool curved = false;
  bool flat = false;  // without heights

  // An element within the polygon; how its text is to be read where that is coordinates.
  std::optional<GmlNumbers> take(const XmlTag& tag, int dimension, const std::string& name);

  // The points of a text. Throws InputError(name, line, …) where it has none.
  void add(std::string_view text, GmlNumbers form, const std::string& name, std::size_t line);

  // Why it cannot be built, as "surface with curves"; empty where it can.
  std::string wrong() const;
};

}  // namespace geom::gis
