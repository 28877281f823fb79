#include "geom/mesh/glb.h"

#include <cstdint>
#include <ostream>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"

namespace geom {
namespace {

void pad(std::string& bytes, char with) {
  while (bytes.size() % 4) bytes += with;
}

}  // namespace

Vec3 to_gltf(const Vec3& enu) { return {enu.x(), enu.z(), -enu.y()}; }

void write_glb_container(std::ostream& out, std::string json, std::string bin) {
  pad(json, ' ');
  pad(bin, '\0');
  const std::size_t size = 12 + 8 + json.size() + (bin.empty() ? 0 : 8 + bin.size());
  if (size > 0xffffffffu) {
    throw InputError("glTF", "expected at most the 4 GB of a .glb, found more");
  }
  std::string head = "glTF";
  append_bytes(head, std::uint32_t{2});
  append_bytes(head, static_cast<std::uint32_t>(size));
  append_bytes(head, static_cast<std::uint32_t>(json.size()));
  head += "JSON" + json;
  if (bin.empty()) {
    out << head;
    return;
  }
  std::string chunk;
  append_bytes(chunk, static_cast<std::uint32_t>(bin.size()));
  chunk += std::string("BIN\0", 4);
  out << head << chunk << bin;
}

}  // namespace geom
