#include "geom/vehicle/limits.h"

#include <algorithm>

namespace geom {
namespace {

std::optional<double> smaller(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

}  // namespace

Limits stricter(const Limits& a, const Limits& b) {
  Limits out;
  for (const LimitKind& kind : kLimitKinds) out[kind.limit] = smaller(a[kind.limit], b[kind.limit]);
  return out;
}

std::optional<Limit> first_above(const Limits& a, const Limits& b) {
  for (const LimitKind& kind : kLimitKinds) {
    const auto& ours = a[kind.limit];
    const auto& theirs = b[kind.limit];
    if (ours && theirs && *ours > *theirs) return kind.limit;
  }
  return std::nullopt;
}

std::optional<Limit> first_looser(const Limits& a, const Limits& b) {
  for (const LimitKind& kind : kLimitKinds) {
    const auto& ours = a[kind.limit];
    const auto& theirs = b[kind.limit];
    if (theirs && !(ours && *ours <= *theirs)) return kind.limit;
  }
  return std::nullopt;
}

Limits limits_that_hold(const LimitSources& sources) {
  Limits out = stricter(sources.record, sources.vehicle);
  for (const LimitKind& kind : kLimitKinds) {
    const auto& asked = sources.options[kind.limit];
    std::optional<double>& held = out[kind.limit];
    if (asked) held = sources.overridden ? asked : smaller(asked, held);
  }
  out[Limit::tilt] = smaller(out[Limit::tilt], sources.vehicle[Limit::tilt]);
  return out;
}

}  // namespace geom
