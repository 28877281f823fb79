#include "fuzz/readers.h"
#include "traj/mission/formats/tello.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const traj::TelloFlight flight = traj::read_tello(in, "fuzz");
    traj::tello_path(flight, {});
    traj::tello_times(flight, {});
  });
}
