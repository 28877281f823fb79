#include "traj/record/flight_report.h"

#include <algorithm>

#include "json_number.h"

namespace traj {
namespace {

void append_text(std::string& out, std::string_view key, std::string_view value) {
  out += ",\"";
  out += key;
  out += "\":";
  geom::append_json(out, value);
}

// `"reason":…` and where, of what is not clear.
void append_violation(std::string& out, const FlightPathCheck& check, const geom::BoxMap* map) {
  append_text(out, "reason", name(check.reason));
  append_number(out, "time", check.time);
  out += ",\"place\":";
  geom::append_json(out, check.place);
  if (check.box && map) out += ",\"box\":" + std::to_string(map->ids()[*check.box]);
}

void append_failure(std::string& out, const FlightReport& r, const geom::BoxMap* map) {
  if (r.status != TrajectoryStatus::solved) return append_text(out, "reason", name(r.status));
  if (r.lost) {
    append_text(out, "reason", "lost");
    return append_number(out, "time", *r.lost);
  }
  if (r.check && !r.check->clear) return append_violation(out, *r.check, map);
  append_text(out, "reason", r.tube.lost ? "lost_runs" : "tube");
}

void append_tracking(std::string& out, const Tracking& t) {
  append_number(out, "final", t.final_distance);
  append_number(out, "arrival", t.arrival);
  append_number(out, "mean", t.mean);
  append_number(out, "rms", t.rms);
  append_number(out, "p99", t.p99);
  append_number(out, "max", t.largest);
  append_number(out, "max_time", t.largest_time);
  out += ",\"settling\":";
  if (t.settling) {
    geom::append_json(out, *t.settling);
  } else {
    out += "null";
  }
}

// Mean, 99th percentile and maximum over the runs of one of their figures.
void append_spread(std::string& out, std::string_view key, std::span<const Tracking> runs,
                   double Tracking::*figure) {
  std::vector<double> values;
  double sum = 0;
  for (const Tracking& t : runs) values.push_back(t.*figure), sum += t.*figure;
  out += ",\"";
  out += key;
  out += "\":{\"mean\":";
  geom::append_json(out, sum / static_cast<double>(values.size()));
  append_number(out, "p99", percentile(values, 0.99));
  append_number(out, "max", *std::max_element(values.begin(), values.end()));
  out += '}';
}

void append_tube(std::string& out, const FlightReport& r, const geom::BoxMap* map) {
  const std::vector<double>& radius = r.tube.radius;
  out += ",\"tube\":{\"share\":";
  geom::append_json(out, kTubeShare);
  append_number(out, "period", kTubePeriod);
  append_number(out, "largest", *std::max_element(radius.begin(), radius.end()));
  if (r.tube_check) {
    out += r.tube_check->clear ? ",\"clear\":true" : ",\"clear\":false";
    if (!r.tube_check->clear) append_violation(out, *r.tube_check, map);
  }
  for (std::size_t i = 0; i < radius.size(); ++i) {
    out += i ? "," : ",\"radius\":[";
    geom::append_json(out, radius[i]);
  }
  out += "]}";
}

void append_runs(std::string& out, const FlightReport& r, const geom::BoxMap* map) {
  out += ",\"monte_carlo\":{\"says\":\"statistics, not proof\",\"runs\":" +
         std::to_string(r.spread->runs);
  append_number(out, "mass_error", r.spread->mass_error);
  out += ",\"lost\":" + std::to_string(r.tube.lost);
  if (!r.tube.lost) {
    append_spread(out, "error_mean", r.tube.tracking, &Tracking::mean);
    append_spread(out, "error_max", r.tube.tracking, &Tracking::largest);
    append_spread(out, "final", r.tube.tracking, &Tracking::final_distance);
    append_number(out, "saturated", r.tube.saturated);
    append_tube(out, r, map);
  }
  out += '}';
}

void append_energy(std::string& out, const FlightReport& r, const Airframe& airframe) {
  append_number(out, "hover_seconds", r.hover_seconds);
  if (!airframe.endurance) return;
  const double share = r.hover_seconds / *airframe.endurance;
  append_number(out, "battery_share", share);
  if (airframe.battery) append_number(out, "energy_wh", share * *airframe.battery);
}

void append_conditions(std::string& out, const FlightOptions& o) {
  append_text(out, "controller", o.law == ControlLaw::cascade ? "cascade" : "geometric");
  out += ",\"wind\":";
  geom::append_json(out, o.wind.mean);
  append_number(out, "gusts", o.wind.gusts);
  append_number(out, "mass_error", o.mass_error);
  out += ",\"seed\":" + std::to_string(o.seed);
}

}  // namespace

bool accepted(const FlightReport& r) {
  return r.status == TrajectoryStatus::solved && !r.lost && (!r.check || r.check->clear) &&
         r.tube.lost == 0 && (!r.tube_check || r.tube_check->clear);
}

std::string to_json_line(const FlightReport& r, const Airframe& airframe, const geom::BoxMap* map) {
  std::string out = "{\"type\":\"flight\",\"id\":";
  geom::append_json(out, std::string_view(r.id));
  const bool ok = accepted(r);
  out += ok ? ",\"ok\":true" : ",\"ok\":false";
  if (!ok) append_failure(out, r, map);
  if (r.status == TrajectoryStatus::solved) {
    append_number(out, "duration", r.duration);
    if (r.tracking) {
      append_tracking(out, *r.tracking);
      append_number(out, "saturated", r.saturated);
      append_number(out, "tilt", r.tilt);
      append_energy(out, r, airframe);
    }
    if (r.check) {
      out += r.check->clear ? ",\"clear\":true" : ",\"clear\":false";
      append_number(out, "between_steps", r.check->between);
    }
    append_conditions(out, r.options);
    if (r.spread) append_runs(out, r, map);
  }
  std::string origin;
  geom::append_json(origin, r.provenance);
  if (!origin.empty()) origin.pop_back();  // its last comma
  if (!origin.empty()) out += ',' + origin;
  return out + "}\n";
}

}  // namespace traj
