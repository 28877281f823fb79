#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <memory>
#include <string_view>

#include "geom/text/xml_head.h"
#include "xml_heads.h"

namespace geom::gis {
namespace {

std::string head_of(const std::string& path) {
  struct Close {
    void operator()(VSILFILE* file) const { VSIFCloseL(file); }
  };
  const std::unique_ptr<VSILFILE, Close> file(VSIFOpenL(path.c_str(), "rb"));
  if (!file) return "";
  std::string head(kXmlHead, '\0');
  head.resize(VSIFReadL(head.data(), 1, head.size(), file.get()));
  return head;
}

bool is_markup(const std::string& entry) {
  for (const char* ending : {"kml", "gml", "gpx", "xml"}) {
    if (EQUAL(CPLGetExtension(entry.c_str()), ending)) return true;
  }
  return false;
}

}  // namespace

void require_plain_vector(const std::string& path, const std::string& name) {
  const std::string head = head_of(path);
  if (head.starts_with("\x1f\x8b")) {
    require_plain_xml(head_of("/vsigzip/" + path), name);
  } else if (head.starts_with("PK\x03\x04")) {
    const CPLStringList entries(VSIReadDirRecursive(("/vsizip/" + path).c_str()));
    for (int i = 0; i < entries.size(); ++i) {
      if (!is_markup(entries[i])) continue;
      require_plain_xml(head_of("/vsizip/" + path + "/" + entries[i]), name);
    }
  } else if (const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
             (first != head.npos && head[first] == '<') || is_markup(path)) {
    require_plain_xml(head, name);
  }
}

}  // namespace geom::gis
