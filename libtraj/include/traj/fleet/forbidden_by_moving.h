#pragma once

// When a flight must not depart, whatever other flights do: obstacles that move.
//
// Example:
//   traj::MovingBox crane{.box = {{0, 0, 0}, {9, 2, 3}}, .from = 60, .until = 120};
//   const auto spans = traj::forbidden_by_moving(trajectory, scene.half(), {{crane}},
//                                                traj::Parked::gone);
//   assert(spans[0][0].holds(60) && !spans[0][0].holds(130));

#include <span>
#include <vector>

#include "traj/curve/trajectory.h"
#include "traj/fleet/departure_span.h"
#include "traj/together/moving_box.h"
#include "traj/together/timed_flight.h"

namespace traj {

// Of each box all departures, in seconds after its epoch, with which there is an instant at which
// the flight's room, closed, touches the box while that is there; as intervals that do not touch,
// in order.
//
// The instants t after the departure and T after the epoch at which the two touch are a set in the
// plane of (t, T), and the departure is T - t. As the flight is cut into straight pieces, and a box
// goes and grows evenly, these are convex polygons (meeting_times.h). Rounded outward: every
// departure with a contact is in the answer. What is in it beyond that is what a box larger by 2 cm
// and 1e-11 of the coordinates on each side would forbid, a microsecond, and 1e-11 of the times.
//
// Trajectories within domain.h, boxes for which moving_box_fault() has no answer, room >= 0.
// Parked::pad: it stands at its ends for all time, so that an interval may be without a begin or an
// end. Costs what lies near the way of a box; the flight is cut once for all boxes.
std::vector<std::vector<DepartureSpan>> forbidden_by_moving(const Trajectory& trajectory,
                                                            const Vec3& room,
                                                            std::span<const MovingBox> boxes,
                                                            Parked parked);

}  // namespace traj
