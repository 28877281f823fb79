#include "flown_return.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "geom/shape/hull.h"
#include "geom/text/text_table.h"
#include "traj/mission/formats/flier.h"

namespace firmware {
namespace {

// Smaller than `finest` metres, and near enough to the place.
void add_parts(const traj::FlightStage& stage, const geom::Aabb& place, double finest,
               std::vector<traj::FlightStage>& out) {
  if (!geom::hull_meets(stage.where, place)) return;
  const auto parts = traj::extent(stage) > finest ? traj::halves(stage) : std::nullopt;
  if (!parts) return out.push_back(stage);
  add_parts(parts->first, place, finest, out);
  add_parts(parts->second, place, finest, out);
}

std::vector<traj::ReturnPlace> places_of(const traj::ReturnTask& task) {
  std::vector<traj::ReturnPlace> out;
  for (const Vec3& rally : task.rally) {
    out.push_back({{rally.x(), rally.y(), task.home.z()}, rally.z() - task.home.z()});
  }
  out.push_back({task.home, 0});
  return out;
}

void append(const std::vector<traj::ReturnSweep>& more, std::vector<traj::ReturnSweep>& out) {
  out.insert(out.end(), more.begin(), more.end());
}

Vec3 place_at(const std::vector<Sample>& samples, double time) {
  const auto next = std::find_if(samples.begin(), samples.end(),
                                 [&](const Sample& one) { return one.time >= time; });
  if (next == samples.end()) throw std::runtime_error("the track ends before the order");
  if (next == samples.begin()) return next->place;
  const Sample& last = *std::prev(next);
  const double share = (time - last.time) / (next->time - last.time);
  return last.place + share * (next->place - last.place);
}

}  // namespace

std::vector<FlownReturn> read_returns(const std::string& table) {
  std::ifstream in(table);
  if (!in) throw std::runtime_error("no table " + table);
  const std::filesystem::path folder = std::filesystem::path(table).parent_path();
  std::vector<FlownReturn> out;
  geom::TextLines lines(in, table);
  for (lines.next(); lines.next();) {
    const std::vector<std::string> f = geom::split_fields(lines.line());
    if (f.size() != 7) lines.refuse({.expected = "7 fields"});
    FlownReturn one;
    one.flight.name = std::filesystem::path(f[0]).stem().string();
    one.flight.track = (folder / f[0]).string();
    one.flight.mission = (folder / f[1]).string();
    one.flight.autopilot = f[2];
    one.flight.drag = geom::parse_number(f[6]);
    one.action = geom::value_of(traj::kReturnActionWords, f[3]).value();
    one.ordered = geom::parse_number(f[4]).value();
    one.autopilot = autopilot_of(f[2], f[5], one.flight.drag, table);
    out.push_back(std::move(one));
  }
  return out;
}

ReturnClaim claim_of(const FlownReturn& flown) {
  traj::Flier flier;
  flier.autopilots = {flown.autopilot};
  flier.exactly = flown.autopilot;
  ReturnClaim out;
  out.replay = replay(flown.flight, flier.rules({}));
  const traj::FlownMavlink& mission = out.replay.mission;
  for (const traj::Drift& drift : mission.drift) {
    for (traj::FlightStage& stage : traj::stages_of(drift)) out.stages.push_back(std::move(stage));
  }
  traj::ReturnModel model = traj::return_model(flown.autopilot);
  model.around += mission.path_stray;
  out.task.action = flown.action;
  out.task.models = {model};
  out.task.home = mission.home.value();
  out.task.rally = mission.rally_points;
  out.ordered_at = place_at(out.replay.samples, flown.ordered);
  return out;
}

std::vector<traj::FlightStage> stages_there(const ReturnClaim& claim) {
  const Vec3& off = claim.task.models.front().around;
  const geom::Aabb place{claim.ordered_at - off, claim.ordered_at + off};
  std::vector<traj::FlightStage> out;
  for (const traj::FlightStage& stage : claim.stages) {
    add_parts(stage, place, claim.task.finest, out);
  }
  return out;
}

std::vector<traj::ReturnSweep> ways_of(const FlownReturn& flown, const ReturnClaim& claim,
                                       const std::vector<traj::FlightStage>& stages) {
  const traj::ReturnModel& model = claim.task.models.front();
  const double ground = claim.task.home.z();
  const std::vector<traj::ReturnPlace> places = places_of(claim.task);
  std::vector<traj::ReturnSweep> out;
  for (const traj::FlightStage& stage : stages) {
    switch (flown.action) {
      case traj::ReturnAction::hold:
        append(traj::holding_sweeps(model, stage), out);
        break;
      case traj::ReturnAction::land:
        append(traj::landing_sweeps(model, stage, ground, ground), out);
        break;
      case traj::ReturnAction::rtl:
        for (const std::size_t i : traj::likely_places(model, stage, places)) {
          append(traj::return_sweeps(model, stage, places[i]), out);
        }
    }
  }
  return out;
}

std::vector<Sample> samples_after(const FlownReturn& flown, const ReturnClaim& claim) {
  std::vector<Sample> out;
  for (const Sample& one : claim.replay.samples) {
    if (one.time >= flown.ordered) out.push_back(one);
  }
  return out;
}

Exit exit_of(const ReturnClaim& claim, const std::vector<traj::ReturnSweep>& ways,
             const Vec3& place, double most) {
  const Vec3& off = claim.task.models.front().around;
  Exit best{most, traj::ReturnPhase::braking};
  for (const traj::ReturnSweep& way : ways) {
    const auto meets = [&](double more) {
      const Vec3 box = off + Vec3::Constant(more);
      return traj::meets(way.region, {place - box, place + box});
    };
    if (meets(0)) return {0, way.phase};
    if (!meets(best.outside)) continue;
    double near = 0;
    double far = best.outside;
    for (int i = 0; i < 20; ++i) {
      const double middle = (near + far) / 2;
      (meets(middle) ? far : near) = middle;
    }
    best = {far, way.phase};
  }
  return best;
}

}  // namespace firmware
