#include "traj/record/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "geom/text/rounded.h"
#include "record/fault_verdict.h"
#include "record/rests_on.h"
#include "record/return_verdict.h"

namespace traj {
namespace {

constexpr double kClearanceRoom = 1e-3;  // metres, as CheckResult::clearance says

std::string when(const ReportRecord& report) {
  const CheckResult& result = report.result;
  if (result.part) {
    return fmt::format(" at item {} ({})", result.part->item, name(result.part->manoeuvre));
  }
  if (report.checked == "path") return fmt::format(" on leg {:.0f}", std::floor(result.time));
  return fmt::format(" at {:.6g} s", result.time);
}

// Where the vehicle may be that fails, if that is not its way itself.
std::string strayed(const CheckResult& result) {
  if (result.strayed.empty()) return "";
  return result.part ? fmt::format(" where {} may stray from its way", result.strayed)
                     : fmt::format(" with what is allowed for {}", result.strayed);
}

// Whether the time and place of a refusal tell where to look.
bool has_place(const CheckResult& result) {
  const bool unknown =
      std::any_of(kLimitKinds.begin(), kLimitKinds.end(),
                  [&](const LimitKind& kind) { return result.reason == unmeasured(kind.limit); });
  const bool no_height = result.reason == Reason::return_home && result.worst == 0;
  return !unknown && !no_height && result.reason != Reason::duration_bound;
}

std::string refused_in_words(const ReportRecord& report, const geom::BoxMap& map) {
  const CheckResult& result = report.result;
  const bool told = result.reason == Reason::takeoff && !report.detail.empty();
  std::string out = told ? geom::excerpt(report.detail, 400)
                         : fault_in_words(result, map, held_of(report.provenance, report.limits));
  if (result.looked && has_place(result)) {
    const Vec3& p = result.place;
    out += fmt::format("{}{}, near [{:.3f}, {:.3f}, {:.3f}]", when(report), strayed(result), p.x(),
                       p.y(), p.z());
  }
  if (!told && !report.detail.empty()) out += ": " + geom::excerpt(report.detail, 400);
  const std::string advice = advice_for(report);
  return advice.empty() ? out : out + "; " + advice;
}

// The least distance of a curve is known to kClearanceRoom: it may be so much less than was found.
std::string clearance_in_words(const ReportRecord& report) {
  const auto& clearance = report.result.clearance;
  if (!clearance) return "";
  const bool path = report.checked == "path";
  const bool straight = path && !report.navigation;  // a drone file may have curves
  const double room = straight ? 0 : kClearanceRoom;
  const double least = std::max(0.0, clearance->value - room);
  return fmt::format(", at least {:.4g} m from every obstacle ({} {:.4g}{})",
                     geom::rounded_down(least), path ? "on leg" : "at",
                     path ? std::floor(clearance->time) : clearance->time, path ? "" : " s");
}

std::string accepted_in_words(const ReportRecord& report) {
  const CheckResult& result = report.result;
  std::string out = result.duration > 0 ? fmt::format("clear for {:.4g} s", result.duration)
                                        : std::string("clear on every leg");
  out += clearance_in_words(report);
  const std::string rests = rests_on_in_words(report);
  return rests.empty() ? out : out + "; " + rests;
}

// What to do where a place is not free.
std::string place_advice(const ReportRecord& report) {
  const CheckResult& result = report.result;
  if (result.reason == Reason::bounds) {
    return "stay inside, or make the bounds wider (skyway-map bounds)";
  }
  if (!result.strayed.empty()) {
    return fmt::format("keep {:g} m more room there, or fly slower",
                       std::ceil(100 * result.worst) / 100);
  }
  if (result.part) return "move the item, or fly higher";
  return report.checked == "path" ? "plan it anew on this map (skyway-plan or skyway-replan)"
                                  : "solve it anew on this map (skyway-plan, then skyway-traj)";
}

std::string limit_advice(const CheckResult& result) {
  for (const LimitKind& kind : kLimitKinds) {
    if (result.reason == broken(kind.limit)) {
      return fmt::format("fly slower, or solve it with {}", kind.option);
    }
    if (result.reason == unmeasured(kind.limit)) {
      return fmt::format("leave {} out, or check a record that says it", kind.option);
    }
  }
  return "";
}

// Why no tube is proved.
std::string in_words(const TubeTrouble& trouble) {
  const auto clipped = [&](std::string_view what, std::string_view unit) {
    return fmt::format("{} may be clipped at {:.4g} s, by {:.2g} {}", what, trouble.time,
                       -trouble.room, unit);
  };
  switch (trouble.kind) {
    case TubeTrouble::Kind::unstable:
      return "with these gains the loop is not stable in hover";
    case TubeTrouble::Kind::tilt:
      return fmt::format("the vehicle may tip over at {:.4g} s", trouble.time);
    case TubeTrouble::Kind::steps:
      return "steps of a millisecond are too coarse for this vehicle";
    case TubeTrouble::Kind::velocity:
      return clipped("the velocity that the position loop wants", "m/s");
    case TubeTrouble::Kind::acceleration:
      return clipped("the acceleration that the velocity loop wants", "m/s2");
    case TubeTrouble::Kind::lift:
      return clipped("the lift", "m/s2");
    case TubeTrouble::Kind::lean:
      return clipped("the horizontal part of the lift, by the tilt limit,", "m/s2");
    case TubeTrouble::Kind::rates:
      return clipped("a body rate that the attitude loop wants", "rad/s");
    case TubeTrouble::Kind::turn:
      return clipped("the angular acceleration that the rate loop wants", "rad/s2");
    case TubeTrouble::Kind::motor:
      break;
  }
  return fmt::format("motor {} may saturate at {:.4g} s, by {:.2g} N", trouble.motor, trouble.time,
                     -trouble.room);
}

std::string in_words_of_damping(double damping) {
  return fmt::format(
      "allow less wind, gusts or mass error, fly slower, or find gains of more damping (now "
      "{:.2g})",
      damping);
}

// Where a simulated flight, or a tube, is not clear.
std::string flown_in_words(const FlightPathCheck& check, const geom::Provenance& provenance,
                           const geom::BoxMap& map) {
  CheckResult fault;
  fault.reason = check.reason;
  fault.place = check.place;
  fault.box = check.box;
  const geom::Vec3& p = check.place;
  return fmt::format("{} at {:.6g} s, near [{:.3f}, {:.3f}, {:.3f}]",
                     fault_in_words(fault, map, held_of(provenance)), check.time, p.x(), p.y(),
                     p.z());
}

std::string ways_home_in_words(const ReportRecord& report) {
  return fmt::format("ways home from every instant of {:.4g} s{}{}{}", report.result.duration,
                     report.exact ? "; proved again in exact numbers" : "",
                     report.detail.empty() ? "" : "; ", report.detail);
}

}  // namespace

std::string advice_for(const ReportRecord& report) {
  const CheckResult& result = report.result;
  if (result.ok) return "";
  switch (result.reason) {
    case Reason::bounds:
    case Reason::collision:
    case Reason::undecided:
      return place_advice(report);
    case Reason::no_path:
    case Reason::infeasible:
    case Reason::stopped:
      return "look at what the tool before said";
    case Reason::takeoff:
      return "begin higher, or say where the ground is (--ground)";
    case Reason::takeoff_ground:
      return "say where the ground is (--ground), or put the ground into the map (skyway-map join)";
    case Reason::landing:
      return "end over level ground";
    case Reason::ceiling:
      return "fly lower";
    case Reason::range:
    case Reason::endurance:
      return "cut the flight into shorter ones";
    case Reason::return_home:
      return "say at which height it returns (--return-height)";
    case Reason::fence:
      return "move the item inside, or make the fence larger";
    default:
      return limit_advice(result);
  }
}

std::string_view verdict_word(const ReportRecord& report) {
  if (accepted(report)) return "ok";
  if (!report.result.ok) return name(report.result.reason);
  if (report.exact && !report.exact->ok) return "exact";
  return report.returns && !report.returns->ok() ? name(Reason::return_home) : kTubeReason;
}

std::string in_words(const TubeReport& tube, geom::Provenance over, const geom::BoxMap& map) {
  over.margin = tube.margin;
  return fmt::format("with {}, {}; keep more room there, or fly slower", in_words(tube.claim),
                     flown_in_words(tube.check, over, map));
}

std::string rests_on_in_words(const ReportRecord& report) {
  if (!accepted(report)) return "";
  return in_words(rests_on(report));
}

std::string in_words(const ReportRecord& report, const geom::BoxMap& map) {
  const bool ways_home = report.checked == kCheckedContingency;
  if (accepted(report)) {
    return ways_home ? ways_home_in_words(report) : accepted_in_words(report);
  }
  if (!report.result.ok) return ways_home ? report.detail : refused_in_words(report, map);
  const bool exact_refuses = report.exact && !report.exact->ok;
  if (!exact_refuses && report.returns && !report.returns->ok()) {
    return returns_in_words(*report.returns, map);
  }
  if (!exact_refuses) return in_words(*report.tube, report.provenance, map);
  return fmt::format(
      "the exact check refuses what the other accepts ({}); one of them is wrong: "
      "please report it",
      name(report.exact->reason));
}

std::string in_words(const FlightReport& report, const geom::BoxMap* map) {
  const std::string_view slower = "fly slower, or find other gains (--tune)";
  if (report.status != TrajectoryStatus::solved) return "there is no trajectory to fly";
  if (report.lost) {
    return fmt::format("the vehicle loses its way at {:.4g} s; {}", *report.lost, slower);
  }
  if (report.check && !report.check->clear && map) {
    return fmt::format("{}; {}", flown_in_words(*report.check, report.provenance, *map), slower);
  }
  if (report.tube.lost > 0) {
    return fmt::format("{} of the runs lose their way; {}", report.tube.lost, slower);
  }
  if (report.tube_check && !report.tube_check->clear && map) {
    return fmt::format("within the tube of its runs, {}; {}",
                       flown_in_words(*report.tube_check, report.provenance, *map), slower);
  }
  if (const auto& trouble = report.proved.trouble) {
    return fmt::format("no tube is proved: {}; {}", in_words(*trouble),
                       in_words_of_damping(report.proved.damping));
  }
  if (report.proved_check && !report.proved_check->clear && map) {
    return fmt::format("within the proved tube, {}; {}",
                       flown_in_words(*report.proved_check, report.provenance, *map), slower);
  }
  return fmt::format("flown in {:.4g} s", report.duration);
}

std::string in_words(const TrajectoryRecord& record) {
  const std::string_view kind =
      record.status == TrajectoryStatus::no_path ? "there is no path to fly" : "no trajectory";
  const std::string why =
      record.message.empty() ? "" : fmt::format(": {}", geom::excerpt(record.message, 400));
  switch (record.status) {
    case TrajectoryStatus::solved:
      return "solved";
    case TrajectoryStatus::no_path:
      return fmt::format("{}{}", kind, why);
    case TrajectoryStatus::stopped:
      return fmt::format("{}: the solver was stopped{}", kind, why);
    case TrajectoryStatus::infeasible:
      break;
  }
  return fmt::format(
      "{}{}; plan with more --margin, allow more (--vmax, --amax), or try --solver stop-and-go",
      kind, why.empty() ? ": none was found that keeps clear and inside the limits" : why);
}

}  // namespace traj
