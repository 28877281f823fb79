#include "drone_formats.h"

#include <algorithm>

#include "fence_text.h"
#include "geom/gis/footprint_format.h"
#include "geom/model/model_format.h"
#include "geom/text/beginning.h"

namespace cli {
namespace {

using geom::Format;

constexpr std::string_view kTools[] = {"skyway-check", "skyway-import-trajectory"};

constexpr Format kDjiMission{
    .word = "dji-wpml",
    .what = "a DJI mission (KMZ with WPML)",
    .begins = geom::any_of<geom::zip_with<"wpmz/">, geom::zip_with<".wpml">>,
    .readers = kTools};
constexpr Format kCrazyflie{.word = "crazyflie",
                            .what = "a Crazyflie trajectory",
                            .begins = geom::text_begins_with<"duration,x^0,">,
                            .readers = kTools};
constexpr Format kSetpoints{
    .word = "setpoints",
    .what = "a table of setpoints",
    .begins =
        geom::any_of<geom::text_begins_with<"t_s,east_m,">, geom::text_begins_with<"t_s,x_m,">>,
    .readers = kTools};
constexpr Format kPathTable{.word = "paths-csv",
                            .what = "a table of paths",
                            .begins = geom::text_begins_with<"id,x,y,z">,
                            .readers = kTools};
constexpr Format kTello{.word = "tello",
                        .what = "a Tello script",
                        .begins = geom::text_begins_with<"command\n">,
                        .readers = kTools};

}  // namespace

constinit const Format kWplMission{.word = "wpl",
                                   .what = "a mission (WPL)",
                                   .begins =
                                       [](std::string_view head) {
                                         return geom::begins_with<"QGC WPL">(head) &&
                                                !is_fence_text(head);
                                       },
                                   .readers = kTools};
constinit const Format kQgcPlan{.word = "qgc-plan",
                                .what = "a QGroundControl plan",
                                .begins = geom::json_with<R"("fileType":"Plan")">,
                                .readers = kTools};

geom::Formats drone_formats() {
  static constexpr const Format* kTable[] = {&kCrazyflie,
                                             &kSetpoints,
                                             &kTello,
                                             &kWplMission,
                                             &kQgcPlan,
                                             &kDjiMission,
                                             &geom::gis::kKmlFile,
                                             &geom::gis::kGeoJsonFile,
                                             &geom::kGlbFile,
                                             &kPathTable};
  return kTable;
}

bool is_drone_format(const geom::Format* format) {
  const geom::Formats table = drone_formats();
  return std::find(table.begin(), table.end(), format) != table.end();
}

}  // namespace cli
