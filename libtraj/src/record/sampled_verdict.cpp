#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "geom/text/rounded.h"
#include "traj/record/verdict.h"

// Flight logs in sentences.

namespace traj {
namespace {

// How much of a log no sample says anything of.
std::string unmeasured_in_words(const SampledReport& report) {
  const SampledFlight& result = report.result;
  std::string out = fmt::format("what it did between samples, up to {:.3g} s, was not measured",
                                result.longest_step);
  if (result.on_ground > 0) {
    out +=
        fmt::format(", and {:.4g} s that it stood before and after are left out", result.on_ground);
  }
  return out;
}

// A log that touches nothing.
std::string sampled_in_words(const SampledReport& report) {
  const SampledFlight& result = report.result;
  const std::string kept =
      result.clearance
          ? fmt::format("came no nearer than {:.4g} m to an obstacle (at {:.6g} s)",
                        geom::rounded_down(result.clearance->value), result.clearance->time)
          : std::string("touched nothing");
  return fmt::format("at its {} samples and straight between them the vehicle {}; {}",
                     report.samples, kept, unmeasured_in_words(report));
}

std::string touch_in_words(const SampledReport& report, const geom::BoxMap& map) {
  const SampledFlight& result = report.result;
  const geom::Vec3& p = result.place;
  const std::string where =
      fmt::format("{:.6g} s, near [{:.3f}, {:.3f}, {:.3f}]", result.time, p.x(), p.y(), p.z());
  if (result.gap) {
    return fmt::format("there is no sample for {:.4g} s after {}: what it did then is not known",
                       result.worst, where);
  }
  CheckResult touch;
  touch.reason = result.reason;
  touch.worst = result.worst;
  touch.box = result.box;
  touch.place = result.place;
  return fmt::format("{} at {}", fault_in_words(touch, map, held_of(report.provenance)), where);
}

}  // namespace

std::string rests_on_in_words(const SampledReport& report) {
  std::vector<std::string> out;
  if (!report.map_said) {
    out.emplace_back("the log does not say its map, and was taken for this one (--override)");
  }
  if (report.tube && report.plan->inside < report.samples) {
    out.push_back(
        fmt::format("it was not surely within its tube ({}) at {} of them, first at {:.6g} s",
                    geom::word_of(kTubeKindWords, *report.tube),
                    report.samples - report.plan->inside, report.plan->left));
  }
  return fmt::format("{}", fmt::join(out, "; "));
}

std::string in_words(const SampledReport& report, const geom::BoxMap& map) {
  const std::string_view reason = reason_of(report, map);
  const std::string sampled = sampled_in_words(report);
  const std::string rests = reason.empty() ? rests_on_in_words(report) : "";
  if (reason.empty()) return rests.empty() ? sampled : sampled + "; " + rests;
  if (verdict(report.result) != "sampled") return touch_in_words(report, map);
  if (reason == "no_map") {
    return "the log does not say of which map its places are: read it with skyway-import-flight "
           "--map, or, if they are of this one, insist with --override; " +
           sampled;
  }
  if (reason == "cut" && !report.cut) {
    return "the log is shorter than its plan, so it does not hold the whole flight; until its "
           "end, " +
           sampled;
  }
  if (reason == "cut") {
    return "the log does not hold the whole flight (it is cut); in what it holds, " + sampled;
  }
  if (reason == "clearance") {
    return fmt::format("{}; expected at least {:.4g} m", sampled, *report.rule.clearance);
  }
  if (reason == "clearance_not_measured") {
    return "the vehicle was never in the air, so no clearance was measured";
  }
  return sampled +
         "; that proves nothing: accept it with --sampled, or say what is enough with "
         "--require-clearance";
}

}  // namespace traj
