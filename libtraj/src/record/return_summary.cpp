#include "traj/record/return_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"

namespace traj {
namespace {

constexpr double kRounding = 1e-9;  // of a share, and of a time over the flight's

double at_least_zero(const geom::JsonFields& fields, const char* key) {
  const double value = fields.number(fields.value(key), key);
  if (value >= 0) return value;
  fields.refuse({.key = key, .expected = ">= 0", .found = fmt::to_string(value)});
}

std::optional<std::uint64_t> count(const geom::JsonFields& fields, const char* key) {
  if (!fields.has(key)) return std::nullopt;
  const nlohmann::json& value = fields.value(key);
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  fields.refuse({.key = key, .expected = "a whole number >= 0", .found = value.dump()});
}

ReturnGapSummary gap_of(const geom::JsonFields& fields) {
  ReturnGapSummary gap;
  gap.from = at_least_zero(fields, "from");
  gap.until = at_least_zero(fields, "until");
  gap.item = count(fields, "item");
  gap.part = fields.text("part", "");
  gap.autopilot = fields.text("autopilot", "");
  gap.phase = fields.text("phase");
  gap.reason = fields.text("reason");
  if (fields.has("at")) gap.place = fields.point("at");
  gap.box = count(fields, "box");
  gap.fence = count(fields, "fence");
  return gap;
}

// The time that gaps leave, of the flight's.
double share_without(const std::vector<ReturnGapSummary>& gaps, double duration) {
  if (!(duration > 0)) return gaps.empty() ? 1 : 0;
  double without = 0;
  for (const ReturnGapSummary& gap : gaps) without += gap.until - gap.from;
  return std::clamp(1 - without / duration, 0.0, 1.0);
}

void require_ascending(const geom::JsonFields& fields, const ReturnSummary& out) {
  double before = 0;
  for (const ReturnGapSummary& gap : out.gaps) {
    if (gap.from >= before && gap.until >= gap.from &&
        gap.until <= out.duration * (1 + kRounding)) {
      before = gap.until;
      continue;
    }
    fields.refuse(
        {.key = "gaps",
         .expected = fmt::format("apart, ascending and within 0 to {} s", out.duration),
         .found = fmt::format("one from {} to {} s after {} s", gap.from, gap.until, before)});
  }
}

void require_ascending_timeline(const geom::JsonFields& fields, const ReturnSummary& out) {
  double before = 0;
  for (const TimedPlace& one : out.timeline) {
    if (one.time < before || one.time > out.duration * (1 + kRounding)) {
      fields.refuse({.key = "timeline",
                     .expected = fmt::format("ascending, within 0 to {} s", out.duration),
                     .found = fmt::format("{} s after {} s", one.time, before)});
    }
    before = one.time;
  }
}

}  // namespace

ReturnSummary parse_return_summary(std::string_view json, std::string_view source,
                                   std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  const auto for_each = [&](const char* key, const auto& read) {
    const nlohmann::json& list = fields.value(key);
    if (!list.is_array()) fields.refuse({.key = key, .expected = "a list", .found = list.dump()});
    for (const nlohmann::json& one : list) read(geom::JsonFields(one.dump(), source, line));
  };
  ReturnSummary out;
  out.action = fields.text("action");
  out.autopilot = fields.text("autopilot", "");
  if (fields.has("home")) out.home = fields.point("home");
  out.height = fields.number("height").value_or(0);
  out.duration = at_least_zero(fields, "duration");
  out.longest = fields.number("longest").value_or(0);
  out.least_height = fields.number("least_height");
  out.best_height = fields.number("best_height");
  out.best_share = fields.number("best_share");
  for_each("gaps", [&](const geom::JsonFields& gap) { out.gaps.push_back(gap_of(gap)); });
  require_ascending(fields, out);
  if (fields.has("timeline")) {
    for_each("timeline", [&](const geom::JsonFields& one) {
      out.timeline.push_back({at_least_zero(one, "time"), one.point("at")});
    });
    require_ascending_timeline(fields, out);
  }
  out.share = at_least_zero(fields, "share");
  const double left = share_without(out.gaps, out.duration);
  if (out.share <= left + kRounding) return out;
  fields.refuse({.key = "share",
                 .expected = fmt::format("at most {:.6g}, as the gaps leave it", left),
                 .found = fmt::to_string(out.share)});
}

}  // namespace traj
