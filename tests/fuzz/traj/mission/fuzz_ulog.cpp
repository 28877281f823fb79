#include "fuzz/readers.h"
#include "traj/mission/ulog/px4_flight.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const traj::Px4Options over{traj::MissionFrame{{47, 8, 400}, 0}};
  refuses_or_reads(data, size, [&](std::istream& in) { traj::read_px4_flight(in, "fuzz", over); });
  return refuses_or_reads(data, size,
                          [](std::istream& in) { traj::read_px4_flight(in, "fuzz", {}); });
}
