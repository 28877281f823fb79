// libFuzzer's target for one reader, SKYWAY_READER.

#include <cstdlib>

#include "fuzz/reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const auto read = [] {
    for (const fuzz::Reader& reader : fuzz::readers()) {
      if (std::string(reader.name) == SKYWAY_READER) return reader.read;
    }
    std::abort();
  }();
  fuzz::takes(std::string(reinterpret_cast<const char*>(data), size), read);
  return 0;
}
