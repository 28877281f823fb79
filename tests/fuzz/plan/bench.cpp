#include "fuzz/reader.h"
#include "plan/bench/compared_figure.h"

namespace {

void benchmark(std::istream& in) {
  const auto report =
      plan::bench::parse_report(geom::JsonFields(fuzz::rest_of(in), "fuzz", 0), "fuzz");
  plan::bench::compared_figure(std::span(&report, 1));
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() { return {{"benchmark", benchmark}}; }
