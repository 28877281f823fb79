#include "traj/tube/tube_certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "geom/text/json_line.h"
#include "traj/flight/monte_carlo.h"
#include "tube/prove_cell.h"

namespace traj {
namespace {

using geom::JsonLine;

double read(const std::string& text) {
  double out = 0;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

// Four digits, not below the value (> 0): certificates are long.
double rounded_up(double value) {
  const double near = read(fmt::format("{:.3e}", value));
  return near >= value ? near : read(fmt::format("{:.3e}", value * 1.001));
}

JsonLine object_of(const Quadrotor& q, ControlLaw law) {
  JsonLine line;
  line.add("mass", q.mass).add("inertia", q.inertia).add("arm", q.arm);
  line.add("torque_per_thrust", q.torque_per_thrust);
  line.add("motor_time_constant", q.motor_time_constant);
  line.add("motor_least", q.motor_least).add("motor_most", q.motor_most).add("drag", q.drag);
  if (law == ControlLaw::cascade) line.add("body_rate_max", q.body_rate_max);
  return line;
}

JsonLine object_of(const GeometricGains& k) {
  JsonLine line;
  line.add("position", k.position).add("velocity", k.velocity).add("attitude", k.attitude);
  line.add("rates", k.rates).add("lead", k.lead);
  return line;
}

JsonLine object_of(const PidGains& k) {
  JsonLine line;
  line.add("p", k.p).add("i", k.i).add("d", k.d);
  if (std::isfinite(k.clip)) line.add("clip", k.clip);
  return line;
}

JsonLine object_of(const FeedForward& k) {
  JsonLine line;
  line.add("velocity", k.velocity).add("acceleration", k.acceleration);
  return line.add("body_rates", k.body_rates);
}

JsonLine object_of(const Gains& k, ControlLaw law) {
  if (law == ControlLaw::geometric) return object_of(k.geometric);
  JsonLine line;
  line.add("position", object_of(k.position)).add("velocity", object_of(k.velocity));
  line.add("attitude", k.attitude).add("rates", object_of(k.rates));
  line.add("feed_forward", object_of(k.feed_forward)).add("tilt_max", k.tilt_max);
  return line;
}

}  // namespace

ProvedTube with_room(ProvedTube tube) {
  for (double& radius : tube.radius) radius = rounded_up(kCheckersRoom * radius);
  tube.largest =
      tube.radius.empty() ? 0 : *std::max_element(tube.radius.begin(), tube.radius.end());
  tube.tilt = rounded_up(kCheckersRoom * tube.tilt);
  for (ProvedCell& cell : tube.proofs) {
    for (SpanBounds& span : cell.spans) {
      for (double& bound : span.bounds) bound = rounded_up(bound);
    }
  }
  return tube;
}

std::string tube_certificate_line(const std::string& id, geom::Axes axes,
                                  const TubeConditions& proved_for, const ProvedTube& tube) {
  const FlightOptions& o = proved_for.options;
  const Disturbances& d = proved_for.disturbances;
  JsonLine line;
  line.add("type", "tube_certificate").add("id", id);
  line.add("frame", geom::name(axes));
  line.add("vehicle", object_of(o.quadrotor, o.law));
  line.add("controller", geom::word_of(kControlLawWords, o.law));
  line.add("gains", object_of(o.gains, o.law)).add("attitude_period_ms", o.periods.attitude);
  if (o.law == ControlLaw::cascade) line.add("position_period_ms", o.periods.position);
  line.add("hover", o.hover).add("settle", o.settle);
  line.add("wind", d.wind).add("wind_spread", d.wind_spread).add("gust_most", d.gust_most);
  line.add("gust_lag", d.gust_lag).add("mass_error", d.mass_error);
  line.add("drag_error", d.drag_error).add("motor_lag_error", d.motor_lag_error);
  line.add("inertia_error", d.inertia_error).add("gain_error", d.gain_error);
  line.add("start_error", d.start_error).add("start_speed", d.start_speed);
  line.add("place_noise", d.place_noise).add("velocity_noise", d.velocity_noise);
  line.add("attitude_noise", d.attitude_noise).add("rate_noise", d.rate_noise);
  line.add("period", kTubePeriod).add("tilt", tube.tilt).add("radius", tube.radius);
  line.add("cells", tube.proofs, [](const ProvedCell& cell) {
    std::vector<int> periods;
    std::vector<std::vector<double>> bounds;
    for (const SpanBounds& span : cell.spans) {
      periods.push_back(span.periods);
      bounds.push_back(span.bounds);
    }
    return JsonLine().add("part", cell.part).add("periods", periods).add("bounds", bounds);
  });
  return line.line();
}

}  // namespace traj
