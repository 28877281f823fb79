#include "fuzz/readers.h"
#include "mesh/draco_decoder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    mesh::decode_draco(std::string(std::istreambuf_iterator<char>(in), {}), "fuzz");
  });
}
