#include "geom/gis/footprint_format.h"
#include "mission/formats/geo_format.h"
#include "mission/formats/text_head.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

constexpr std::string_view kReaders[] = {"skyway-check", "skyway-import-trajectory",
                                         "skyway-footprints"};

ReadFlights read(std::istream& in, const ReadTask& task) {
  return fly_lines(read_kml(in, task.source), LineHeights::above_sea, task);
}

WrittenMission write(const MissionTask& task, const geom::Polyline& legs) {
  return write_line(task, legs, LineHeights::above_sea, write_kml);
}

}  // namespace

constinit const MissionFormat kKml{
    .format = {.word = "kml",
               .what = "a KML file",
               .begins = [](std::string_view head) { return geom::gis::kKmlFile.begins(head); },
               .readers = kReaders},
    .may_be =
        [](std::string_view text) {
          return text_head(text).starts_with("<") && text.find("<kml") != std::string_view::npos;
        },
    .read = read,
    .write = write,
    .reads_with = {FileOption::origin, FileOption::geoid, FileOption::geoid_grid,
                   FileOption::navigation, FileOption::tracking},
    .writes_with = {FileOption::tolerance, FileOption::origin, FileOption::geoid,
                    FileOption::geoid_grid, FileOption::navigation, FileOption::tracking},
    .has_legs = true,
    .heights = FileHeights::absolute};

}  // namespace traj
