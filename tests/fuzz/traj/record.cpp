#include "geom/record/record.h"

#include "fuzz/reader.h"
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

// The line as a record of every kind.
void records(std::istream& in) {
  const std::string line = fuzz::rest_of(in);
  fuzz::takes(line, [&](std::istream&) { geom::parse_path_record(line, "fuzz", 1); });
  fuzz::takes(line, [&](std::istream&) { traj::parse_report_record(line, "fuzz", 1); });
  fuzz::takes(line, [&](std::istream&) { traj::parse_corridor_record(line, "fuzz", 1); });
  fuzz::takes(line, read_tree);
  fuzz::takes(line, [&](std::istream&) { traj::parse_moving_record(line, "fuzz", 1); });
  fuzz::takes(line, [&](std::istream&) { traj::parse_trajectory_record(line, "fuzz", 1); });
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() { return {{"records", records}}; }
