#pragma once

// XML as a tree: what a KML, WPML or SDF file holds, read to its end.
//
// Example:
//   const geom::XmlElement kml = geom::parse_xml("<kml><Point>8,47</Point></kml>", "a.kml");
//   assert(kml.children[0].name == "Point" && kml.children[0].text == "8,47");

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geom {

struct XmlElement {
  std::string name;      // without its namespace's prefix: "LineString", also of "kml:LineString"
  std::string prefix;    // "kml" of that; empty where there is none
  std::size_t line = 0;  // where it begins
  std::vector<std::pair<std::string, std::string>> attributes;  // in their order, entities resolved
  std::string text;  // its own character data, entities resolved
  std::vector<XmlElement> children;
};

// The root element. Comments and processing instructions are left out. Throws InputError
// (source, line, …) for text that is not well-formed XML 1.0 in UTF-8 from its first byte to its
// last, for a document type or an inclusion
// (xml_head.h), and for elements nested deeper than 100.
XmlElement parse_xml(std::string_view text, std::string_view source);

}  // namespace geom
