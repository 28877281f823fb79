#include <fcntl.h>

#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/file.hpp>
#include <osmium/io/gzip_compression.hpp>

#include "geom/text/xml_head.h"
#include "xml_heads.h"

namespace geom::gis {
namespace {

// What a reader will be given, from its first byte; less where the file cannot be read, which the
// reader says better.
std::string head_of(const osmium::io::File& file) {
  std::string head;
  try {
    const int descriptor = ::open(file.filename().c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return head;
    const auto unpacked = osmium::io::CompressionFactory::instance().create_decompressor(
        file.compression(), descriptor);
    while (head.size() < kXmlHead) {
      const std::string part = unpacked->read();
      if (part.empty()) break;
      head += part;
    }
    unpacked->close();
  } catch (const std::exception&) {
  }
  return head;
}

}  // namespace

void require_plain_osm(const std::string& path, const std::string& name) {
  const osmium::io::File file(path);
  if (file.format() == osmium::io::file_format::xml) require_plain_xml(head_of(file), name);
}

}  // namespace geom::gis
