#pragma once

// When a flight must not depart, whatever others do: the map's boxes that are there for a time.
//
// Example:
//   const auto spans = traj::forbidden_by_map(scene, trajectory, traj::Parked::gone);
//   assert(spans.empty());  // this map has no timed boxes

#include <vector>

#include "geom/collision/collision.h"
#include "traj/curve/trajectory.h"
#include "traj/fleet/departure_span.h"
#include "traj/together/timed_flight.h"

namespace traj {

// All departures, in seconds after the map's epoch, with which there is an instant at which the
// flight is in a grown box of the scene while that box is there; as intervals that do not touch, in
// order. Boxes that are always there are left out: no departure helps against them.
//
// A curve that may be in a box from t1 to t2 after its begin meets a box that is there from `from`
// until `until` with the departures [from - t2, until - t1]. Where a box holds only a part of a
// curve, that is halved down to a hundredth of a second, or to a millionth of a segment of hours;
// all is rounded outward, so every departure that truly meets a box is in the answer. The answer is
// larger than need be in two ways: a box counts for the whole of a piece if it meets the bounding
// box of the piece's control points, and each interval is a microsecond longer.
//
// Trajectories within domain.h. Parked::pad: it stands at its ends for all time. Costs what lies
// near the curve.
std::vector<DepartureSpan> forbidden_by_map(const geom::CollisionScene& scene,
                                            const Trajectory& trajectory, Parked parked);

}  // namespace traj
