#include "parameter_fence.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"

namespace traj {
namespace {

// How far PX4 takes itself to go on at most (GeofenceBreachAvoidance): it speeds up by `first`,
// which fades, then slows down.
double foreseen(double speed, double first, double slows, double jerk) {
  constexpr double kBetweenChecks = 0.2;  // s
  const double fast = speed + first * first / (2 * jerk);
  const double fading = speed * first / jerk + first * first * first / (3 * jerk * jerk);
  return fading + fast * fast / (2 * slows) + fast * slows / (2 * jerk) + kBetweenChecks * speed;
}

class FenceOf {
 public:
  FenceOf(const Autopilot& pilot, const FlownMavlink& flown, std::string_view source)
      : pilot_(pilot), flown_(flown), source_(source) {
    if (!pilot.foresight) return;
    double speed = pilot.speed;
    for (const Drift& drift : flown.drift) {
      if (drift.autopilot == pilot.name) speed = std::max(speed, drift.speed);
    }
    early_across_ = foreseen(speed, pilot.foresight->across, pilot.acceleration, pilot.jerk);
    early_up_ = foreseen(pilot.climb, pilot.foresight->up, pilot.foresight->slows_up, pilot.jerk);
  }

  bool is_none() const {
    const ParameterFence& fence = pilot_.fence;
    return !fence.top && !fence.bottom && !fence.across && !pilot_.highest_item;
  }

  // Its way first, which a person understands better than how it strays.
  void hold() const {
    if (!flown_.home) {
      throw geom::InputError(
          source_,
          {.says = "the autopilot has a fence around home, and the file does not say where home is",
           .advice = "give the height of the ground there (--ground)"});
    }
    hold_way();
    for (const Drift& drift : flown_.drift) {
      if (drift.autopilot != pilot_.name) continue;
      for (const Sweep& sweep : drift.sweeps) {
        for (const Vec3& place : sweep.hull) {
          hold(place, drift.around, sweep.part.item, " where it strays");
        }
      }
    }
  }

 private:
  void hold_way() const {
    const double band = flown_.terrain ? flown_.terrain->band : 0;
    const Vec3 around = pilot_.tracking + Vec3(0, 0, band);
    bool was_above = false;
    for (std::size_t i = 0; i < flown_.path.size(); ++i) {
      const std::size_t item = flown_.legs[i].item;
      require_flown_so_high(flown_.path[i], item);
      hold(flown_.path[i], around, item, "");
      if (was_above) hold_above(flown_.path[i], around, item);
      was_above = was_above || (pilot_.fence.bottom &&
                                above_home(flown_.path[i]) + around.z() > *pilot_.fence.bottom);
    }
    for (const Sweep& sweep : flown_.sweeps) {
      const bool wide = is_wide(sweep.part.manoeuvre);
      for (const Vec3& place : sweep.hull) {
        if (wide) hold(place, around, sweep.part.item, "");
        // A payload's place is no landing (ModeAuto::is_landing).
        if (was_above && (wide || sweep.stands_on)) hold_above(place, around, sweep.part.item);
      }
    }
  }

  void hold(const Vec3& place, const Vec3& around, std::size_t item, const char* where) const {
    const bool px4 = pilot_.firmware == Firmware::px4;
    const ParameterFence& fence = pilot_.fence;
    const double above = above_home(place) + around.z() + early_up_;
    if (fence.top && above >= *fence.top) {
      refuse(item,
             fmt::format("less than {:g} m above home, as {} says", *fence.top,
                         px4 ? "GF_MAX_VER_DIST" : "FENCE_ALT_MAX"),
             fmt::format("up to {:.1f} m{}", above, where));
    }
    const double across =
        (place - *flown_.home).head<2>().norm() + std::max(around.x(), around.y()) + early_across_;
    if (fence.across && across >= *fence.across) {
      refuse(item,
             fmt::format("less than {:g} m from home, as {} says", *fence.across,
                         px4 ? "GF_MAX_HOR_DIST" : "FENCE_RADIUS"),
             fmt::format("up to {:.1f} m{}", across, where));
    }
  }

  void hold_above(const Vec3& place, const Vec3& around, std::size_t item) const {
    const double above = above_home(place) - around.z();
    if (above > *pilot_.fence.bottom) return;
    refuse(item,
           fmt::format("more than {:g} m above home, as FENCE_ALT_MIN says", *pilot_.fence.bottom),
           fmt::format("down to {:.1f} m", above));
  }

  void require_flown_so_high(const Vec3& place, std::size_t item) const {
    const double above = above_home(place);
    if (!pilot_.highest_item || above <= *pilot_.highest_item + 1e-6) return;
    throw geom::InputError(
        source_,
        geom::within(fmt::format("item {}", item),
                     {.expected = fmt::format("at most {:g} m above home, as LNDMC_ALT_MAX "
                                              "says",
                                              *pilot_.highest_item),
                      .found = fmt::format("{:.1f} m", above),
                      .advice = "PX4 until 1.14 flies no higher than that, and newer "
                                "versions have no such parameter"}));
  }

  double above_home(const Vec3& place) const { return place.z() - flown_.home->z(); }

  [[noreturn]] void refuse(std::size_t item, std::string expected, std::string found) const {
    const bool switched = flown_.switches_fence && pilot_.firmware == Firmware::ardupilot;
    throw geom::InputError(
        source_,
        geom::within(fmt::format("item {}", item),
                     {.expected = std::move(expected),
                      .found = std::move(found),
                      .advice = switched ? "there the autopilot leaves its mission because "
                                           "of its fence, which an item of command 207 "
                                           "switches on (--params has its limits)"
                                         : "there the autopilot leaves its mission "
                                           "because of its fence"}));
  }

  static bool is_wide(Manoeuvre manoeuvre) {
    return manoeuvre == Manoeuvre::circle || manoeuvre == Manoeuvre::spline ||
           manoeuvre == Manoeuvre::hover;
  }

  const Autopilot& pilot_;
  const FlownMavlink& flown_;
  std::string_view source_;
  double early_across_ = 0;  // m before the fence at which it acts
  double early_up_ = 0;
};

}  // namespace

void require_within_fence(const FlownMavlink& flown, std::span<const Autopilot> autopilots,
                          std::string_view source) {
  for (const Autopilot& pilot : autopilots) {
    const FenceOf fence(pilot, flown, source);
    if (pilot.foresight && !flown.fences.empty()) {
      throw geom::InputError(source,
                             {.key = "GF_PREDICT",
                              .expected = "0, since the file has fences",
                              .found = "1",
                              .advice = "PX4 leaves its mission before it comes to a fence"});
    }
    if (!fence.is_none()) fence.hold();
  }
}

}  // namespace traj
