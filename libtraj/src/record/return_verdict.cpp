#include "return_verdict.h"

#include <fmt/format.h>

#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "geom/text/rounded.h"
#include "traj/record/verdict.h"

namespace traj {
std::string_view phase_in_words(std::string_view phase) {
  if (phase == "way") return "on its way home";
  if (phase == "climb") return "while it climbs";
  if (phase == "descent") return "while it sinks";
  return phase == "braking" ? "while it brakes" : "where it lands";
}

namespace {

std::string met_in_words(const ReturnGap& gap, const geom::BoxMap& map) {
  const Vec3& p = gap.place;
  const std::string near = fmt::format(", near [{:.3f}, {:.3f}, {:.3f}]", p.x(), p.y(), p.z());
  switch (gap.reason) {
    case Reason::bounds:
      return "the vehicle leaves the map's bounds" + near;
    case Reason::fence:
      return "the vehicle leaves the fence" + near;
    case Reason::landing:
      return "there is no level ground as high as home" + near;
    case Reason::return_home:
      return "the autopilot may go to a place that is not known";
    default:
      return "the vehicle meets " + obstacle_in_words(map, gap.box) + near;
  }
}

// Why nothing can land at home; empty if something may.
std::string home_fault(const ReturnReport& returns, const geom::BoxMap& map) {
  const Vec3& home = returns.home;
  const std::string said =
      fmt::format("home [{:.6g}, {:.6g}, {:.6g}] is", home.x(), home.y(), home.z());
  if (!geom::contains(map.spec().bounds, home)) {
    return said + " outside of the map's bounds: give another with --home-place";
  }
  for (const ReturnGap& gap : returns.gaps) {
    if (!gap.box) continue;
    const geom::Aabb box = map.box(*gap.box);
    if (!geom::contains(box, home) || home.z() >= box.max.z()) continue;
    return fmt::format(
        "{} inside of {}, whose top is at z = {:.6g}: give another with --home-place", said,
        obstacle_in_words(map, gap.box), box.max.z());
  }
  return "";
}

// What is not proved.
std::string_view unproved(std::string_view action) {
  if (action == "land") return "no landing is proved";
  return action == "hold" ? "no stop is proved" : "no way home is proved";
}

// What to change; empty if nothing is known that helps.
std::string return_advice(const ReturnReport& returns) {
  const Reason reason = returns.gaps.front().reason;
  if (returns.action != "rtl") return "";
  if (reason == Reason::return_home)
    return "; set RTL_TYPE so that it returns to home or a rally point";
  if (returns.least_height) {
    return fmt::format("; return at {:.4g} m above home", geom::rounded_up(*returns.least_height));
  }
  if (reason == Reason::landing)
    return "; give the height of the ground there with --home-place x,y,z";
  if (!returns.least_sought) return "";
  if (returns.best_height && *returns.best_share > returns.share()) {
    return fmt::format(
        ", and at {:.4g} m above home for {:.4g} %; no return height makes all of it safe: fly "
        "another "
        "way, or add rally points",
        *returns.best_height, geom::rounded_down(100 * *returns.best_share));
  }
  return "; no return height makes all of it safe: fly another way, or add rally points";
}

}  // namespace

std::string obstacle_in_words(const geom::BoxMap& map, std::optional<std::size_t> box) {
  if (!box) return "an obstacle";
  const std::string& label = map.labels()[map.label()[*box]];
  return fmt::format("obstacle {}{}", map.ids()[*box],
                     label.empty() ? "" : fmt::format(" ({})", geom::excerpt(label, 40)));
}

std::string returns_in_words(const ReturnReport& returns, const geom::BoxMap& map) {
  const ReturnGap& gap = returns.gaps.front();
  std::string out =
      fmt::format("from {:.4g} s to {:.4g} s {}", gap.from, gap.until, unproved(returns.action));
  const std::string home = returns.action == "rtl" ? home_fault(returns, map) : "";
  if (!home.empty()) return out + ": " + home;
  if (gap.autopilot != returns.autopilot) out += " as " + gap.autopilot + " flies it";
  out += ": ";
  if (gap.reason != Reason::return_home) out += std::string(phase_in_words(gap.phase)) + " ";
  out += met_in_words(gap, map);
  if (const std::size_t more = returns.gaps.size() - 1; more > 0) {
    out += fmt::format("; {} like it", geom::counted(more, "later time is", "later times are"));
  }
  out += fmt::format("; {} is proved for {:.4g} % of the flight", returns.action,
                     geom::rounded_down(100 * returns.share()));
  return out + return_advice(returns);
}

std::string in_words(const ReturnGap& gap, const geom::BoxMap& map) {
  return fmt::format("from {:.4g} s to {:.4g} s no way home is proved: {} {}", gap.from, gap.until,
                     phase_in_words(gap.phase), met_in_words(gap, map));
}

}  // namespace traj
