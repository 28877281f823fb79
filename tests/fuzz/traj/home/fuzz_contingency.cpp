#include "fuzz/readers.h"
#include "traj/home/contingency_record.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string line(reinterpret_cast<const char*>(data), size);
  return refuses_or_reads(data, size,
                          [&](std::istream&) { traj::parse_contingency_record(line, "fuzz", 1); });
}
