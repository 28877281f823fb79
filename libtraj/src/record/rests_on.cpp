#include "record/rests_on.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/text/counted.h"
#include "geom/text/parse_json.h"
#include "geom/text/rounded.h"
#include "record/fault_verdict.h"

namespace traj {
namespace {

using geom::JsonFields;
using Json = nlohmann::json;

std::string allowance(std::string_view of, const std::array<double, 2>& metres) {
  return fmt::format("{} of {:.4g} m across and {:.4g} m up or down", of, metres[0], metres[1]);
}

// The autopilots that a drone file was looked at for, and what was taken for the vehicle's errors.
void add_flown(const RestsOn& rests, std::vector<std::string>& out) {
  if (!rests.autopilot.empty()) out.push_back("as flown by " + rests.autopilot);
  if (rests.assumed) {
    out.push_back(fmt::format("{} not given and assumed",
                              geom::counted(rests.assumed, "parameter", "parameters")));
  }
  std::vector<std::string> errors;
  if (rests.navigation) {
    errors.push_back(allowance("an error of its own place", *rests.navigation));
  }
  if (rests.tracking) errors.push_back(allowance("straying", *rests.tracking));
  if (!errors.empty()) {
    out.push_back(fmt::format("allowed for {}", fmt::join(errors, ", and ")));
  }
}

std::string allowed_in_words(const RestsOn::Returns& returns) {
  std::string out = fmt::format("{} is clear from every instant as {} flies it", returns.action,
                                returns.autopilot);
  if (returns.least_height) {
    out += fmt::format(" (at {:.4g} m above home; {:.4g} m would do)", returns.height,
                       geom::rounded_up(*returns.least_height));
  }
  return out + ", if the battery lasts";
}

const Json& list(const JsonFields& fields, const char* key) {
  const Json& value = fields.value(key);
  if (!value.is_array()) {
    fields.refuse({.key = key, .expected = "a list", .found = geom::shown(value)});
  }
  return value;
}

std::vector<std::string> words(const JsonFields& fields, const char* key) {
  std::vector<std::string> out;
  if (!fields.has(key)) return out;
  for (const Json& one : list(fields, key)) {
    if (!one.is_string()) {
      fields.refuse({.key = key, .expected = "a list of words", .found = geom::shown(one)});
    }
    out.push_back(one.get<std::string>());
  }
  return out;
}

std::optional<std::array<double, 2>> metres(const JsonFields& fields, const char* key) {
  if (!fields.has(key)) return std::nullopt;
  const Json& pair = list(fields, key);
  if (pair.size() != 2) {
    fields.refuse({.key = key, .expected = "two numbers", .found = geom::shown(pair)});
  }
  return std::array{fields.number(pair[0], key), fields.number(pair[1], key)};
}

// What a yes says that no proof stands behind.
std::string sampled_or_simulated(const JsonFields& fields) {
  if (fields.text("type", "") == "flight") {
    return fields.has("clear") ? "one simulated flight, not a proof"
                               : "one simulated flight, not a proof, and not held against a map";
  }
  if (fields.text("timed_boxes", "") == "by_time") {
    return "boxes with a time count at the times of this start";
  }
  if (!fields.has("verdict")) return "";
  const auto step = fields.number("longest_step");
  return "at the samples of a log and straight between them: what the vehicle did between, up to " +
         (step ? fmt::format("{:.3g} s", *step) : std::string("an unknown time")) +
         ", was not measured";
}

TubeClaim tube_of(const JsonFields& fields, std::string_view source, std::size_t line) {
  Json claim = fields.value("tube");
  if (!claim.is_object()) {
    fields.refuse({.key = "tube", .expected = "an object", .found = geom::shown(claim)});
  }
  for (const char* verdict : {"margin", "clear", "reason"}) claim.erase(verdict);
  return read_tube_claim(JsonFields(claim.dump(), source, line));
}

}  // namespace

RestsOn rests_on(const ReportRecord& report) {
  RestsOn out;
  if (report.checked == kCheckedContingency) return {.first = report.detail};
  out.exact = report.exact.has_value();
  out.autopilot = report.autopilot;
  out.assumed = report.assumed.size();
  out.navigation = report.navigation;
  out.tracking = report.tracking;
  if (const auto& r = report.returns) {
    out.returns = {r->action, r->autopilot, r->height, r->least_height};
  }
  if (report.tube) out.tube = report.tube->claim;
  for (const Limit limit : not_measured(report.result, report.limits)) {
    out.not_measured.emplace_back(kind_of(limit).quantity);
  }
  out.overridden = report.overridden;
  return out;
}

RestsOn read_rests_on(const JsonFields& fields, std::string_view source, std::size_t line) {
  RestsOn out;
  if (fields.text("checked", "") == kCheckedContingency)
    return {.first = fields.text("detail", "")};
  out.first = sampled_or_simulated(fields);
  out.exact = fields.has("exact");
  out.autopilot = fields.text("autopilot", "");
  out.assumed = words(fields, "assumed").size();
  out.navigation = metres(fields, "navigation");
  out.tracking = metres(fields, "tracking");
  if (fields.has("tube")) out.tube = tube_of(fields, source, line);
  out.not_measured = words(fields, "not_measured");
  out.overridden = words(fields, "overridden");
  return out;
}

std::string in_words(const RestsOn& rests) {
  std::vector<std::string> out;
  if (!rests.first.empty()) out.push_back(rests.first);
  if (rests.exact) out.emplace_back("proved again in exact numbers");
  add_flown(rests, out);
  if (rests.returns) out.push_back(allowed_in_words(*rests.returns));
  if (rests.tube) {
    const bool proved = rests.tube->kind == TubeKind::proved;
    out.push_back(fmt::format("clear with {}{}", in_words(*rests.tube),
                              proved ? ", as its report says, which was not proved again" : ""));
  }
  std::vector<std::string> missing;
  for (const std::string& quantity : rests.not_measured) missing.push_back(spoken(quantity));
  if (!missing.empty()) out.push_back(fmt::format("not measured: {}", fmt::join(missing, ", ")));
  if (rests.overridden == std::vector<std::string>{"map"}) {
    out.emplace_back("the log does not say its map, and was taken for this one (--override)");
  } else if (!rests.overridden.empty()) {
    out.push_back(fmt::format("looser than its record says (--override or --spare): {}",
                              fmt::join(rests.overridden, ", ")));
  }
  return fmt::format("{}", fmt::join(out, "; "));
}

}  // namespace traj
