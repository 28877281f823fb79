#include "fuzz/readers.h"
#include "traj/mission/firmware/autopilot_settings.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    traj::set_autopilot(traj::read_autopilot_settings(in, "fuzz"), {traj::px4(), traj::ardupilot()},
                        "fuzz");
  });
}
