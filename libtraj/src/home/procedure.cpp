#include "traj/home/procedure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "geom/map/geographic_frame.h"
#include "geom/text/counted.h"
#include "geom/text/rounded.h"
#include "traj/record/verdict.h"

namespace traj {
namespace {

std::string in_degrees(const geom::GeodeticPlace& place) {
  return fmt::format("latitude {:.7f}, longitude {:.7f}", place.latitude, place.longitude);
}

class Procedure {
 public:
  Procedure(const geom::CollisionScene& scene, const LostLink& what)
      : scene_(scene), what_(what), task_(what.flight.task), earth_(what.origin) {}

  std::string text() const {
    return fmt::format("Lost-link procedure of flight {}\n", what_.id) +
           section("What the vehicle does", action()) + section("Places", places()) +
           section("Fences", fences()) + section("Times without a proved return", gaps()) +
           section("What this rests on", basis()) + section("What is not proved", unproved());
  }

 private:
  using Lines = std::vector<std::string>;

  static std::string section(const std::string& title, const Lines& lines) {
    return fmt::format("\n{}\n{}\n", title, fmt::join(lines, "\n"));
  }

  // Latitude and longitude of a place of the map.
  std::string where(const Vec3& place) const {
    return in_degrees(earth_.place(geom::to_enu(scene_.map().spec().frame.axes, place)));
  }

  Lines action() const {
    Lines out;
    const auto& legs = what_.mission.legs;
    if (!legs.empty()) {
      out.push_back(fmt::format(
          "If the link is lost between the take-off (item {}) and the landing (item {}), the "
          "vehicle leaves its mission and returns by itself.",
          legs.front().item, legs.back().item));
    }
    for (const ReturnModel& model : task_.models) out.push_back(way_of(model));
    out.push_back(
        fmt::format("A return takes at most about {:.0f} s. The whole flight takes about {:.0f} s.",
                    what_.proof.longest, what_.proof.duration));
    return out;
  }

  static std::string way_of(const ReturnModel& model) {
    std::string cone;
    if (model.slope > 0 || model.low_within > 0) {
      cone = " Near its place it may stay lower, in a cone.";
    }
    const std::string least =
        model.least_climb > 0 ? fmt::format(", and at least {:g} m", model.least_climb) : "";
    return fmt::format(
        "{}: it brakes, climbs to {:g} m above home{}, flies straight to its place with {:g} m/s, "
        "sinks and lands.{}",
        model.autopilot, model.height, least, model.speed, cone);
  }

  Lines places() const {
    Lines out{fmt::format("Home: {}.", where(task_.home))};
    for (std::size_t i = 0; i < task_.rally.size(); ++i) {
      out.push_back(fmt::format("Rally point {}: {}, {:.1f} m above home.", i + 1,
                                where(task_.rally[i]), task_.rally[i].z() - task_.home.z()));
    }
    if (!task_.rally.empty()) out.emplace_back("It goes to the nearest of these.");
    return out;
  }

  Lines fences() const {
    if (what_.fences.empty()) return {"None."};
    Lines out;
    for (std::size_t i = 0; i < what_.fences.size(); ++i) {
      const GeodeticFence& fence = what_.fences[i];
      out.push_back(fmt::format("{}. {}", i + 1,
                                fence.inclusion ? "The vehicle stays within" : "It stays out of"));
      if (fence.ring.empty()) {
        out.push_back(fmt::format("   {:g} m around {}", fence.radius, in_degrees(fence.centre)));
      }
      for (const geom::GeodeticPlace& place : fence.ring) out.push_back("   " + in_degrees(place));
    }
    const bool kept =
        std::none_of(what_.proof.gaps.begin(), what_.proof.gaps.end(),
                     [](const ReturnGap& gap) { return gap.reason == Reason::fence; });
    out.emplace_back(kept ? "The mission and each proved return keep to all of them."
                          : "The mission keeps to all of them. Not every return does: see below.");
    return out;
  }

  Lines gaps() const {
    const ReturnReport& proof = what_.proof;
    Lines out{fmt::format("A return is proved for {:.4g} % of the flight's time.",
                          geom::rounded_down(100 * proof.share()))};
    if (proof.gaps.empty()) out = {"None: a return is proved from every instant."};
    for (const ReturnGap& gap : proof.gaps) {
      const std::string item = gap.part ? fmt::format("item {}: ", gap.part->item) : "";
      out.push_back(fmt::format("- {}{}, {} ({})", item, in_words(gap, scene_.map()),
                                where(gap.place), gap.autopilot));
    }
    out.emplace_back("Times count from the take-off, and are estimates.");
    return out;
  }

  Lines basis() const {
    const Vec3 half = 2 * scene_.vehicle().half;
    Lines out{fmt::format("Map: {}, {}.", scene_.map().hash(),
                          geom::counted(scene_.map().size(), "obstacle", "obstacles")),
              fmt::format("Vehicle: {}, a box of {:g} x {:g} x {:g} m, with a margin of {:g} m.",
                          scene_.vehicle().name, half.x(), half.y(), half.z(), scene_.margin()),
              fmt::format("Autopilot: {}.", names_of(what_.flier.autopilots))};
    const Vec3& room = task_.room;
    out.push_back(fmt::format("Navigation: wrong by at most {:g} m across and {:g} m up or down.",
                              room.x(), room.z()));
    out.push_back(what_.flier.exactly
                      ? "Parameters: as the file says that was given."
                      : "Parameters: the firmware's defaults, but for the return height.");
    if (!what_.flier.assumed.empty()) {
      out.push_back(fmt::format("Of these, defaults: {}.", fmt::join(what_.flier.assumed, ", ")));
    }
    for (const Autopilot& one : what_.flier.autopilots) out.push_back(settings_of(one));
    return out;
  }

  static std::string settings_of(const Autopilot& autopilot) {
    return fmt::format("{} must be set to return when its link is lost: {}.", autopilot.name,
                       autopilot.firmware == Firmware::px4
                           ? "NAV_DLL_ACT 2 and NAV_RCL_ACT 2, with RTL_TYPE 0"
                           : "FS_GCS_ENABLE 1 and FS_THR_ENABLE 1, with RTL_ALT_FINAL 0");
  }

  static Lines unproved() {
    return {"Wind, a map that is wrong or old, and a sensor that fails.",
            "What the vehicle does if it leaves a fence, or if its battery is low."};
  }

  const geom::CollisionScene& scene_;
  const LostLink& what_;
  const ReturnTask& task_;
  geom::GeographicFrame earth_;
};

}  // namespace

std::string lost_link_procedure(const geom::CollisionScene& scene, const LostLink& what) {
  return Procedure(scene, what).text();
}

}  // namespace traj
