#pragma once

// What a folder for an authority rests on and does not prove, in sentences for its summary.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "traj/submit/submission.h"

namespace traj {

bool has_kind(std::span<const FlightClaims> flights, std::string_view kind);

// m, the largest radius of their tubes; 0 without.
double widest_tube(std::span<const FlightClaims> flights);

std::vector<std::string> assumptions(const Submission& submission,
                                     std::span<const FlightClaims> flights);

}  // namespace traj
