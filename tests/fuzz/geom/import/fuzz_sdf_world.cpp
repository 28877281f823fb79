#include "fuzz/readers.h"
#include "geom/import/sdf_world.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const geom::SdfFile model{
      "model",
      "<sdf version='1.6'><model name='i'><link name='l'><visual name='v'><geometry><box>"
      "<size>1 1 1</size></box></geometry></visual></link></model></sdf>"};
  geom::SdfOptions options;
  options.slack = 1;  // round bodies are tried in their own tests
  options.open = [&](const std::string& uri, const std::string&) {
    return uri.empty() ? nullptr : &model;
  };
  return refuses_or_reads(data, size,
                          [&](std::istream& in) { geom::read_sdf_world(in, "fuzz", options); });
}
