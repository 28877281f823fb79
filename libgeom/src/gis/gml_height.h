#pragma once

// A height of CityGML 3.0: a number, and between which points of a construction it was taken.

#include <string>

namespace geom::gis {

struct GmlHeight {
  std::string value;  // with its unit
  std::string high;   // highReference
  std::string low;    // lowReference

  // As an attribute: "8.55 m" where it reaches from the lowest ground to the highest point, and
  // otherwise words that are no length, since the object may be higher.
  std::string text() const;

  // Of two heights of an object, the one that tells more.
  static std::string higher(const std::string& a, const std::string& b);
};

}  // namespace geom::gis
