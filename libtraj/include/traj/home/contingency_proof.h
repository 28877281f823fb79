#pragma once

// Why contingencies hold: the regions that were found clear, for a certificate and an exact check.
//
// Example:
//   traj::ContingencyRules rules;
//   rules.models = {traj::return_model(traj::px4("1.17"))};
//   const std::vector<traj::ContingencyRecord> none;
//   const auto stages = traj::stages_of(trajectory);
//   const auto ways = traj::proved_ways(scene, stages, none, rules);
//   const traj::ExactTask task{.map = map, .vehicle = vehicle, .margin = 0.2};
//   assert(!traj::check_exactly(task, stages, ways).ok);  // there is no way home

#include <span>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/home/check_contingencies.h"
#include "traj/home/contingency_record.h"
#include "traj/home/flight_stage.h"
#include "traj/home/home_flight.h"
#include "traj/home/prism.h"
#include "traj/proof/exact/exact_check.h"

namespace traj {

// A part of a flight from which a way can be joined. The region where the vehicle brakes, the
// convex hull of that region and the way's first point, and the region beyond the point were found
// clear.
struct ProvedJoin {
  double from = 0;  // s of the flight, closed
  double until = 0;
  std::vector<Vec3> where;  // the vehicle is in their convex hull
  Prism braking;
  Prism beyond;      // of the first point: what is overshot there
  double lasts = 0;  // s from the order to the ground, at most
};

struct ProvedWay {
  ContingencyRecord record;
  std::vector<Prism> beyond;  // of the end of each leg, the last one down to the ground left out
  std::vector<ProvedJoin> joins;
};

// What check_contingencies() proves of those records that have a way and hold.
std::vector<ProvedWay> proved_ways(const geom::CollisionScene& scene,
                                   std::span<const FlightStage> stages,
                                   std::span<const ContingencyRecord> records,
                                   const ContingencyRules& rules);

// Decides in whole numbers what check_contingencies() decides by rounded ones, and shares no code
// with it: the flight is in the regions where it brakes, to 5e-10 m, and these leave out no
// instant; regions, hulls and legs are clear of the boxes of the map, grown by the task's half
// sizes and margin, and inside the bounds; the way down ends on the ground. How far the vehicle
// brakes and overshoots is taken as it is. Throws InputError for numbers that are not finite, and
// for times that go back.
ExactResult check_exactly(const ExactTask& task, std::span<const FlightStage> stages,
                          std::span<const ProvedWay> ways);

// One JSON object, "type":"contingencies", with a newline: docs/certificates.md.
std::string contingency_certificate_line(const geom::CollisionScene& scene,
                                         const HomeFlight& flight, std::span<const ProvedWay> ways,
                                         const ContingencyRules& rules);

}  // namespace traj
