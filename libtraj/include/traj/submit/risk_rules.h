#pragma once

// How far the volumes of a SORA reach: the formulas for contingency volume and ground risk buffer.
//
// Example:
//   traj::RiskRules rules{.dimension = 0.7};
//   const traj::ContingencySize size = traj::contingency_size(rules, 10);
//   assert(size.across > 10 && traj::ground_buffer(rules, 10, 60) == 60.35);
//   for (const traj::RiskFormula& one : traj::formulas(rules)) std::cout << one.formula << '\n';
//
// The terms are those of SORA 2.5: the flight geography holds the flight, the contingency volume
// what is flown when something goes wrong, and the ground risk buffer where the vehicle may come
// down. The sizes are those of LBA's guideline (Luftfahrt-Bundesamt: dimensioning of flight
// geography, contingency volume and ground risk buffer); the operator chooses their numbers. BBK
// and LBA publish twelve distances for multirotors (STS-BOS 1.0 of June 2025, tables 1 and 2: 30
// degrees, 1 m of height). These sizes give all twelve, to the decimetre. Chapter A.5 of SORA's
// Annex A is about flight areas; it was not read, and may ask for more. The rules are assumptions:
// nothing proves that a vehicle behaves so.

#include <string_view>
#include <vector>

#include "geom/text/words.h"

namespace traj {

// What the contingency volume is for: a multirotor that stops, or the autopilot's own return.
enum class ContingencyRule { stop, ways_home };
inline constexpr geom::Words<ContingencyRule, 2> kContingencyWords{
    {{ContingencyRule::stop, "stop"}, {ContingencyRule::ways_home, "return"}}};

// How far from the contingency volume the vehicle may come down.
enum class BufferRule { one_to_one, ballistic };
inline constexpr geom::Words<BufferRule, 2> kBufferWords{
    {{BufferRule::one_to_one, "1:1"}, {BufferRule::ballistic, "ballistic"}}};

// What the flight geography holds around the way: the margin, or the proved tube of the flight.
enum class GeographyRule { margin, proved_tube };
inline constexpr geom::Words<GeographyRule, 2> kGeographyWords{
    {{GeographyRule::margin, "margin"}, {GeographyRule::proved_tube, "proved tube"}}};

struct RiskRules {
  GeographyRule geography = GeographyRule::margin;
  ContingencyRule contingency = ContingencyRule::stop;
  BufferRule buffer = BufferRule::one_to_one;
  double dimension = 0;              // m: CD, the largest between two points of the vehicle
  double position_error = 3;         // m: of satellite navigation
  double holding_error = 3;          // m: of keeping the place
  double map_error = 1;              // m: of the map
  double altitude_error = 4;         // m: of the height
  double reaction = 1;               // s until the manoeuvre begins
  double tilt = 0.6108652381980153;  // rad, of the stop: 35 degrees; below pi/2
};

// m beyond the flight geography, to each side, up and down.
struct ContingencySize {
  double across = 0;
  double vertical = 0;
};

// For flights no faster than `speed`, m/s. Never below what the formulas give in real numbers. All
// 0 for ways home: their volume is that of the returns.
ContingencySize contingency_size(const RiskRules& rules, double speed);

// m around a contingency volume that reaches `height` m above the ground, >= 0. Likewise.
double ground_buffer(const RiskRules& rules, double speed, double height);

struct RiskFormula {
  std::string_view what;     // "ground risk buffer"
  std::string_view formula;  // "S_GRB = H_CV + CD / 2"
  std::string_view source;
};

// m, across and in height: LBA's guideline asks for a flight geography no smaller than this (3 CD).
double least_geography(const RiskRules& rules);

// Those that these rules use.
std::vector<RiskFormula> formulas(const RiskRules& rules);

}  // namespace traj
