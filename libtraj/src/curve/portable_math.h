#pragma once

// Elementary functions from + - * / and square roots alone: the same bits on every x86-64, which
// the C library's (chosen by processor at run time) are not.

namespace traj {

// The cube root of x >= 0, to a few ulp.
double cube_root(double x);

// Just below tan(angle), by a relative 1e-12; 0 <= angle < pi/2.
double tangent_below(double angle);

inline constexpr double kPi = 3.141592653589793;

// The angle of (x, y), not both 0, from the x axis towards the y axis: within (-pi, pi], to a few
// ulp of pi.
double angle_of(double x, double y);

}  // namespace traj
