#include "geom/vehicle/limits.h"

#include <algorithm>

namespace geom {
namespace {

using Limit = std::optional<double>;

Limit smaller(const Limit& a, const Limit& b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

}  // namespace

Limits stricter(const Limits& a, const Limits& b) {
  Limits out;
  for (const auto& [name, limit] : kLimitFields) out.*limit = smaller(a.*limit, b.*limit);
  return out;
}

const LimitField* first_above(const Limits& a, const Limits& b) {
  for (const LimitField& field : kLimitFields) {
    const Limit& ours = a.*field.member;
    const Limit& theirs = b.*field.member;
    if (ours && theirs && *ours > *theirs) return &field;
  }
  return nullptr;
}

const LimitField* first_looser(const Limits& a, const Limits& b) {
  for (const LimitField& field : kLimitFields) {
    const Limit& ours = a.*field.member;
    const Limit& theirs = b.*field.member;
    if (theirs && !(ours && *ours <= *theirs)) return &field;
  }
  return nullptr;
}

Limits limits_that_hold(const LimitSources& sources) {
  Limits out = stricter(sources.record, sources.vehicle);
  for (const auto& [name, limit] : kLimitFields) {
    const Limit& asked = sources.options.*limit;
    if (asked) out.*limit = sources.overridden ? asked : smaller(asked, out.*limit);
  }
  out.tilt = smaller(out.tilt, sources.vehicle.tilt);
  return out;
}

}  // namespace geom
