#include "traj/home/return_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/base/usage_error.h"
#include "geom/text/counted.h"
#include "geom/text/rounded.h"
#include "traj/curve/to_enu.h"
#include "traj/curve/vertical_ends.h"
#include "traj/home/fence_plan.h"
#include "traj/home/flight_return.h"
#include "traj/home/off_nominal.h"
#include "traj/home/procedure.h"
#include "traj/home/return_parameters.h"
#include "traj/mission/firmware/autopilot_settings.h"
#include "traj/mission/formats/fence_file.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/judge/judge.h"
#include "traj/mission/judge/regions.h"
#include "traj/mission/read_mission.h"
#include "traj/record/verdict.h"

namespace traj {
namespace {

constexpr double kLevel = 1;  // m: ground that is as high as home's
// m that fences may need between a return and an obstacle
constexpr double kFenced[] = {0.012, 0.018, 0.024, 0.03};
constexpr const char* kWritten = "what was written";

MissionExport refused(std::string why) { return {{}, std::move(why), {}, {}}; }

// A mission with its return.
class ReturnExport {
 public:
  ReturnExport(const geom::CollisionScene& scene, const ExportFlight& flight,
               const MissionFormat& format, const ExportOptions& options,
               const ReturnWishes& wishes)
      : scene_(scene), flight_(flight), format_(format), options_(options), wishes_(wishes) {
    options_.rally = wishes.rally;
    options_.fences = wishes.fences;
    for (Autopilot& one : options_.flier.autopilots) {
      if (wishes.height) one.return_height = height_as_set(one, *wishes.height);
    }
    if (wishes.height) options_.flier.returns_at.reset();  // --params-out sets it
    if (options_.flier.exactly) options_.flier.exactly = options_.flier.autopilots.front();
    budget_ = wishes.budget.value_or(fence_budget(options_.flier.autopilots));
  }

  MissionExport make() {
    if (auto why = why_too_many()) return refused(*why);
    MissionExport made = export_mission(scene_, flight_, format_, options_);
    if (!made.written) return made;
    FlownMission mission = read_back(*made.written);
    FlightReturn of = flight_return(mission, options_.flier, {});
    if (auto why = why_unfit(mission, of)) return refused(*why);
    std::vector<std::string> warnings;
    if (wishes_.compiles_fences) {
      auto compiled = best_fences(mission, of);
      if (!compiled.missing.empty()) return refused(no_fences(compiled));
      warn_of_open(compiled, warnings);
      options_.fences = std::move(compiled.fences);
      made = export_mission(scene_, flight_, format_, options_);
      if (!made.written) return made;
      mission = read_back(*made.written);
      of = flight_return(mission, options_.flier, {});
    }
    const ReturnReport proof = prove_return(scene_, of.stages, of.task);
    warn_of_gaps(proof, warnings);
    warn_of_height(of.task, warnings);
    add_texts(mission, of, proof, *made.written);
    made.warnings.insert(made.warnings.end(), warnings.begin(), warnings.end());
    return made;
  }

 private:
  std::optional<std::string> why_too_many() const {
    const std::size_t corners = corners_of(options_.fences);
    if (corners <= budget_) return std::nullopt;
    return fmt::format("its fences have {}, and {} is what the autopilot stores (--fence-budget)",
                       geom::counted(corners, "corner", "corners"), budget_);
  }

  // In the map's axes, with the fences of a file of their own.
  FlownMission read_back(const WrittenMission& written) const {
    const geom::Frame& frame = scene_.map().spec().frame;
    MissionReading reading = written.reading;
    reading.flier = options_.flier;
    auto read = read_mission(written.text, kWritten, format_, reading, frame);
    FlownMission mission = std::get<FlownMission>(std::move(read.front().flown.way));
    add_files(written, reading.placement.mission_frame(frame), mission);
    return mission;
  }

  void add_files(const WrittenMission& written, const MissionFrame& over,
                 FlownMission& mission) const {
    const geom::Axes axes = scene_.map().spec().frame.axes;
    if (!written.fences.empty()) {
      geom::TextInput in(written.fences);
      for (const GeodeticFence& one : read_fences(in, kWritten)) {
        Fence fence = fence_on_map(one, over.origin, kWritten);
        for (geom::Vec2& p : fence.ring) {
          p = geom::to_enu(axes, Vec3(p.x(), p.y(), 0)).head<2>();
        }
        mission.fences.push_back(std::move(fence));
      }
    }
    if (written.rally.empty()) return;
    geom::TextInput in(written.rally);
    const geom::GeographicFrame earth(over.origin);
    for (const geom::GeodeticPlace& one : read_wpl_rally(in, kWritten)) {
      Vec3 place = earth.enu({one.latitude, one.longitude, 0});
      place.z() = mission.home->z() + one.height;
      mission.rally_points.push_back(geom::to_enu(axes, place));
    }
  }

  // --- what is refused ------------------------------------------------------------------------

  std::optional<std::string> why_unfit(const FlownMission& mission, const FlightReturn& of) const {
    const double ceiling = scene_.map().spec().bounds.max.z();
    for (const ReturnModel& model : of.task.models) {
      const double beside = scene_.vehicle().half.z() +
                            std::max(scene_.margin(), model.around.z() + of.task.room.z());
      double from = of.task.home.z();
      for (const Vec3& rally : of.task.rally) {
        if (model.rally_adds) from = std::max(from, rally.z());
      }
      const double top = from + model.height + beside;
      if (top <= ceiling) continue;
      return fmt::format(
          "the return of {} at {:g} m above home reaches z = {:.4g}, above the map's ceiling at "
          "{:.4g}: return lower (--return-height), or give the map a higher ceiling (skyway-map "
          "crop --ceiling)",
          model.autopilot, model.height, top, ceiling);
    }
    for (std::size_t i = 0; i < of.task.rally.size(); ++i) {
      const std::string why = why_no_rally(of.task.rally[i], mission, of.task);
      if (!why.empty()) return fmt::format("rally point {} {}", i + 1, why);
    }
    return std::nullopt;
  }

  // Empty: the vehicle may come down there.
  std::string why_no_rally(const Vec3& place, const FlownMission& mission,
                           const ReturnTask& task) const {
    if (!scene_.inside_bounds(place)) return "is outside of the map's bounds";
    for (const std::size_t box : scene_.blockers(place, place)) {
      return fmt::format("is inside of obstacle {}", scene_.map().ids()[box]);
    }
    Vec3 beside = mission.path_stray;
    for (const ReturnModel& model : task.models) beside = beside.cwiseMax(model.around);
    const LandingGround ground = landing_ground(scene_, place, beside + task.room, kLevel);
    if (!ground.whole || std::abs(ground.height - task.home.z()) > kLevel) {
      return "has no level ground as high as home's below it, where the vehicle would land";
    }
    const Vec3 foot(place.x(), place.y(), ground.height);
    CheckResult result;
    check_fences(scene_, {{Sweep{{place, foot}, {}}}}, mission.fences, beside + task.room, result);
    return result.reason == Reason::none ? "" : "is outside of a fence, or too near to it";
  }

  static std::string no_fences(const CompiledFences& compiled) {
    return fmt::format(
        "no fences hold the mission and its returns and keep out of the tall obstacles: {}: give a "
        "larger --fence-budget if the autopilot has room, or fences of your own (--fence FILE)",
        compiled.missing);
  }

  // --- fences ---------------------------------------------------------------------------------

  // Fences that hold every proved return. If an obstacle is so near to one that no fence fits
  // between them, those that keep out of more obstacles and leave as few returns out as they can.
  CompiledFences best_fences(const FlownMission& mission, const FlightReturn& of) const {
    CompiledFences best = compile(mission, of, 0);
    for (const double spare : kFenced) {
      if (best.missing.empty() && best.open.empty()) break;
      CompiledFences next = compile(mission, of, spare);
      const bool better = !best.missing.empty() || next.open.size() < best.open.size();
      if (next.missing.empty() && better) best = std::move(next);
    }
    return best;
  }

  // `spare`: m that returns leave to obstacles for a fence; others are left out.
  CompiledFences compile(const FlownMission& mission, const FlightReturn& of, double spare) const {
    FenceTask task;
    task.budget = budget_;
    task.origin = mission_frame().origin;
    add_mission(mission, of.task, task);
    // Nearer to its place a return may be lower, in a cone, and is proved there.
    task.low = std::numeric_limits<double>::infinity();
    for (const ReturnModel& model : of.task.models) {
      task.low = std::min(task.low, of.task.home.z() + model.height - model.under);
      task.high = std::max(task.high, of.task.home.z() + model.height);
    }
    add_returns(of, spare, task);
    add_rally(of.task, task);
    return compile_fences(scene_, task);
  }

  // Its way with the margin, and where autopilots may be without it: as judge() holds them.
  void add_mission(const FlownMission& mission, const ReturnTask& asked, FenceTask& task) const {
    const geom::Vec2 planned = (scene_.half() + mission.path_stray).head<2>();
    if (const auto way = whole_way(scene_, mission)) {
      for (std::size_t i = 1; i < way->size(); ++i) {
        task.regions.push_back({{(*way)[i - 1], (*way)[i]}, planned});
      }
    }
    for (const Sweep& sweep : mission.sweeps) task.regions.push_back({sweep.hull, planned});
    for (const Drift& drift : mission.drift) {
      const Vec3 room = scene_.vehicle().half + asked.room + drift.around + mission.path_stray;
      for (const Sweep& sweep : drift.sweeps) {
        task.regions.push_back({sweep.hull, room.head<2>()});
      }
    }
  }

  void add_returns(const FlightReturn& of, double metres, FenceTask& task) const {
    ReturnTask wider = of.task;
    const geom::Vec2 spare(metres, metres);
    const Vec3 margin = scene_.half() - scene_.vehicle().half - of.task.room;
    for (ReturnModel& model : wider.models) {
      if (metres > 0) model.around.head<2>() = model.around.cwiseMax(margin).head<2>() + spare;
    }
    for (const ProvedReturn& one : proved_returns(scene_, of.stages, wider)) {
      const Prism& region = one.sweep.region;
      task.regions.push_back({corners(region), (scene_.half() + one.beside).head<2>() - spare});
      task.high = std::max(task.high, region.high);
    }
  }

  void add_rally(const ReturnTask& asked, FenceTask& task) const {
    for (const Vec3& place : asked.rally) {
      task.regions.push_back({{place}, (scene_.half() + asked.room).head<2>()});
    }
  }

  MissionFrame mission_frame() const {
    return options_.placement.mission_frame(scene_.map().spec().frame);
  }

  void warn_of_open(const CompiledFences& compiled, std::vector<std::string>& warnings) const {
    if (compiled.open.empty()) return;
    warnings.push_back(fmt::format(
        "{}: its fences do not keep out of {} that reach the heights of its returns, because it or "
        "a proved return passes above, below or within 2 cm of them (the first is {})",
        flight_.id, geom::counted(compiled.open.size(), "obstacle", "obstacles"),
        scene_.map().ids()[compiled.open.front()]));
  }

  // --- what is said ---------------------------------------------------------------------------

  void warn_of_gaps(const ReturnReport& proof, std::vector<std::string>& warnings) const {
    if (proof.gaps.empty()) return;
    const std::size_t more = proof.gaps.size() - 1;
    warnings.push_back(fmt::format(
        "{}: its return is proved for {:.4g} % of the time: {}{}", flight_.id,
        geom::rounded_down(100 * proof.share()), in_words(proof.gaps.front(), scene_.map()),
        more == 0 ? "" : fmt::format(", and {} more", geom::counted(more, "time", "times"))));
  }

  // No plan holds it.
  void warn_of_height(const ReturnTask& task, std::vector<std::string>& warnings) const {
    if (!wishes_.height && !wishes_.params) return;
    for (std::size_t i = 0; i < task.models.size(); ++i) {
      const Autopilot& pilot = options_.flier.autopilots[i];
      warnings.push_back(fmt::format(
          "the height of the return is no part of a {} file: set {} to {:g} m above home in the "
          "vehicle{}",
          format_.format.word, pilot.firmware == Firmware::px4 ? "RTL_RETURN_ALT" : "RTL_ALT",
          task.models[i].height,
          wishes_.params ? ", or load the parameters that are written beside it"
                         : " (--params-out writes a file for that)"));
    }
  }

  void add_texts(const FlownMission& mission, const FlightReturn& of, const ReturnReport& proof,
                 WrittenMission& written) const {
    if (wishes_.params) written.params = parameters();
    if (!wishes_.procedure) return;
    written.procedure = lost_link_procedure(scene_, {flight_.id, mission, of, proof, options_.flier,
                                                     options_.fences, mission_frame().origin});
  }

  // Read back: the autopilot returns at that height.
  std::string parameters() const {
    const std::vector<Autopilot>& pilots = options_.flier.autopilots;
    if (pilots.size() != 1) {
      throw geom::UsageError(
          fmt::format("parameters are those of one firmware, and {} may fly: say which with "
                      "--autopilot",
                      names_of(pilots)));
    }
    const Autopilot& pilot = pilots.front();
    std::string text = return_parameters(pilot, {.fenced = !options_.fences.empty()});
    geom::TextInput in(text);
    const AutopilotSettings settings = read_autopilot_settings(in, kWritten);
    const Autopilot read = set_autopilot(settings, pilots, kWritten).autopilot;
    const bool same = std::abs(read.return_height - pilot.return_height) < 1e-9 &&
                      std::abs(read.return_climb - pilot.return_climb) < 1e-9 &&
                      read.return_slope >= pilot.return_slope - 1e-9 && read.returns_home;
    if (!same) throw geom::InputError(kWritten, {.expected = "the return that was proved"});
    return text;
  }

  const geom::CollisionScene& scene_;
  const ExportFlight& flight_;
  const MissionFormat& format_;
  ExportOptions options_;
  const ReturnWishes& wishes_;
  std::size_t budget_ = 0;
};

// Volumes of airspace: the off-nominal ones after the others, which stay as they are.
MissionExport with_off_nominal(const geom::CollisionScene& scene, const ExportFlight& flight,
                               const ExportOptions& options, const ReturnWishes& wishes,
                               MissionExport made) {
  geom::TextInput in(made.written->text);
  const geom::IntentVolumes nominal = geom::read_intent_volumes(in, kWritten);
  const geom::Frame& frame = scene.map().spec().frame;
  const FlightReturn of = flight_return(scene, flight.trajectory, options.flier, wishes.height);
  const ReturnsOnEarth over{*flight.time.epoch, *flight.time.start,
                            options.placement.mission_frame(frame).origin,
                            scene.half() + Vec3::Constant(options.buffer), frame.axes};
  const auto volumes = off_nominal_volumes(of, over, wishes.off_nominal, flight.id);
  made.written->text =
      geom::operational_intent_details(nominal.nominal, flight.time.priority, volumes);
  geom::TextInput again(made.written->text);
  const geom::IntentVolumes read = geom::read_intent_volumes(again, kWritten);
  if (const auto why = why_returns_not_held(of, over, read.off_nominal, kWritten)) {
    return refused(*why);
  }
  const ReturnReport proof = prove_return(scene, of.stages, of.task);
  if (proof.gaps.empty()) return made;
  made.warnings.push_back(fmt::format(
      "{}: its off-nominal volumes hold all returns, but these are proved clear for {:.4g} % of "
      "the time: {}",
      flight.id, geom::rounded_down(100 * proof.share()),
      in_words(proof.gaps.front(), scene.map())));
  return made;
}

}  // namespace

bool ReturnWishes::any() const {
  return height || !rally.empty() || !fences.empty() || compiles_fences || budget || params ||
         procedure || off_nominal > 0;
}

MissionExport export_with_return(const geom::CollisionScene& scene, const ExportFlight& flight,
                                 const MissionFormat& format, const ExportOptions& options,
                                 const ReturnWishes& wishes) {
  if (&format == &kWpl || &format == &kQgcPlan) {
    return ReturnExport(scene, flight, format, options, wishes).make();
  }
  if (&format != &kVolume4d) {
    throw geom::UsageError(fmt::format("a {} file holds no return", format.format.word));
  }
  MissionExport made = export_mission(scene, flight, format, options);
  if (!made.written || wishes.off_nominal == 0) return made;
  return with_off_nominal(scene, flight, options, wishes, std::move(made));
}

}  // namespace traj
