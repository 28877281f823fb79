#include "geom/record/search_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

using Json = nlohmann::json;

// The member of that name; null if there is none.
const Json& member(const Json& object, const char* key) {
  static const Json kNone;
  const auto at = object.find(key);
  return at == object.end() ? kNone : *at;
}

std::optional<std::size_t> count_in(const Json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  return value.get<std::size_t>();
}

std::optional<double> number_in(const Json& value) {
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

bool is_numbers(const Json& list, std::size_t count) {
  return list.is_array() && list.size() == count &&
         std::all_of(list.begin(), list.end(), [](const Json& v) { return v.is_number(); });
}

std::optional<Vec3> point_in(const Json& value) {
  if (!is_numbers(value, 3)) return std::nullopt;
  return Vec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

std::optional<PathStep> step_in(const Json& value) {
  if (!value.is_object() || !member(value, "step").is_string()) return std::nullopt;
  return PathStep{.name = value["step"],
                  .points = count_in(member(value, "points")).value_or(0),
                  .length = number_in(member(value, "length")).value_or(0)};
}

}  // namespace

JsonLine json_of(const SearchReport& report) {
  JsonLine line;
  if (!report.method.empty()) line.add("method", report.method);
  line.add("expanded", report.expanded).add("resolution", report.resolution);
  if (!report.steps.empty()) {
    line.add("steps", report.steps, [](const PathStep& s) {
      return JsonLine().add("step", s.name).add("points", s.points).add("length", s.length);
    });
  }
  line.add("layer", report.layer);
  return line.add("snapped_start", report.snapped_start).add("snapped_goal", report.snapped_goal);
}

std::optional<SearchReport> read_search_report(const JsonFields& record) {
  const Json& json = member(record.object(), "search");
  if (!json.is_object()) return std::nullopt;
  SearchReport report;
  if (const Json& method = member(json, "method"); method.is_string()) report.method = method;
  report.expanded = count_in(member(json, "expanded"));
  report.resolution = number_in(member(json, "resolution"));
  if (const Json& steps = member(json, "steps"); steps.is_array()) {
    for (const Json& value : steps) {
      if (auto step = step_in(value)) report.steps.push_back(std::move(*step));
    }
  }
  if (const Json& layer = member(json, "layer"); is_numbers(layer, 2)) {
    report.layer = {layer[0].get<double>(), layer[1].get<double>()};
  }
  report.snapped_start = point_in(member(json, "snapped_start"));
  report.snapped_goal = point_in(member(json, "snapped_goal"));
  return report;
}

}  // namespace geom
