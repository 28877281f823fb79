#pragma once

// The one XML reader: tags, texts and ends of elements in the order of the file.

#include <cstddef>
#include <istream>
#include <span>
#include <string>
#include <string_view>

namespace geom {

struct XmlAttribute {
  std::string_view name;  // as it is written: "gml:id", "xmlns"
  std::string_view value;
};

// The tag that begins an element. Its texts are valid only during XmlHandler::begin.
struct XmlTag {
  std::string_view space;   // the URI of its namespace; empty if it has none
  std::string_view prefix;  // "gml" of <gml:pos>
  std::string_view name;    // "pos" of <gml:pos>
  std::span<const XmlAttribute> attributes;
  std::size_t line = 0;

  // The prefix stands for no namespace.
  bool has_unknown_prefix() const { return !prefix.empty() && space.empty(); }

  // The value of the attribute of that name, with any prefix or none. Empty if there is none.
  std::string_view attribute(std::string_view of) const {
    for (const auto& [key, value] : attributes) {
      if (!key.ends_with(of) || key.starts_with("xmlns")) continue;
      if (key.size() == of.size() || key[key.size() - of.size() - 1] == ':') return value;
    }
    return {};
  }
};

class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  virtual void begin(const XmlTag& tag) = 0;
  virtual void text(std::string_view part) = 0;  // of the innermost element, in pieces; UTF-8
  virtual void end(std::size_t line) = 0;
};

// Reads a whole document: XML 1.0 in UTF-8, UTF-16, ISO-8859-1, US-ASCII or windows-1252. Holds no
// more of it than one tag. Throws what the handler throws. Throws InputError(source, line, …) for
// text that is not well-formed to its end, for a document type or an element of XInclude
// (xml_head.h), for another encoding, and for elements nested deeper than 200. A prefix that is not
// declared is no error. The stream's reader throws std::system_error if reading fails.
void read_xml(std::istream& in, const std::string& source, XmlHandler& handler);
void read_xml(std::string_view text, const std::string& source, XmlHandler& handler);

}  // namespace geom
