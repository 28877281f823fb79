#pragma once

// What the examples of the public headers are about: a city, a vehicle, a path and a flight in it.

#include <cassert>
#include <fstream>
#include <iostream>
#include <sstream>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"

// A room of 10 m with a block in its middle, a Tello with 0.2 m of margin, and a flight past the
// block from (1, 1, 1) to (9, 1, 1), within the limits.
struct Given {
  geom::BoxMap map;
  geom::Vehicle vehicle;
  geom::Limits limits;
  geom::CollisionScene scene;
  geom::Polyline path;
  traj::Trajectory trajectory;
};
