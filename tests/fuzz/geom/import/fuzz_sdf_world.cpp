#include "fuzz/readers.h"
#include "geom/import/sdf_world.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const geom::SdfFile model{
      "model",
      "<sdf version='1.6'><model name='i'><link name='l'><visual name='v'><geometry><box>"
      "<size>1 1 1</size></box></geometry></visual></link></model></sdf>"};
  const geom::SdfFile mesh{"mesh", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nl 1 2\n"};
  geom::SdfOptions options;
  options.slack = 1;  // round bodies are tried in their own tests
  options.open = [&](const std::string& uri, const std::string&) {
    return uri.empty() ? nullptr : &model;
  };
  options.open_mesh = [&](const std::string& uri, const std::string&) {
    return uri.size() > 20 ? nullptr : &mesh;
  };
  return refuses_or_reads(data, size,
                          [&](std::istream& in) { geom::read_sdf_world(in, "fuzz", options); });
}
