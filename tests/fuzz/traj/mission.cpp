#include "fuzz/reader.h"
#include "traj/mission/dji/dji_flight.h"
#include "traj/mission/dji/dji_wpml.h"
#include "traj/mission/firmware/autopilot_settings.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/formats/crazyflie.h"
#include "traj/mission/formats/geo_line.h"
#include "traj/mission/formats/gltf_line.h"
#include "traj/mission/formats/qgc_plan.h"
#include "traj/mission/formats/setpoints.h"
#include "traj/mission/formats/tello.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/mavlink/mission_flight.h"
#include "traj/mission/ulog/px4_flight.h"

namespace {

const traj::MissionFrame kFrame{{47, 8, 400}, 0};

// A KMZ, or its waylines alone, or these, a line "%%" and the template.
traj::DjiMission read_dji(std::istream& in) {
  if (in.peek() == 'P') return traj::read_dji_kmz(in, "fuzz");
  const std::string text = fuzz::rest_of(in);
  const std::size_t cut = text.find("\n%%\n");
  if (cut == text.npos) return traj::read_dji_wpml(text, "", "fuzz");
  return traj::read_dji_wpml(text.substr(0, cut), text.substr(cut + 4), "fuzz");
}

void autopilot_settings(std::istream& in) {
  traj::set_autopilot(traj::read_autopilot_settings(in, "fuzz"), {traj::px4(), traj::ardupilot()},
                      "fuzz");
}

void tello(std::istream& in) {
  const traj::TelloFlight flight = traj::read_tello(in, "fuzz");
  traj::tello_path(flight, {});
  traj::tello_times(flight, {});
}

// Where the origin is given, and where the log has to name it.
void ulog(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  const traj::Px4Options over{kFrame};
  fuzz::takes(bytes, [&](std::istream& it) { traj::read_px4_flight(it, "fuzz", over); });
  fuzz::takes(bytes, [](std::istream& it) { traj::read_px4_flight(it, "fuzz", {}); });
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"autopilot_settings", autopilot_settings},
          {"crazyflie", [](std::istream& in) { traj::read_crazyflie(in, "fuzz"); }},
          {"dji_wpml",
           [](std::istream& in) {
             traj::flown_dji(read_dji(in), kFrame, {400, 50}, "fuzz");
           }},
          {"geojson_line", [](std::istream& in) { traj::read_geojson(in, "fuzz"); }},
          {"gltf_line", [](std::istream& in) { traj::read_gltf_lines(in, "fuzz"); }},
          {"kml", [](std::istream& in) { traj::read_kml(in, "fuzz"); }},
          {"qgc_plan",
           [](std::istream& in) {
             traj::flown_mission(traj::read_qgc_plan(in, "fuzz"), kFrame, {}, "fuzz");
           }},
          {"setpoints",
           [](std::istream& in) { traj::straight_between(traj::read_setpoints(in, "fuzz")); }},
          {"tello", tello},
          {"ulog", ulog},
          {"wpl", [](std::istream& in) {
             traj::flown_mission(traj::read_wpl(in, "fuzz"), kFrame, {}, "fuzz");
           }}};
}
