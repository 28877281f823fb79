#include "fuzz/readers.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/formats/setpoints.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    traj::straight_between(traj::read_setpoints(in, "fuzz"));
  });
}
