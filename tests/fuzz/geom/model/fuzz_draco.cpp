#include "fuzz/readers.h"
#include "model/draco_decoder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    geom::decode_draco(std::string(std::istreambuf_iterator<char>(in), {}), "fuzz");
  });
}
