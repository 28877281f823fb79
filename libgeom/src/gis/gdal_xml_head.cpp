#include "gdal_handles.h"
#include "text/xml_head.h"
#include "xml_heads.h"

namespace geom::gis {
namespace {

FileHandle open_file(const std::string& path) {
  return FileHandle(gdal().open_file(path.c_str(), "rb"));
}

std::string next_part(VSILFILE* file) {
  std::string part(kXmlHead, '\0');
  part.resize(gdal().read_file(part.data(), 1, part.size(), file));
  return part;
}

void require_plain(const std::string& path, const std::string& name) {
  const FileHandle file = open_file(path);
  XmlWatch watch(name);
  for (std::string part; file && !(part = next_part(file.get())).empty();) watch.look(part);
}

bool is_markup(const std::string& entry) {
  for (const char* ending : {"kml", "gml", "gpx", "xml"}) {
    if (EQUAL(gdal().extension_of(entry.c_str()), ending)) return true;
  }
  return false;
}

}  // namespace

void require_plain_vector(const std::string& path, const std::string& name) {
  const FileHandle file = open_file(path);
  const std::string head = file ? next_part(file.get()) : "";
  if (head.starts_with("\x1f\x8b")) {
    require_plain("/vsigzip/" + path, name);
  } else if (head.starts_with("PK\x03\x04")) {
    const ListHandle entries(gdal().list_files(("/vsizip/" + path).c_str()));
    for (char** entry = entries.get(); entry && *entry; ++entry) {
      if (!is_markup(*entry)) continue;
      require_plain("/vsizip/" + path + "/" + *entry, name);
    }
  } else if (const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
             (first != head.npos && head[first] == '<') || is_markup(path)) {
    require_plain(path, name);
  }
}

}  // namespace geom::gis
