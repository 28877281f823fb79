#include <fcntl.h>

#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/file.hpp>
#include <osmium/io/gzip_compression.hpp>

#include "text/xml_head.h"
#include "xml_heads.h"

namespace geom::gis {
namespace {

// Looks through what a reader will be given. What cannot be read ends the look: the reader says
// better why.
void look_through(const osmium::io::File& file, XmlWatch& watch) {
  const int descriptor = ::open(file.filename().c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  const auto unpacked = osmium::io::CompressionFactory::instance().create_decompressor(
      file.compression(), descriptor);
  const auto next = [&]() -> std::string {
    try {
      return unpacked->read();
    } catch (const std::exception&) {
      return {};
    }
  };
  std::string head;
  for (std::string part; head.size() < kXmlHead && !(part = next()).empty();) head += part;
  watch.look(head);
  for (std::string part; !(part = next()).empty();) watch.look(part);
}

}  // namespace

void require_plain_osm(const std::string& path, const std::string& name) {
  const osmium::io::File file(path);
  if (file.format() != osmium::io::file_format::xml) return;
  XmlWatch watch(name);
  look_through(file, watch);
}

}  // namespace geom::gis
