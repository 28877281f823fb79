
#include "geom/text/instant.h"
#include "traj/check/check_record.h"
#include "traj/curve/to_enu.h"
#include "traj/home/off_nominal.h"
#include "traj/mission/airspace/flight_volumes.h"
#include "traj/mission/formats/placement.h"
#include "traj/record/certificate_record.h"
#include "traj/record/check_in_tube.h"
#include "traj/submit/submitted_flight.h"

namespace traj {
namespace {

ReturnsOnEarth returns_on_earth(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                                const SubmissionMethod& method) {
  return {*record.time.epoch, *record.time.start, method.origin,
          scene.half() + Vec3::Constant(method.buffer), scene.map().spec().frame.axes};
}

}  // namespace

SubmittedTrajectory::SubmittedTrajectory(const geom::CollisionScene& scene,
                                         const TrajectoryRecord& record,
                                         const SubmissionMethod& method, const Flier& flier,
                                         std::string_view source, std::size_t line,
                                         const std::optional<SubmittedTubes>& tubes)
    : SubmittedFlight(scene, method), record_(record) {
  report_ = check_record(scene, record, {.asked = method.limits, .exact = true}, source, line);
  if (!accepted(report_)) return;
  if (tubes) {
    report_.tube = check_as_geography(tubes->scene, record.id, record.trajectory, tubes->tubes);
  }
  if (!accepted(report_)) return;
  enu_ = to_enu(scene.map().spec().frame.axes, record.trajectory);
  for (const Segment& s : enu_.segments) {
    require_near_origin({s.point.begin(), s.point.end()}, method.origin, record.id);
  }
  if (method.risk.contingency == ContingencyRule::stop) return;
  return_ = flight_return(scene, record.trajectory, flier, method.return_height);
}

std::optional<std::string> SubmittedTrajectory::why_no_times() const {
  if (record_.time.start && record_.time.epoch) return std::nullopt;
  return "a folder says when, and the record has no \"" +
         std::string(record_.time.epoch ? "start" : "epoch") +
         "\": give it to the query, or let skyway-fleet choose departures";
}

double SubmittedTrajectory::lowest() const {
  double low = enu_.segments.front().point.front().z();
  for (const Segment& one : enu_.segments) low = std::min(low, one.point.back().z());
  return low;
}

double SubmittedTrajectory::duration() const { return report_.result.duration; }

FlightOnEarth SubmittedTrajectory::on_earth() const {
  const Vec3 half =
      report_.tube ? geography_half(scene_.vehicle(), *report_.tube) : Vec3(scene_.half());
  const Vec3 room = geom::to_enu(scene_.map().spec().frame.axes, half).cwiseAbs() +
                    Vec3::Constant(method_.buffer);
  return {{&enu_, *record_.time.start, room}, *record_.time.epoch, method_.origin};
}

geom::IntentVolumes SubmittedTrajectory::intent() const {
  geom::IntentVolumes out;
  out.nominal = flight_volumes(on_earth(), method_.volumes, record_.id);
  if (return_) {
    out.off_nominal = off_nominal_volumes(*return_, returns_on_earth(scene_, record_, method_),
                                          method_.volumes, record_.id);
  }
  return out;
}

std::optional<std::string> SubmittedTrajectory::why_not_held(
    const geom::IntentVolumes& intent) const {
  if (auto why = traj::why_not_held(on_earth(), intent.nominal, record_.id)) return why;
  if (!return_) {
    if (intent.off_nominal.empty()) return std::nullopt;
    return "it has off-nominal volumes, and no returns were asked for";
  }
  return why_returns_not_held(*return_, returns_on_earth(scene_, record_, method_),
                              intent.off_nominal, record_.id);
}

std::string SubmittedTrajectory::begins() const {
  return *geom::instant_not_after(*record_.time.epoch, *record_.time.start);
}

std::string SubmittedTrajectory::ends() const {
  return *geom::instant_not_before(*record_.time.epoch, *record_.time.start + duration());
}

std::string SubmittedTrajectory::certificate() const {
  const geom::BoxMap& map = scene_.map();
  CertificateRecord record{report_.id,        report_.checked,    *report_.exact,
                           map.spec().bounds, report_.provenance, report_.limits,
                           report_.overridden};
  if (report_.by_time) {
    record.epoch = map.spec().epoch;
    record.start = report_.time.start;
  }
  return to_json_line(record);
}

}  // namespace traj
