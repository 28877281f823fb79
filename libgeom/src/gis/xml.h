#pragma once

// XML as the elements that come by.

#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geom::gis {

struct XmlElement {
  std::string space;                                            // the URI of its namespace
  std::string name;                                             // without prefix
  std::vector<std::pair<std::string, std::string>> attributes;  // names without prefix
  std::size_t line = 0;

  // Empty where there is none.
  std::string_view attribute(std::string_view of) const {
    for (const auto& [key, value] : attributes) {
      if (key == of) return value;
    }
    return {};
  }
};

class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  virtual void begin(XmlElement element) = 0;
  virtual void text(std::string_view part) = 0;  // of the innermost element, in pieces
  virtual void end(std::size_t line) = 0;
};

// Reads the whole document. What the handler throws comes out. Throws InputError(name, line,
// …) for what is no well-formed XML, for one that is cut, for elements nested deeper than 200, and
// for a document type or an inclusion (geom/text/xml_head.h); std::system_error where reading
// fails.
void read_xml(std::istream& in, const std::string& name, XmlHandler& handler);

}  // namespace geom::gis
