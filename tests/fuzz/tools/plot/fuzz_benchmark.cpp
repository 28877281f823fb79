#include "fuzz/readers.h"
#include "plot/comparison.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  return refuses_or_reads(data, size, [&](std::istream&) {
    const auto report = plot::parse_comparison(geom::JsonFields(text, "fuzz", 0), "fuzz");
    plot::comparison(std::span(&report, 1));
  });
}
