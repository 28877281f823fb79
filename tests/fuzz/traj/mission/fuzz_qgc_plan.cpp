#include "fuzz/readers.h"
#include "traj/mission/mavlink/mission_flight.h"
#include "traj/mission/formats/qgc_plan.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    traj::flown_mission(traj::read_qgc_plan(in, "fuzz"), {{47, 8, 400}, 0}, {}, "fuzz");
  });
}
