#include "traj/record/disturbance_record.h"

#include <fmt/format.h>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace traj {

void add(geom::JsonLine& line, const Disturbances& d) {
  line.add("wind", d.wind);
  for (const DisturbanceRange& range : kDisturbanceRanges) line.add(range.key, d.*range.value);
}

Disturbances read_disturbances(const geom::JsonFields& fields) {
  Disturbances out;
  out.wind = fields.point("wind");
  for (const DisturbanceRange& range : kDisturbanceRanges) {
    const std::string key(range.key);
    const auto value = fields.number(key.c_str());
    if (!value || *value < range.least || *value > range.most) {
      fields.refuse({.key = key,
                     .expected = fmt::format("from {:g} to {:g}", range.least, range.most),
                     .found = value ? fmt::to_string(*value) : "none"});
    }
    out.*range.value = *value;
  }
  return out;
}

std::string in_words(const Disturbances& d) {
  const std::string gusts = d.gust_most > 0
                                ? fmt::format("gusts towards at most {:g} m/s with a lag of {:g} s",
                                              d.gust_most, d.gust_lag)
                                : "no gusts";
  std::string out =
      fmt::format("a mean wind within {:g} m/s of [{:g}, {:g}, {:g}] m/s (east, north, up), {}",
                  d.wind_spread, d.wind.x(), d.wind.y(), d.wind.z(), gusts);
  if (d.start_error > 0 || d.start_speed > 0) {
    out += fmt::format(", a start within {:g} m of the first point and {:g} m/s of rest",
                       d.start_error, d.start_speed);
  }
  for (const DisturbanceRange& range : kDisturbanceRanges) {
    const bool mass = range.value == &Disturbances::mass_error;
    if (range.share_of.empty() || (!mass && d.*range.value == 0)) continue;
    out += fmt::format(", {} within {:g} % of what is believed", range.share_of,
                       100 * (d.*range.value));
  }
  if (d.has_noise()) {
    out += fmt::format(
        ", readings of the sensors within {:g} m, {:g} m/s, {:g} rad and {:g} rad/s along each "
        "axis",
        d.place_noise, d.velocity_noise, d.attitude_noise, d.rate_noise);
  }
  return out;
}

}  // namespace traj
