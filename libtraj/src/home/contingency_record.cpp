#include "traj/home/contingency_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/record/path_status.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

double required_time(const geom::JsonFields& fields, const char* key) {
  const double value = fields.number(fields.value(key), key);
  if (std::abs(value) <= kLongestTrajectory && value >= 0) return value;
  fields.refuse({.key = key, .expected = "seconds from 0 to 1e9", .found = fmt::to_string(value)});
}

std::optional<double> at_least_zero(const geom::JsonFields& fields, const char* key) {
  const auto value = fields.number(key);
  if (value && *value < 0) {
    fields.refuse({.key = key, .expected = ">= 0", .found = fmt::to_string(*value)});
  }
  return value;
}

void read_way(const geom::JsonFields& fields, ContingencyRecord& record) {
  record.site = fields.text("site");
  record.points = fields.points("points");
  if (record.points.size() < 2) {
    fields.refuse({.key = "points",
                   .expected = "at least two: above the site, and on its ground",
                   .found = fmt::to_string(record.points.size())});
  }
  record.length = at_least_zero(fields, "length");
  record.duration = at_least_zero(fields, "duration");
  record.bounds_energy = fields.object().contains("latest_departure");
  record.latest_departure = fields.number("latest_departure");
  if (record.latest_departure &&
      !(*record.latest_departure >= record.from && *record.latest_departure <= record.until)) {
    fields.refuse({.key = "latest_departure",
                   .expected = "between from and until",
                   .found = fmt::to_string(*record.latest_departure)});
  }
}

}  // namespace

std::string to_json_line(const ContingencyRecord& record) {
  const auto status = record.found() ? geom::PathStatus::found : geom::PathStatus::unreachable;
  geom::JsonLine line;
  line.add("type", "contingency").add("id", record.id).add("status", name(status));
  if (!record.flight_hash.empty()) line.add("flight_hash", record.flight_hash);
  line.add("from", record.from).add("until", record.until);
  if (!record.autopilot.empty()) line.add("autopilot", record.autopilot);
  add(line, record.provenance);
  if (!record.message.empty()) line.add("message", record.message);
  if (!record.found()) return line.line();
  line.add("site", record.site).add("length", record.length).add("duration", record.duration);
  if (record.bounds_energy) {
    record.latest_departure ? line.add("latest_departure", *record.latest_departure)
                            : line.add("latest_departure", nullptr);
  }
  return line.add("points", record.points).line();
}

ContingencyRecord parse_contingency_record(std::string_view json, std::string_view source,
                                           std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  fields.require_type("contingency");
  ContingencyRecord record;
  record.id = fields.text("id");
  record.from = required_time(fields, "from");
  record.until = required_time(fields, "until");
  if (record.until < record.from) {
    fields.refuse({.key = "until",
                   .expected = fmt::format(">= {}, from", record.from),
                   .found = fmt::to_string(record.until)});
  }
  record.autopilot = fields.text("autopilot", "");
  record.message = fields.text("message", "");
  record.flight_hash = fields.text("flight_hash", "");
  record.provenance = geom::read_provenance(fields);
  const auto status = fields.word("status", geom::kPathStatusWords, geom::PathStatus::found);
  if (status == geom::PathStatus::found) read_way(fields, record);
  return record;
}

std::vector<ContingencyRecord> contingency_records(const std::string& id, const WaysHome& home,
                                                   const WaysTask& task,
                                                   const geom::Provenance& provenance,
                                                   const std::string& flight_hash) {
  std::string autopilots;
  for (const ReturnModel& model : task.models) {
    autopilots += (autopilots.empty() ? "" : ", ") + model.autopilot;
  }
  std::vector<ContingencyRecord> out;
  const auto add = [&](double from, double until) -> ContingencyRecord& {
    ContingencyRecord record{.id = id, .from = from, .until = until};
    record.autopilot = autopilots;
    record.provenance = provenance;
    record.flight_hash = flight_hash;
    out.push_back(std::move(record));
    return out.back();
  };
  for (const WayHome& way : home.ways) {
    ContingencyRecord& record = add(way.from, way.until);
    record.site = task.sites[way.site].id;
    record.points = way.points;
    record.length = way.length;
    record.duration = way.duration;
    record.bounds_energy = task.energy.has_value();
    record.latest_departure = way.latest_departure;
  }
  for (const WayGap& gap : home.gaps) {
    add(gap.from, gap.until).message =
        fmt::format("no way home was found from near ({:.2f}, {:.2f}, {:.2f})", gap.place.x(),
                    gap.place.y(), gap.place.z());
  }
  std::stable_sort(
      out.begin(), out.end(),
      [](const ContingencyRecord& a, const ContingencyRecord& b) { return a.from < b.from; });
  return out;
}

void require_of_flight(std::string_view id, std::string_view flight_hash,
                       const std::vector<std::string>& flights, std::string_view source,
                       std::size_t line) {
  const auto may_be = [&](const std::string& flight) {
    return flight.empty() || flight == flight_hash;
  };
  if (flight_hash.empty() || flights.empty() ||
      std::any_of(flights.begin(), flights.end(), may_be)) {
    return;
  }
  throw geom::InputError(
      source, line,
      {.expected = fmt::format("ways home of the flight {} that is given", geom::in_quotes(id)),
       .found = "ones of another flight with this id",
       .advice = "plan them anew for this flight (skyway-plan --home)"});
}

}  // namespace traj
