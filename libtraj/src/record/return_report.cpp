#include "traj/record/return_report.h"

#include <algorithm>

namespace traj {

double ReturnReport::share() const {
  if (!(duration > 0)) return ok() ? 1 : 0;
  double without = 0;
  for (const ReturnGap& gap : gaps) without += gap.until - gap.from;
  return std::clamp(1 - without / duration, 0.0, 1.0);
}

}  // namespace traj
