#include <iterator>

#include "fuzz/readers.h"
#include "traj/mission/dji/dji_wpml.h"

namespace {

// A KMZ, or its waylines alone, or these, a line "%%" and the template.
traj::DjiMission read(std::istream& in) {
  if (in.peek() == 'P') return traj::read_dji_kmz(in, "fuzz");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const std::size_t cut = text.find("\n%%\n");
  if (cut == text.npos) return traj::read_dji_wpml(text, "", "fuzz");
  return traj::read_dji_wpml(text.substr(0, cut), text.substr(cut + 4), "fuzz");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    traj::flown_dji(read(in), {{47, 8, 400}, 0}, {400, 50}, "fuzz");
  });
}
