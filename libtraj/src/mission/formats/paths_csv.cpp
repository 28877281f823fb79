#include <utility>

#include "geom/record/path_csv.h"
#include "geom/text/beginning.h"
#include "traj/curve/to_enu.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

ReadFlights read(std::istream& in, const ReadTask& task) {
  ReadFlights out;
  for (geom::PathRecord& record : geom::read_path_csv(in, task.source, task.frame.axes)) {
    out.ids.push_back(std::move(record.id));
    out.flights.push_back({FlownLegs{to_enu(task.frame.axes, std::move(record.points))}});
  }
  return out;
}

}  // namespace

constinit const MissionFormat kPathsCsv{
    .format = {.word = "paths-csv",
               .what = "a table of paths",
               .begins = geom::text_begins_with<"id,x,y,z">,
               .readers = kDroneReaders},
    .may_be = [](std::string_view text) { return text.starts_with("id,x,y,z"); },
    .read = read,
    .is_flown = false};

}  // namespace traj
