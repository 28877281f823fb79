#pragma once

// Limits as polynomials that must not be negative, in whole numbers.

#include <span>
#include <utility>
#include <vector>

#include "gmp_judge.h"

namespace traj::exact {

// Polynomials that must all be >= 0.
struct Conditions {
  std::vector<Polynomial> all;
};

std::pair<Conditions, Conditions> halves(const Conditions& conditions);

// By the coefficients; fails where a polynomial is negative at an end.
Verdict not_negative(const Conditions& conditions, std::size_t number);

// Coefficients along one axis of the derivative of that order, times duration^order, in 2^-1074.
Polynomial derivative(const Segment& s, int axis, int order);

// limit^2 - |derivative along these axes|^2, times a positive number.
Conditions norm_condition(const Segment& s, int order, double limit, std::span<const int> axes);

// A fraction <= tan(angle) within 2^-60 of it, by 2^64. The angle is from 0 to below pi/2.
Whole tangent_below(double angle);

// The thrust a + g within a cone around up: its height z >= 0 and (z tan)^2 - x^2 - y^2 >= 0, each
// times a positive number. `tangent`: tangent_below() the limit.
Conditions tilt_condition(const Segment& s, const Whole& tangent);

// limit^2 - |a + g|^2, times a positive number.
Conditions thrust_condition(const Segment& s, double limit);

// (limit |f|^2)^2 - |j x f|^2 with f = a + g and j the jerk, times a positive number.
Conditions body_rate_condition(const Segment& s, double limit);

// limit^2 - (yaw's derivative)^2, times a positive number. The segment has a yaw.
Conditions yaw_rate_condition(const Segment& s, double limit);

}  // namespace traj::exact
