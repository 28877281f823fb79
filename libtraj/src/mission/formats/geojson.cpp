#include "geom/gis/footprint_format.h"
#include "mission/formats/geo_format.h"
#include "mission/formats/text_head.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

constexpr std::string_view kReaders[] = {"skyway-footprints",        "skyway-map",  "skyway-check",
                                         "skyway-import-trajectory", "skyway-plan", "skyway-bench"};

bool begins(std::string_view text) {
  return text_head(text).starts_with("{") && text.find("\"fileType\"") == std::string_view::npos &&
         text.find("\"coordinates\"") != std::string_view::npos;
}

ReadFlights read(std::istream& in, const ReadTask& task) {
  return fly_lines(read_geojson(in, task.source), LineHeights::above_ellipsoid, task);
}

WrittenMission write(const MissionTask& task, const geom::Polyline& legs) {
  return write_line(task, legs, LineHeights::above_ellipsoid, write_geojson);
}

}  // namespace

constinit const MissionFormat kGeojson{
    .format = {.word = "geojson",
               .what = "a GeoJSON file",
               .begins = [](std::string_view head) { return geom::gis::kGeoJsonFile.begins(head); },
               .readers = kReaders},
    .may_be = begins,
    .read = read,
    .write = write,
    .reads_with = {FileOption::origin, FileOption::navigation, FileOption::tracking},
    .writes_with = {FileOption::tolerance, FileOption::origin, FileOption::navigation,
                    FileOption::tracking},
    .has_legs = true,
    .heights = FileHeights::absolute};

}  // namespace traj
