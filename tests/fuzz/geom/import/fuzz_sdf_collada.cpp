#include "fuzz/readers.h"
#include "geom/import/sdf_world.h"

// Whether simulators agree on the bytes as a COLLADA file that a world names.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string world =
      "<sdf version='1.6'><model name='m'><link name='l'><visual name='v'><geometry><mesh>"
      "<uri>m.dae</uri></mesh></geometry></visual></link></model></sdf>";
  const geom::SdfFile mesh{"m.dae", {reinterpret_cast<const char*>(data), size}};
  geom::SdfOptions options;
  options.open_mesh = [&](const std::string&, const std::string&) { return &mesh; };
  options.read_collada = [](const geom::SdfFile& file) {
    std::istringstream in("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    return geom::read_obj(in, file.name);
  };
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(world.data());
  return refuses_or_reads(bytes, world.size(),
                          [&](std::istream& in) { geom::read_sdf_world(in, "fuzz", options); });
}
