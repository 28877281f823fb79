#include "assumptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geom/text/counted.h"
#include "geom/text/rounded.h"
#include "traj/record/disturbance_record.h"

namespace traj {
namespace {

class Assumptions {
 public:
  Assumptions(const Submission& submission, std::span<const FlightClaims> flights)
      : submission_(submission), method_(submission.method), flights_(flights) {}

  std::vector<std::string> all() {
    item("The map is like the world, and the vehicle is like its profile.");
    assume_map();
    assume_straying();
    item(
        fmt::format("The map's origin is at {:.9g}, {:.9g} and {:g} m above the ellipsoid of WGS "
                    "84.",
                    method_.origin.latitude, method_.origin.longitude, method_.origin.height));
    item(
        fmt::format("No ground below the flights is lower than {:g} m in the map's heights. "
                    "Heights above the ground are counted from there.",
                    method_.floor));
    if (const auto& energy = method_.energy) {
      item(
          fmt::format("The battery holds {:g} Wh, of which {:g} % stay as reserve, and the vehicle "
                      "takes {:g} W at most.",
                      energy->capacity / 3600, 100 * energy->reserve, energy->power));
    }
    assume_manoeuvre();
    item(
        "No wind carries the vehicle out of the contingency volume, or farther while it comes "
        "down.");
    if (has_kind(flights_, "mission")) {
      item(mission_reading());
      if (method_.ground_model) assume_terrain();
      item(fmt::format("Missions are flown between {} and {}. Their durations are estimates{}.",
                       method_.begins.value_or(""), method_.ends.value_or(""),
                       method_.energy ? ", by which the battery lasts to its reserve" : ""));
    }
    assume_ground();
    item(!submission_.pairs
             ? "The flights were not compared with each other, nor with other traffic."
         : has_kind(flights_, "mission")
             ? "Missions have no times, so they were not compared with any flight. Nothing was "
               "compared with other traffic."
             : "The flights were not compared with other traffic.");
    item(submission_.zones.empty()
             ? "No zones of airspace were looked at, other than what the map holds."
             : "Zones of airspace are as the files below say. What they close is an obstacle of "
               "the map at "
               "its times; what they only list stands in the map's history.");
    return std::move(said_);
  }

 private:
  void item(std::string text) { said_.push_back(std::move(text)); }

  std::string parameters() const {
    if (!method_.params) return "its firmware";
    return "autopilot.params (" + *method_.params + "); what it does not have, of its firmware";
  }

  // What decides where an autopilot may be, and is in no file.
  std::string mission_reading() const {
    std::string out = fmt::format(
        "Missions are flown by an autopilot ({}) with the parameters of {}, an airframe "
        "with a drag over its mass of {:g} 1/s, and a sea level {}",
        method_.autopilot, parameters(), method_.drag.value_or(0),
        method_.geoid_grid ? "as geoid.gtx says (" + *method_.geoid_grid + ")"
                           : fmt::format("{:g} m above the ellipsoid", method_.geoid));
    if (method_.ground) out += fmt::format(", from ground at {:g} m", *method_.ground);
    if (method_.navigation) {
      out += fmt::format(
          ", which is wrong about its place by at most {:g} m across and {:g} m up or down",
          method_.navigation->across, method_.navigation->vertical);
    }
    return out + ".";
  }

  // What decides how high a mission above terrain is flown, and is in no file.
  void assume_terrain() {
    TerrainClaim most;
    double seen = 0;  // the widest band of those that follow the surface
    for (const FlightClaims& one : flights_) {
      if (!one.terrain) continue;
      if (one.terrain->surface) {
        seen = std::max(seen, one.terrain->band);
        continue;
      }
      most.spacing = std::max(most.spacing, one.terrain->spacing);
      most.lag = std::max(most.lag, one.terrain->lag);
      most.band = std::max(most.band, one.terrain->band);
    }
    if (seen > 0) {
      item(
          fmt::format("An aircraft that follows the surface as its sensors see it stays {:g} to "
                      "{:g} m above the ground of terrain.ground, wherever roofs and trees lead "
                      "it. Its maker states no such bound: the operator does. This makes a band "
                      "of heights of up to {:.1f} m, which is what was proved clear.",
                      method_.surface->low, method_.surface->high, seen));
    }
    if (most.band == 0) return;
    item(
        fmt::format("Heights above terrain count from the autopilot's own terrain, which is within "
                    "{:g} m of the ground at its posts, {:g} m apart. The ground is as "
                    "terrain.ground says. The autopilot has loaded its terrain when it arms, "
                    "clamps no height, and follows no rangefinder. The vehicle is up to "
                    "{:g} m behind its terrain. All of this makes a band of heights of up to "
                    "{:.1f} m, which is what was proved clear.",
                    *method_.terrain_error, most.spacing, most.lag, most.band));
  }

  // Where the map's makers did not know the world, and say so.
  void assume_map() {
    const geom::MapDoubts& doubts = submission_.doubts;
    if (doubts.skipped > 0) {
      item(fmt::format("{} of the map's sources could not be built, and {} not in the map.",
                       geom::counted(doubts.skipped, "possible obstacle"),
                       doubts.skipped == 1 ? "is" : "are"));
    }
    if (doubts.unknown_free) item("Space of which a source of the map says nothing is free.");
    if (doubts.widened) {
      item(
          "Nothing stands between the map's first bounds and its present ones, which somebody set "
          "wider.");
    }
    if (doubts.gap > 0) {
      item(
          fmt::format("Nothing stands where none of the maps that were joined reaches: in {:.3g} % "
                      "of the bounds.",
                      100 * doubts.gap));
    }
  }

  // How far the vehicle may be from its way.
  void assume_straying() {
    const std::string beyond =
        method_.buffer > 0 ? fmt::format(" and {:g} m", method_.buffer) : std::string();
    if (!method_.tubes) {
      return item(
          fmt::format("The vehicle strays from its way by no more than the margin{}.", beyond));
    }
    item("The vehicle moves like the simulated one of its profile, without delay" +
         (beyond.empty() ? "." : fmt::format(", or strays{} more.", beyond.substr(4))));
    constexpr std::string_view exact = ", exact readings of the sensors";
    std::vector<std::string> said_before;
    for (const FlightClaims& one : flights_) {
      if (!one.tube || !one.tube->disturbances) continue;
      const Disturbances& met = *one.tube->disturbances;
      const std::string words = fmt::format(
          "It is flown by the {} controller, with the gains and loop periods that skyway-fly was "
          "given, and meets {}{}.",
          geom::word_of(kControlLawWords, one.tube->law), in_words(met),
          met.has_noise() ? "" : exact);
      if (std::find(said_before.begin(), said_before.end(), words) != said_before.end()) continue;
      item(words);
      said_before.push_back(words);
    }
    item(
        "The tubes are as skyway-fly reported them (tubes.jsonl). The check of this folder holds "
        "volumes and map against them, and does not prove them again.");
  }

  void assume_manoeuvre() {
    const RiskRules& rules = method_.risk;
    if (rules.contingency == ContingencyRule::ways_home) {
      item(fmt::format(
          "If something goes wrong, the autopilot ({}), or the aircraft of DJI, returns as its "
          "model says, with the parameters of {}, and a drag over its mass of {:g} 1/s{}.",
          method_.autopilot, parameters(), method_.drag.value_or(0),
          method_.return_height ? fmt::format(", {:g} m above home", *method_.return_height)
                                : std::string()));
      double least = 1;
      for (const FlightClaims& one : flights_) least = std::min(least, one.returns.value_or(1));
      if (least < 1) {
        item(
            fmt::format("Returns may meet an obstacle: of the flight with the least, {:.4g} % of "
                        "the time has a return that is proved clear.",
                        geom::rounded_down(100 * least)));
      }
      return;
    }
    item(fmt::format(
        "If something goes wrong, the vehicle stops: after {:g} s, tilted by {:.4g} degrees. "
        "Errors: navigation S_GNSS {:g} m, keeping the place S_Pos {:g} m, map S_K {:g} m, height "
        "H_err {:g} m.",
        rules.reaction, rules.tilt * 57.29577951308232, rules.position_error, rules.holding_error,
        rules.map_error, rules.altitude_error));
  }

  void assume_ground() {
    std::size_t unknown = 0;
    for (const FlightClaims& one : flights_) unknown = std::max(unknown, one.people_unknown);
    if (!submission_.population) {
      item("Nobody counted the people below the flights.");
      return;
    }
    item("People are where the raster says. It knows no hour of the day and no crowd.");
    if (unknown > 0) {
      item(fmt::format("The raster says nothing of up to {} below a flight. They count as nobody.",
                       geom::counted(unknown, "cell")));
    }
  }

  const Submission& submission_;
  const SubmissionMethod& method_;
  std::span<const FlightClaims> flights_;
  std::vector<std::string> said_;
};

}  // namespace

bool has_kind(std::span<const FlightClaims> flights, std::string_view kind) {
  return std::any_of(flights.begin(), flights.end(),
                     [&](const FlightClaims& one) { return one.kind == kind; });
}

double widest_tube(std::span<const FlightClaims> flights) {
  double widest = 0;
  for (const FlightClaims& one : flights) {
    if (one.tube) widest = std::max(widest, one.tube->largest);
  }
  return widest;
}

std::vector<std::string> assumptions(const Submission& submission,
                                     std::span<const FlightClaims> flights) {
  return Assumptions(submission, flights).all();
}

}  // namespace traj
