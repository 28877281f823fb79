#include "parameter_fence.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace traj {
namespace {

struct Reach {
  const Autopilot& pilot;
  const Vec3& home;
  double band;  // m above a place, where heights are not known
  std::string_view source;

  void require(const Vec3& place, std::size_t item) const {
    const bool px4 = pilot.firmware == Firmware::px4;
    const double above = place.z() - home.z() + band + pilot.tracking.z();
    if (pilot.fence_top && above > *pilot.fence_top) {
      refuse(item, px4 ? "GF_MAX_VER_DIST" : "FENCE_ALT_MAX", *pilot.fence_top, "above home",
             above);
    }
    const double across = (place - home).head<2>().norm() + pilot.tracking.x();
    if (pilot.fence_across && across > *pilot.fence_across) {
      refuse(item, px4 ? "GF_MAX_HOR_DIST" : "FENCE_RADIUS", *pilot.fence_across, "from home",
             across);
    }
  }

  [[noreturn]] void refuse(std::size_t item, const char* name, double most, const char* where,
                           double found) const {
    throw geom::InputError(
        source,
        geom::within(fmt::format("item {}", item),
                     {.expected = fmt::format("at most {:g} m {}, as {} says", most, where, name),
                      .found = fmt::format("up to {:.1f} m", found),
                      .advice = "there the autopilot leaves its mission because of its fence"}));
  }
};

bool is_wide(Manoeuvre manoeuvre) {
  return manoeuvre == Manoeuvre::circle || manoeuvre == Manoeuvre::spline ||
         manoeuvre == Manoeuvre::hover;
}

}  // namespace

void require_within_fence(const FlownMavlink& flown, std::span<const Autopilot> autopilots,
                          std::string_view source) {
  for (const Autopilot& pilot : autopilots) {
    if (!pilot.fence_top && !pilot.fence_across) continue;
    if (!flown.home) {
      throw geom::InputError(
          source,
          {.says = "the parameters make a fence around home, and where home is, is not known",
           .advice = "give the height of the ground there (--ground)"});
    }
    const Reach reach{pilot, *flown.home, flown.terrain ? flown.terrain->band : 0, source};
    for (std::size_t i = 0; i < flown.path.size(); ++i) {
      reach.require(flown.path[i], flown.legs[i].item);
    }
    for (const Sweep& sweep : flown.sweeps) {
      if (!is_wide(sweep.part.manoeuvre)) continue;
      for (const Vec3& place : sweep.hull) reach.require(place, sweep.part.item);
    }
  }
}

}  // namespace traj
