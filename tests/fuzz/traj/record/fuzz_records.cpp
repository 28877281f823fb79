#include "fuzz/readers.h"
#include "geom/record/record.h"
#include "plan/sampling/search_tree_file.h"
#include "traj/record/corridor_record.h"
#include "traj/record/moving_record.h"
#include "traj/record/report_record.h"
#include "traj/record/trajectory_record.h"

namespace {

// The first line as a header, the others as nodes.
void read_tree(std::istream& in) {
  std::string line;
  std::getline(in, line);
  plan::SearchTreeReader reader(line, "fuzz", 1);
  std::size_t number = 1;
  while (std::getline(in, line)) reader.add(line, "fuzz", ++number);
  std::move(reader).finish("fuzz", number);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string line(reinterpret_cast<const char*>(data), size);
  refuses_or_reads(data, size, [&](std::istream&) { geom::parse_path_record(line, "fuzz", 1); });
  refuses_or_reads(data, size, [&](std::istream&) { traj::parse_report_record(line, "fuzz", 1); });
  refuses_or_reads(data, size,
                   [&](std::istream&) { traj::parse_corridor_record(line, "fuzz", 1); });
  refuses_or_reads(data, size, read_tree);
  refuses_or_reads(data, size, [&](std::istream&) { traj::parse_moving_record(line, "fuzz", 1); });
  return refuses_or_reads(data, size,
                          [&](std::istream&) { traj::parse_trajectory_record(line, "fuzz", 1); });
}
