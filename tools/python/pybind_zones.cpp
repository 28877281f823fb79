// Zones of airspace as states publish them.

#include "cli/file/files.h"
#include "geom/zone/read_zones.h"
#include "pybind_module.h"

namespace binding {
namespace {

py::list places(const std::vector<geom::GeodeticPlace>& ring) {
  py::list out;
  for (const geom::GeodeticPlace& p : ring) out.append(py::make_tuple(p.latitude, p.longitude));
  return out;
}

py::object limit(const std::optional<geom::HeightLimit>& limit) {
  if (!limit) return py::none();
  return py::make_tuple(limit->metres,
                        std::string(geom::word_of(geom::kHeightReferenceWords, limit->from)));
}

py::dict dict_of(const geom::ZoneVolume& volume) {
  py::dict out;
  if (volume.outline.ring.empty()) {
    out["centre"] = py::make_tuple(volume.outline.centre.latitude, volume.outline.centre.longitude);
    out["radius"] = volume.outline.radius;
  } else {
    out["ring"] = places(volume.outline.ring);
    py::list holes;
    for (const auto& hole : volume.holes) holes.append(places(hole));
    out["holes"] = holes;
  }
  out["lower"] = limit(volume.lower);
  out["upper"] = limit(volume.upper);
  return out;
}

// An event of the sun, or the seconds after midnight UTC between which the time lies.
py::object day_time(const std::optional<geom::DayTime>& time) {
  if (!time) return py::none();
  if (time->event) return py::str(std::string(geom::word_of(geom::kDayEventWords, *time->event)));
  return py::make_tuple(time->least, time->most);
}

py::dict dict_of(const geom::ZonePeriod& period) {
  py::dict out;
  out["start"] = period.start;
  out["end"] = period.end;
  py::list schedule;
  for (const geom::DailyPeriod& daily : period.schedule) {
    py::list days;  // after Monday
    for (int day = 0; day < 7; ++day) {
      if (daily.days >> day & 1) days.append(day);
    }
    py::dict one;
    one["days"] = days;
    one["begin"] = day_time(daily.begin);
    one["end"] = day_time(daily.end);
    schedule.append(one);
  }
  out["schedule"] = schedule;
  return out;
}

py::dict dict_of(const geom::Zone& zone);

template <class Value>
py::list list_of(const std::vector<Value>& values) {
  py::list out;
  for (const Value& value : values) out.append(dict_of(value));
  return out;
}

py::dict dict_of(const geom::Zone& zone) {
  py::dict out;
  out["identifier"] = in_python(zone.identifier);
  out["name"] = in_python(zone.name);
  out["country"] = in_python(zone.country);
  out["type"] = std::string(geom::name(zone.type));
  out["authority"] = in_python(zone.authority);
  out["message"] = in_python(zone.message);
  out["volumes"] = list_of(zone.volumes);
  out["periods"] = list_of(zone.periods);
  return out;
}

py::dict read_zones(const std::string& path) {
  cli::InputFile file(path);
  const geom::ZoneFile read = geom::read_zones(file.read_all(), file.name());
  py::dict out;
  out["format"] = read.format;
  out["title"] = in_python(read.title);
  out["issued"] = read.issued;
  out["valid_from"] = read.valid_from;
  out["valid_to"] = read.valid_to;
  out["zones"] = list_of(read.zones);
  py::list warnings;
  for (const std::string& text : read.warnings) warnings.append(in_python(text));
  out["warnings"] = warnings;
  return out;
}

}  // namespace

void bind_zones(py::module_& module) { module.def("read_zones", &read_zones, py::arg("path")); }

}  // namespace binding
