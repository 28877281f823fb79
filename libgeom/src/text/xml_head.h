#pragma once

// What must not stand in an XML file that is read here, by whatever library.

#include <cstddef>
#include <string>
#include <string_view>

namespace geom {

// Bytes within which the root element must begin.
inline constexpr std::size_t kXmlHead = 1 << 20;

// The namespace of elements in whose place another file should be read.
inline constexpr std::string_view kXInclude = "http://www.w3.org/2001/XInclude";

// `head`: a file from its first byte, kXmlHead of them or all. Throws InputError(source, line, …)
// for a document type, since the entities that it declares may hold more than a reader shows; for
// UTF-16 and UTF-32, where none would be seen; and where no root element begins in time. Does
// nothing for text that does not begin with a tag.
void require_plain_xml(std::string_view head, std::string_view source);

// Looks through an XML file that a library reads by itself.
class XmlWatch {
 public:
  explicit XmlWatch(std::string_view source) : source_(source) {}

  // The next part of the file; the first holds kXmlHead bytes, or all. Throws InputError(source,
  // line, …) as require_plain_xml() does, and where kXInclude is named.
  void look(std::string_view part);

 private:
  std::string source_;
  std::string last_;  // bytes of the part before, of which the name may begin
  std::size_t line_ = 1;
  bool begun_ = false;
};

// The refusal of a document type.
[[noreturn]] void refuse_document_type(std::string_view source, std::size_t line);

// That of elements of kXInclude.
[[noreturn]] void refuse_inclusion(std::string_view source, std::size_t line);

}  // namespace geom
