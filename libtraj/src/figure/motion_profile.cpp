#include "traj/figure/motion_profile.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "geom/text/counted.h"
#include "shapes.h"
#include "traj/curve/flatness.h"
#include "traj/curve/smoothness.h"
#include "traj/record/duration_bound.h"

namespace traj::figure {
namespace {

constexpr int kSamples = 1500;
constexpr double kDegrees = 57.29577951308232;

using Value = std::function<double(const State&)>;

// A value at many instants of the trajectory.
template <class At>
std::vector<Point> sampled(const TrajectoryRecord& record, const At& at) {
  const double end = duration(record.trajectory);
  std::vector<Point> points;
  for (int i = 0; i <= kSamples; ++i)
    points.push_back({end * i / kSamples, at(end * i / kSamples)});
  return points;
}

// "∫ |jerk|² dt = 12.3 m²/s⁵"
std::string integral_words(const char* of, double value, const char* unit) {
  return fmt::format("\u222b |{}|\u00b2 dt = {:.4g} {}", of, value, unit);
}

// Draws the panels of one trajectory.
class Profile {
 public:
  explicit Profile(const TrajectoryRecord& record)
      : record_(record),
        axes_(record.provenance.frame.value_or(geom::Axes::enu)),
        limits_(limits_of(record)) {}

  std::vector<Panel> panels() const {
    std::vector<Panel> out{position(), speed(), acceleration(), jerk(), snap(), thrust(), tilt()};
    if (limits_[Limit::body_rate]) out.push_back(body_rate());
    return out;
  }

 private:
  Series curve(const Value& value, const char* label = "", std::size_t i = 0) const {
    return {label, colour(i), sampled(record_, [&](double t) {
              return value(to_enu(axes_, evaluate(record_.trajectory, t)));
            })};
  }

  std::vector<Level> level(const char* name, Limit limit, double scale = 1) const {
    if (!limits_[limit]) return {};
    const double value = *limits_[limit] * scale;
    return {{fmt::format("{} {:.4g}", name, value), value}};
  }

  Panel position() const {
    Panel out{.label = "position, m", .from_zero = false};
    constexpr const char* kNames[] = {"east", "north", "up"};
    for (int i = 0; i < 3; ++i) {
      const auto part = [i](const State& s) { return s.position[i]; };
      out.series.push_back(curve(part, kNames[i], static_cast<std::size_t>(i)));
    }
    return out;
  }

  Panel speed() const {
    const auto all = [](const State& s) { return s.velocity.norm(); };
    const auto sideways = [](const State& s) { return s.velocity.head<2>().norm(); };
    const auto upward = [](const State& s) { return std::abs(s.velocity.z()); };
    Panel out{"speed, m/s", {curve(all, "speed", 0)}, level("vmax", Limit::speed)};
    if (!limits_[Limit::horizontal_speed] && !limits_[Limit::vertical_speed]) return out;
    out.series.push_back(curve(sideways, "horizontal", 1));
    out.series.push_back(curve(upward, "vertical", 2));
    for (const Level& l : level("vmax_h", Limit::horizontal_speed)) out.levels.push_back(l);
    for (const Level& l : level("vmax_v", Limit::vertical_speed)) out.levels.push_back(l);
    return out;
  }

  Panel acceleration() const {
    const auto value = [](const State& s) { return s.acceleration.norm(); };
    return {"acceleration, m/s\u00b2", {curve(value)}, level("amax", Limit::acceleration)};
  }

  Panel jerk() const {
    const auto value = [](const State& s) { return s.jerk.norm(); };
    Panel out{"jerk, m/s\u00b3", {curve(value)}, level("jmax", Limit::jerk)};
    out.note = integral_words("jerk", smoothness(record_.trajectory).jerk, "m\u00b2/s\u2075");
    return out;
  }

  Panel snap() const {
    const auto value = [&](double t) { return traj::snap(record_.trajectory, t).norm(); };
    Panel out{"snap, m/s\u2074", {{"", colour(0), sampled(record_, value)}}};
    out.note = integral_words("snap", smoothness(record_.trajectory).snap, "m\u00b2/s\u2077");
    return out;
  }

  Panel thrust() const {
    const auto value = [](const State& s) { return flat_state(s, {}).thrust; };
    Panel out{"thrust/mass, m/s\u00b2", {curve(value)}, level("thrust", Limit::thrust)};
    out.from_zero = false;
    return out;
  }

  Panel tilt() const {
    const auto value = [](const State& s) {
      return std::acos(std::min(1.0, flat_state(s, {}).attitude(2, 2))) * kDegrees;
    };
    return {"tilt, \u00b0", {curve(value)}, level("tilt", Limit::tilt, kDegrees)};
  }

  Panel body_rate() const {
    const auto value = [](const State& s) { return flat_state(s, {}).body_rate.head<2>().norm(); };
    return {"body rate, rad/s", {curve(value)}, level("body_rate", Limit::body_rate)};
  }

  const TrajectoryRecord& record_;
  geom::Axes axes_;
  Limits limits_;
};

// How much faster another flight could be, where the record has a bound.
std::string gap_words(const TrajectoryRecord& record) {
  const auto gap = duration_gap(record);
  return gap ? ", " + slower_words(*gap) : "";
}

std::string title_of(const TrajectoryRecord& record) {
  return fmt::format("{}: {:.2f} s, {}{}{}", record.id, duration(record.trajectory),
                     geom::counted(record.trajectory.segments.size(), "segment"),
                     record.rung ? fmt::format(", {}", name(*record.rung)) : "", gap_words(record));
}

}  // namespace

std::string motion_profile(const TrajectoryRecord& record, std::string_view note) {
  Figure figure{title_of(record).append(note), "time, s", Profile(record).panels(), {}};
  double t = 0;
  for (const Segment& s : record.trajectory.segments) {
    figure.joints.push_back(std::min(t += s.duration, duration(record.trajectory)));
  }
  return drawn(figure);
}

}  // namespace traj::figure
