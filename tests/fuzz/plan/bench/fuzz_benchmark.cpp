#include "fuzz/readers.h"
#include "plan/bench/compared_figure.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  return refuses_or_reads(data, size, [&](std::istream&) {
    const auto report = plan::bench::parse_report(geom::JsonFields(text, "fuzz", 0), "fuzz");
    plan::bench::compared_figure(std::span(&report, 1));
  });
}
