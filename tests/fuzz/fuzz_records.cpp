#include "geom/io/record.h"
#include "readers.h"
#include "traj/io/trajectory_record.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string line(reinterpret_cast<const char*>(data), size);
  refuses_or_reads(data, size, [&](std::istream&) { geom::parse_path_record(line, "fuzz", 1); });
  return refuses_or_reads(data, size,
                          [&](std::istream&) { traj::parse_trajectory_record(line, "fuzz", 1); });
}
