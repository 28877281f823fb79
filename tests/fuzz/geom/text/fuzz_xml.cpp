#include <iterator>

#include "fuzz/readers.h"
#include "geom/text/xml_element.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    geom::parse_xml(std::string(std::istreambuf_iterator<char>(in), {}), "fuzz");
  });
}
