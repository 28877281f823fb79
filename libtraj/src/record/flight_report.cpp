#include "traj/record/flight_report.h"

#include <algorithm>

#include "geom/base/percentile.h"
#include "geom/text/json_line.h"
#include "traj/flight/model_hash.h"
#include "traj/record/disturbance_record.h"

namespace traj {
namespace {

using geom::JsonLine;

// Where it is not clear.
void add_violation(JsonLine& line, const FlightPathCheck& check, const geom::BoxMap* map) {
  line.add("time", check.time).add("place", check.place);
  if (check.box && map) line.add("box", map->ids()[*check.box]);
}

void add_failure(JsonLine& line, const FlightReport& r, const geom::BoxMap* map) {
  line.add("reason", reason(r));
  if (r.status != TrajectoryStatus::solved) return;
  if (r.lost) {
    line.add("time", *r.lost);
  } else if (r.check && !r.check->clear) {
    add_violation(line, *r.check, map);
  }
}

void add_tracking(JsonLine& line, const Tracking& t) {
  line.add("final", t.final_distance).add("arrival", t.arrival).add("mean", t.mean);
  line.add("rms", t.rms).add("p99", t.p99).add("max", t.largest).add("max_time", t.largest_time);
  if (t.settling) {
    line.add("settling", *t.settling);
  } else {
    line.add("settling", nullptr);
  }
}

// Mean, 99th percentile and maximum over the runs of one of their figures.
JsonLine spread(std::span<const Tracking> runs, double Tracking::*figure) {
  std::vector<double> values;
  double sum = 0;
  for (const Tracking& t : runs) values.push_back(t.*figure), sum += t.*figure;
  return JsonLine()
      .add("mean", sum / static_cast<double>(values.size()))
      .add("p99", geom::percentile(values, 0.99))
      .add("max", *std::max_element(values.begin(), values.end()));
}

JsonLine tube(const FlightReport& r, const geom::BoxMap* map) {
  const std::vector<double>& radius = r.tube.radius;
  JsonLine line;
  line.add("share", tube_share(r.tube.tracking.size())).add("period", kTubePeriod);
  line.add("largest", *std::max_element(radius.begin(), radius.end()));
  line.add("tilt", r.tube.tilt).add("model", model_hash(r.options));
  if (r.tube_check) {
    line.add("clear", r.tube_check->clear);
    if (!r.tube_check->clear) add_violation(line, *r.tube_check, map);
  }
  return line.add("trajectory", r.trajectory).add("radius", radius);
}

JsonLine runs(const FlightReport& r, const geom::BoxMap* map) {
  JsonLine line;
  line.add("says", "statistics, not proof").add("runs", r.spread->runs);
  line.add("mass_error", r.spread->mass_error).add("lost", r.tube.lost);
  if (!r.tube.lost) {
    line.add("error_mean", spread(r.tube.tracking, &Tracking::mean));
    line.add("error_max", spread(r.tube.tracking, &Tracking::largest));
    line.add("final", spread(r.tube.tracking, &Tracking::final_distance));
    line.add("saturated", r.tube.saturated).add("tube", tube(r, map));
  }
  return line;
}

// What the proof of a tube allows, and what it came to.
JsonLine proved(const FlightReport& r, const geom::BoxMap* map) {
  JsonLine line;
  line.add("ok", !r.proved.trouble);
  add(line, *r.disturbances);
  line.add("model", model_hash(r.options));
  line.add("damping", r.proved.damping).add("cells", r.proved.cells);
  if (const auto& trouble = r.proved.trouble) {
    line.add("reason", geom::word_of(kTubeTroubleWords, trouble->kind)).add("time", trouble->time);
    if (trouble->motor) line.add("motor", trouble->motor);
    if (trouble->motor || trouble->room < 0) line.add("room", trouble->room);
    return line;
  }
  line.add("period", kTubePeriod).add("largest", r.proved.largest).add("tilt", r.proved.tilt);
  if (r.proved_check) {
    line.add("clear", r.proved_check->clear);
    if (!r.proved_check->clear) add_violation(line, *r.proved_check, map);
  }
  line.add("says", "proved for the simulated vehicle, in these ranges");
  return line.add("trajectory", r.trajectory).add("radius", r.proved.radius);
}

void add_energy(JsonLine& line, const FlightReport& r, const Airframe& airframe) {
  line.add("hover_seconds", r.hover_seconds);
  if (!airframe.endurance) return;
  const double share = r.hover_seconds / *airframe.endurance;
  line.add("battery_share", share);
  if (airframe.battery) line.add("energy_wh", share * *airframe.battery);
}

void add_conditions(JsonLine& line, const FlightOptions& o) {
  line.add("controller", geom::word_of(kControlLawWords, o.law));
  line.add("wind", o.wind.mean).add("gusts", o.wind.gusts);
  line.add("mass_error", o.mass_error).add("seed", o.seed);
}

// Of a trajectory that could be flown.
void add_flight(JsonLine& line, const FlightReport& r, const Airframe& airframe,
                const geom::BoxMap* map) {
  line.add("duration", r.duration);
  if (r.tracking) {
    add_tracking(line, *r.tracking);
    line.add("saturated", r.saturated).add("tilt", r.tilt);
    add_energy(line, r, airframe);
  }
  if (r.check) line.add("clear", r.check->clear).add("between_steps", r.check->between);
  add_conditions(line, r.options);
  if (r.spread) line.add("monte_carlo", runs(r, map));
  if (r.disturbances) line.add("proved_tube", proved(r, map));
}

}  // namespace

bool accepted(const FlightReport& r) {
  return r.status == TrajectoryStatus::solved && !r.lost && (!r.check || r.check->clear) &&
         r.tube.lost == 0 && (!r.tube_check || r.tube_check->clear) && !r.proved.trouble &&
         (!r.proved_check || r.proved_check->clear);
}

std::string_view reason(const FlightReport& r) {
  if (r.status != TrajectoryStatus::solved) return name(r.status);
  if (r.lost) return "lost";
  if (r.check && !r.check->clear) return name(r.check->reason);
  if (r.tube.lost) return "lost_runs";
  return r.proved.trouble ? "no_proof" : "tube";
}

std::string to_json_line(const FlightReport& r, const Airframe& airframe, const geom::BoxMap* map) {
  JsonLine line;
  const bool ok = accepted(r);
  line.add("type", "flight").add("id", r.id).add("ok", ok);
  if (!ok) add_failure(line, r, map);
  if (r.status == TrajectoryStatus::solved) add_flight(line, r, airframe, map);
  add(line, r.provenance);
  add(line, r.time);
  return line.line();
}

}  // namespace traj
