#include "flight/airframe_record.h"
#include "fuzz/reader.h"
#include "geom/text/json_fields.h"
#include "traj/flight/flight_log.h"

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"airframe",
           [](std::istream& in) {
             traj::parse_airframe(geom::JsonFields(fuzz::rest_of(in), "fuzz", 0));
           }},
          {"flight_log", [](std::istream& in) { traj::read_flight_log(in, "fuzz"); }}};
}
