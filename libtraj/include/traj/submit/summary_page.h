#pragma once

// The summary of a folder for an authority, as one HTML page that prints well.
//
// Example:
//   traj::Operation operation{.by = {"Ann Air", "AUT123"}, .lost_link = "returns and lands"};
//   traj::Submission submission{.made_by = "skyway 0.1", .flights = 1};
//   const std::string html = traj::summary_page(operation, submission, {});
//   assert(html.find("Ann Air") != std::string::npos);

#include <span>
#include <string>

#include "traj/submit/operation.h"
#include "traj/submit/submission.h"

namespace traj {

// The page lists so many flights at most. It prefers those with the most people below, then those
// with the least clearance.
inline constexpr std::size_t kMostRows = 100;

// Says who flies, what is proved, what was assumed, the formulas with their numbers, the flights,
// and how to follow the proofs. It needs no other file and no network.
std::string summary_page(const Operation& operation, const Submission& submission,
                         std::span<const FlightClaims> flights);

}  // namespace traj
