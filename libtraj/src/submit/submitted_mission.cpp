#include <fmt/format.h>

#include <algorithm>

#include "geom/text/instant.h"
#include "traj/check/check_record.h"
#include "traj/home/off_nominal.h"
#include "traj/home/prism.h"
#include "traj/mission/airspace/volume_around.h"
#include "traj/mission/judge/judge.h"
#include "traj/submit/submitted_flight.h"

namespace traj {
namespace {

// Around all of a region, in east, north, up.
AirspacePrism prism_of(const std::vector<Vec3>& hull, const Vec3& room, geom::Axes axes) {
  std::vector<Vec2> plan;
  double low = hull.front().z();
  double high = low;
  for (const Vec3& p : hull) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
    for (const double x : {-room.x(), room.x()}) {
      for (const double y : {-room.y(), room.y()}) {
        plan.push_back(geom::to_enu(axes, Vec3(p.x() + x, p.y() + y, 0)).head<2>());
      }
    }
  }
  return {plan_hull(std::move(plan)), low - room.z(), high + room.z()};
}

void add(const AirspacePrism& other, AirspacePrism& to) {
  if (to.outline.empty()) {
    to = other;
    return;
  }
  to.outline.insert(to.outline.end(), other.outline.begin(), other.outline.end());
  to.outline = plan_hull(std::move(to.outline));
  to.low = std::min(to.low, other.low);
  to.high = std::max(to.high, other.high);
}

// Seconds until the last stage ends: an estimate.
double seconds_of(const std::vector<std::vector<FlightStage>>& stages) {
  double out = 0;
  for (const auto& list : stages) {
    for (const FlightStage& stage : list) out = std::max(out, stage.until);
  }
  return out;
}

}  // namespace

SubmittedMission::SubmittedMission(const geom::CollisionScene& scene, const FileFlight& file,
                                   const SubmissionMethod& method, const Flier& flier)
    : SubmittedFlight(scene, method) {
  report_ = check_record(scene, file, flier, {.asked = method.limits});
  aircraft_ = file.vehicle;
  const FlownMission* mission = mission_of(file.flown);
  is_mission_ = mission && mission->home && (!mission->drift.empty() || mission->speed);
  if (!is_mission_) return;
  mission_ = *mission;
  mission_.path_stray += file.flown.navigation;
  seconds_ = mission->least_seconds;
  if (mission->terrain) return;
  if (mission->drift.empty()) {  // of DJI: on its way, with turns that are swept
    seconds_ = std::max(seconds_, seconds_of({stages_of(*mission, *mission->speed)}));
    const bool height_known = method.return_height || mission->return_height;
    if (method.risk.contingency == ContingencyRule::ways_home && height_known) {
      return_ = dji_flight_return(scene, *mission, flier, {.height = method.return_height});
    }
    return;
  }
  const FlightReturn of = flight_return(*mission, flier, method.return_height);
  seconds_ = std::max(seconds_, seconds_of(of.stages));
  if (method.risk.contingency == ContingencyRule::ways_home) return_ = of;
}

std::optional<std::string> SubmittedMission::why_no_times() const {
  if (!is_mission_) {
    return "the file does not say where home is, how fast the vehicle flies, or for which "
           "autopilot: "
           "make a trajectory of it (skyway-import-trajectory)";
  }
  if (method_.risk.contingency == ContingencyRule::ways_home && mission_.terrain) {
    return "over terrain nobody knows how high a return begins: leave --contingency return out";
  }
  if (method_.risk.contingency == ContingencyRule::ways_home && !return_) {
    return "the height of the return is a setting of the aircraft: give it with --return-height, "
           "or "
           "leave --contingency return out";
  }
  if (mission_.returns) {
    return "it ends with a return whose way is not known: say how high it returns "
           "(--return-height)";
  }
  if (!mission_.endless.empty()) {
    return mission_.endless + ": nobody knows how long it takes, so it has no volumes";
  }
  if (method_.risk.contingency == ContingencyRule::ways_home && !mission_.returns_if_lost) {
    return "the aircraft does not return when its link is lost, by the file (of DJI: "
           "executeRCLostAction, exitOnRCLost) or by its parameters (NAV_RCL_ACT, NAV_DLL_ACT; "
           "FS_THR_ENABLE, FS_GCS_ENABLE): set it to return, or leave --contingency return out";
  }
  if (!mission_.rally.empty()) {
    return "it ends at home or at one of its rally points, and volumes are made for one end: leave "
           "the return at its end out, or its rally points";
  }
  if (!method_.begins || !method_.ends) {
    return "a mission has no times: say from when until when it is flown (--between)";
  }
  const double least = geom::seconds_between(*method_.begins, *method_.ends).least;
  if (least >= seconds_) return std::nullopt;
  return fmt::format("it takes about {:.0f} s, and --between leaves it {:.0f} s", seconds_, least);
}

double SubmittedMission::lowest() const {
  double low = mission_.home->z();
  for (const Vec3& place : mission_.path) low = std::min(low, place.z());
  return low;
}

std::vector<SubmittedMission::Region> SubmittedMission::regions() const {
  std::vector<Region> out;
  const Vec3 around = Vec3::Constant(method_.buffer) + mission_.path_stray;
  const Vec3 planned = scene_.half() + around;
  if (const auto way = whole_way(scene_, mission_)) {
    // Where the places of autopilots are known, these hold the bands of the legs, too.
    const bool bands = mission_.drift.empty();
    for (std::size_t i = 1; i < way->size(); ++i) {
      const Vec3 up(0, 0, bands ? band_of(mission_, i - 1) : 0);
      out.push_back({{(*way)[i - 1], (*way)[i]}, planned + up});
    }
  }
  for (const Sweep& sweep : mission_.sweeps) out.push_back({sweep.hull, planned});
  Vec3 most = planned;
  for (const Drift& drift : mission_.drift) {
    most = most.cwiseMax(planned + drift.around);
    for (const Sweep& sweep : drift.sweeps) out.push_back({sweep.hull, planned + drift.around});
  }
  // Where it comes to the ground on its way.
  for (const Vec3& place : mission_.touches) {
    out.push_back({{place, Vec3(place.x(), place.y(), mission_.home->z())}, most});
  }
  return out;
}

geom::IntentVolumes SubmittedMission::intent() const {
  const std::vector<Region> all = regions();
  std::vector<AirspacePrism> stretches(std::min(method_.volumes, all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    add(prism_of(all[i].hull, all[i].room, scene_.map().spec().frame.axes),
        stretches[i * stretches.size() / all.size()]);
  }
  geom::IntentVolumes out;
  const auto between = [&](geom::Volume4d volume) {
    volume.start = *method_.begins;
    volume.end = *method_.ends;
    return volume;
  };
  for (const AirspacePrism& prism : stretches) {
    out.nominal.push_back(between(volume_around(prism, method_.origin, report_.id)));
  }
  if (return_) {
    const ReturnsOnEarth over{*method_.begins, 0, method_.origin,
                              scene_.half() + Vec3::Constant(method_.buffer),
                              scene_.map().spec().frame.axes};
    out.off_nominal = off_nominal_volumes(*return_, over, method_.volumes, report_.id);
    for (geom::Volume4d& volume : out.off_nominal) {
      volume.start = *method_.begins;
      if (geom::seconds_between(*volume.end, *method_.ends).least > 0) volume.end = *method_.ends;
    }
  }
  return out;
}

std::optional<std::string> SubmittedMission::why_not_held(const geom::IntentVolumes& intent) const {
  const geom::Axes axes = scene_.map().spec().frame.axes;
  for (const geom::Volume4d& volume : intent.nominal) {
    if (volume.lower && volume.upper && volume.start == method_.begins &&
        volume.end == method_.ends) {
      continue;
    }
    return fmt::format("a volume is not there from {} to {}", *method_.begins, *method_.ends);
  }
  for (const Region& region : regions()) {
    const AirspacePrism prism = prism_of(region.hull, region.room, axes);
    const bool held = std::any_of(intent.nominal.begin(), intent.nominal.end(),
                                  [&](const geom::Volume4d& volume) {
                                    return holds_prism(volume, prism, method_.origin, report_.id);
                                  });
    if (!held) {
      return fmt::format("no volume holds the vehicle near [{:.3f}, {:.3f}, {:.3f}]",
                         region.hull.front().x(), region.hull.front().y(), region.hull.front().z());
    }
  }
  if (!return_) {
    if (intent.off_nominal.empty()) return std::nullopt;
    return "it has off-nominal volumes, and no returns were asked for";
  }
  const ReturnsOnEarth over{*method_.begins, 0, method_.origin,
                            scene_.half() + Vec3::Constant(method_.buffer), axes};
  return why_returns_not_held(*return_, over, intent.off_nominal, report_.id);
}

}  // namespace traj
