#pragma once

// A band over time, filled where there is a way home and hollow where there is none.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapes.h"
#include "traj/record/return_summary.h"

namespace traj::figure {

using TimeSpans = std::vector<std::pair<double, double>>;  // s; ascending, apart

// What lies between them, from 0 to `duration`; of no spans all of it, even if that is an instant.
TimeSpans without(const TimeSpans& spans, double duration);
// The part of 0 to `duration` that they hold; of no duration 1 or, where there is a span, 0.
double share_without(const TimeSpans& spans, double duration);

TimeSpans spans_of(const ReturnSummary& returns);

// "40.4 %"; never "100.0 %" of what is not whole.
std::string percent(double share);

struct HomeBand {
  double top = 0;  // pixels
  double height = 14;
  std::string_view fill;
  TimeSpans gaps;       // where it is hollow
  double duration = 0;  // s
  int first = 0;        // the number of the first gap, as the words below have it; 0: none
};

// x of the frame is the time.
void draw_band(Svg& svg, const Frame& frame, const HomeBand& band);

// What filled and hollow bands mean, from x on.
void draw_band_key(Svg& svg, Point at, bool returns, bool ways);

inline constexpr std::string_view kReturnFill = "#009e73";
inline constexpr std::string_view kWayFill = "#0072b2";

}  // namespace traj::figure
