#include "traj/submit/submitted_flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/collision/collision.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/submit/operation.h"

namespace traj {
namespace {

constexpr double kLevel = 1;  // m, by which homes may differ from the ground of the map

}  // namespace

SubmittedFlight::SubmittedFlight(const geom::CollisionScene& scene, const SubmissionMethod& method)
    : scene_(scene), method_(method) {}

std::string SubmittedFlight::refusal() const {
  if (!accepted(report_)) return "its check refuses it";
  if (const auto why = why_no_times()) return *why;
  if (const auto why = why_not_of_vehicle()) return *why;
  if (!speed()) return "no limit on its speed is proved, which its volumes need: give --vmax";
  if (const auto& energy = method_.energy; energy && duration() > flying_time(*energy)) {
    return fmt::format(
        "it takes {:.1f} s, and the battery lasts {:.1f} s until only its reserve "
        "is left",
        duration(), flying_time(*energy));
  }
  if (method_.endurance && duration() > *method_.endurance) {
    return fmt::format("it takes {:.1f} s, and the operation says that the vehicle flies {:.1f} s",
                       duration(), *method_.endurance);
  }
  if (lowest() < method_.floor - kLevel) {
    return fmt::format(
        "it comes down to z = {:.2f}, lower than all ground below is said to be (z = {:g}): its "
        "ground risk buffers would be too narrow (--ground-level)",
        lowest(), method_.floor);
  }
  return "";
}

std::optional<std::string> SubmittedFlight::why_not_of_vehicle() const {
  const double dimension = method_.risk.dimension;
  auto why = why_dimension_wrong(dimension, scene_.vehicle());
  const auto named = vehicle_named(aircraft_);
  if (why || !named) return why;
  return why_dimension_wrong(dimension, named->vehicle, named->body);
}

std::optional<double> SubmittedFlight::speed() const {
  const std::vector<Limit> open = not_measured(report_.result, report_.limits);
  const auto kept = [&](Limit limit) -> std::optional<double> {
    if (std::find(open.begin(), open.end(), limit) != open.end()) return std::nullopt;
    return report_.limits[limit];
  };
  const auto across = kept(Limit::horizontal_speed);
  const auto vertical = kept(Limit::vertical_speed);
  std::optional<double> out = kept(Limit::speed);
  if (!across || !vertical) return out;
  const double both = std::sqrt(*across * *across + *vertical * *vertical) * (1 + 1e-15);
  return out ? std::min(*out, both) : both;
}

RiskTask SubmittedFlight::risk_task() const {
  return {method_.risk, *speed(), method_.floor, method_.origin, ground_};
}

FlightClaims SubmittedFlight::claims(const geom::IntentVolumes& intent,
                                     const RiskVolumes& risk) const {
  FlightClaims out;
  out.id = report_.id;
  out.kind = kind();
  out.vehicle = scene_.vehicle().name;
  out.half = scene_.vehicle().half;
  out.margin = scene_.margin();
  out.begins = begins();
  out.ends = ends();
  out.duration = duration();
  if (report_.result.clearance) out.clearance = report_.result.clearance->value;
  if (report_.tube) out.tube = report_.tube->claim;
  out.terrain = report_.terrain;
  out.speed = *speed();
  out.contingency = contingency_size(method_.risk, out.speed);
  out.top = 0;
  for (const geom::Volume4d& volume : intent.nominal) {
    out.top = std::max(out.top, *volume.upper - method_.origin.height - method_.floor);
  }
  for (const RiskVolume& one : risk.buffers) out.buffer = std::max(out.buffer, one.across);
  if (return_) out.returns = prove_return(scene_, return_->stages, return_->task).share();
  if (method_.energy) out.energy = out.duration * method_.energy->power;
  return out;
}

std::string volumes_json(const geom::IntentVolumes& intent, std::optional<int> priority) {
  return geom::operational_intent_details(intent.nominal, priority, intent.off_nominal);
}

}  // namespace traj
