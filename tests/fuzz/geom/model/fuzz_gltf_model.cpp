#include "fuzz/readers.h"
#include "geom/model/gltf_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    geom::read_gltf(bytes, "fuzz", [&](const std::string&) { return bytes; });
  });
}
