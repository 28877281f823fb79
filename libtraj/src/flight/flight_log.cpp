#include "traj/flight/flight_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <optional>
#include <ostream>
#include <set>

#include "geom/base/error.h"
#include "geom/record/axes_comment.h"
#include "geom/text/csv_field.h"
#include "geom/text/number.h"
#include "geom/text/text_table.h"

namespace traj {
namespace {

using Columns = std::array<std::string_view, 30>;

constexpr Columns kColumns = {"id",
                              "t_s",
                              "east_m",
                              "north_m",
                              "up_m",
                              "v_east_mps",
                              "v_north_mps",
                              "v_up_mps",
                              "qw",
                              "qx",
                              "qy",
                              "qz",
                              "p_radps",
                              "q_radps",
                              "r_radps",
                              "setpoint_east_m",
                              "setpoint_north_m",
                              "setpoint_up_m",
                              "setpoint_v_east_mps",
                              "setpoint_v_north_mps",
                              "setpoint_v_up_mps",
                              "setpoint_yaw_rad",
                              "motor1",
                              "motor2",
                              "motor3",
                              "motor4",
                              "saturated",
                              "map",
                              "battery_share",
                              "end"};

constexpr std::size_t kUsual = kColumns.size() - 2;  // without battery and end
constexpr std::size_t kMap = kUsual - 1;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string header(std::size_t columns = kUsual) {
  return fmt::format("{}", fmt::join(kColumns.begin(), kColumns.begin() + columns, ","));
}

// How many columns a log with this header has; nothing for another header.
std::optional<std::size_t> columns_of(std::string_view line) {
  if (line == header()) return kUsual;
  if (line == header(kColumns.size())) return kColumns.size();
  return std::nullopt;
}

// A text as a field that comes back.
std::string field(const char* what, const std::string& id) {
  const auto at_end = [](char c) { return c == ' ' || c == '\t'; };
  if (id.find_first_of("\r\n") != std::string::npos || id.starts_with("\xef\xbb\xbf") ||
      (!id.empty() && (at_end(id.front()) || at_end(id.back())))) {
    throw geom::InputError(
        "flight log",
        {.says = fmt::format("{} must have no line break and no white space at its ends", what),
         .found = geom::in_quotes(id)});
  }
  return geom::csv_field(id);
}

void append(std::string& text, double value) {
  text += ',';
  if (!std::isnan(value)) geom::append_number(text, value);
}

void append_row(std::string& text, const std::string& id, const FlightSample& s,
                const std::string& map) {
  text += id;
  const auto append = [&](double value) { traj::append(text, value); };
  append(s.time);
  for (const geom::Vec3* v : {&s.position, &s.velocity})
    std::for_each(v->begin(), v->end(), append);
  for (const double q : {s.attitude.w(), s.attitude.x(), s.attitude.y(), s.attitude.z()}) append(q);
  for (const geom::Vec3* v : {&s.body_rates, &s.setpoint_position, &s.setpoint_velocity}) {
    std::for_each(v->begin(), v->end(), append);
  }
  append(s.setpoint_yaw);
  std::for_each(s.motors.begin(), s.motors.end(), append);
  text += std::isnan(s.motors[0]) ? ",," : s.saturated ? ",1," : ",0,";
  text += map;
}

// In the rows of a file that has them.
void append_end(std::string& text, const FlightSample& s, bool last_of_cut) {
  append(text, s.battery);
  text += last_of_cut ? ",cut" : ",";
}

bool has_end(const FlightLog& log) {
  return log.cut || std::any_of(log.samples.begin(), log.samples.end(),
                                [](const FlightSample& s) { return !std::isnan(s.battery); });
}

void write_rows(std::ostream& out, const FlightLog& log, bool with_end) {
  const std::string id = field("an id", log.id);
  std::string map = field("a map", log.map);
  std::string text;
  for (const FlightSample& sample : log.samples) {
    append_row(text, id, sample, map);
    if (with_end) append_end(text, sample, log.cut && &sample == &log.samples.back());
    text += '\n';
    map.clear();
    if (text.size() > 1u << 16) {
      out << text;
      text.clear();
    }
  }
  out << text;
}

// The fields of one row, taken in order.
class Row {
 public:
  Row(const geom::TextLines& lines, std::size_t columns)
      : lines_(lines), fields_(geom::split_fields(lines.line(), true)) {
    if (fields_.size() != columns) {
      lines.refuse({.expected = fmt::format("{} columns", columns),
                    .found = fmt::to_string(fields_.size())});
    }
  }

  const std::string& id() const { return fields_[0]; }
  const std::string& map() const { return fields_[kMap]; }

  // How the flight ends with this row: "" or "cut".
  bool cut() const {
    if (fields_.size() < kColumns.size() || fields_.back().empty()) return false;
    if (fields_.back() != "cut") {
      lines_.refuse({.key = "end",
                     .expected = "cut or empty",
                     .found = geom::in_quotes(fields_.back().substr(0, 40))});
    }
    return true;
  }

  double battery() {
    if (fields_.size() < kColumns.size()) return kUnknown;
    at_ = kUsual;
    return known(1) ? number(0, 1) : kUnknown;
  }

  // Whether the next `count` fields, of one thing, are there; passes over them where they are not.
  bool known(std::size_t count) {
    const auto first = fields_.begin() + static_cast<std::ptrdiff_t>(at_);
    if (!std::all_of(first, first + static_cast<std::ptrdiff_t>(count),
                     [](const std::string& text) { return text.empty(); })) {
      return true;
    }
    at_ += count;
    return false;
  }

  double number(double least, double most) {
    const auto value = geom::parse_number(fields_[at_]);
    if (!value || !(*value >= least && *value <= most)) {
      lines_.refuse({.key = std::string(kColumns[at_]),
                     .expected = fmt::format("a number from {} to {}", least, most),
                     .found = geom::in_quotes(fields_[at_].substr(0, 40))});
    }
    ++at_;
    return *value;
  }

  geom::Vec3 vector() {
    constexpr double most = geom::kLargestCoordinate;
    const double x = number(-most, most);
    const double y = number(-most, most);
    return {x, y, number(-most, most)};
  }

 private:
  const geom::TextLines& lines_;
  std::vector<std::string> fields_;
  std::size_t at_ = 1;
};

Eigen::Quaterniond parse_attitude(Row& row, const geom::TextLines& lines) {
  Eigen::Quaterniond attitude;
  for (double* q : {&attitude.w(), &attitude.x(), &attitude.y(), &attitude.z()}) {
    *q = row.number(-1.1, 1.1);
  }
  if (std::abs(attitude.norm() - 1) > 1e-6) {
    lines.refuse({.key = "qw, qx, qy, qz",
                  .expected = "a quaternion of length 1",
                  .found = fmt::format("length {}", attitude.norm())});
  }
  return attitude;
}

void parse_motors(Row& row, const geom::TextLines& lines, FlightSample& s) {
  for (double& motor : s.motors) motor = row.number(0, 1);
  const double saturated = row.number(0, 1);
  if (saturated != 0 && saturated != 1) {
    lines.refuse({.key = "saturated", .expected = "0 or 1", .found = fmt::to_string(saturated)});
  }
  s.saturated = saturated == 1;
}

FlightSample parse(Row& row, const geom::TextLines& lines) {
  FlightSample s = nothing_known();
  s.time = row.number(0, 1e9);
  s.position = row.vector();
  if (row.known(3)) s.velocity = row.vector();
  if (row.known(4)) s.attitude = parse_attitude(row, lines);
  if (row.known(3)) s.body_rates = row.vector();
  if (row.known(3)) s.setpoint_position = row.vector();
  if (row.known(3)) s.setpoint_velocity = row.vector();
  if (row.known(1))
    s.setpoint_yaw = row.number(-geom::kLargestCoordinate, geom::kLargestCoordinate);
  if (row.known(5)) parse_motors(row, lines, s);
  s.battery = row.battery();
  return s;
}

// The first line behind comments, which may name no axes but those of the header.
bool next_no_comment(geom::TextLines& lines) {
  while (lines.next()) {
    if (!lines.line().starts_with('#')) return true;
    const auto named = geom::axes_of_comment(lines.line());
    if (!named || (named->axes == geom::Axes::enu && !named->downwards)) continue;
    lines.refuse(
        geom::not_these_axes(lines.line(), "east, north and up, as the header names them"));
  }
  return false;
}

}  // namespace

FlightSample nothing_known() {
  FlightSample out;
  const geom::Vec3 none = geom::Vec3::Constant(kUnknown);
  out.velocity = out.body_rates = out.setpoint_position = out.setpoint_velocity = none;
  out.attitude.coeffs().setConstant(kUnknown);
  out.setpoint_yaw = kUnknown;
  out.motors.fill(kUnknown);
  return out;
}

bool is_known(const geom::Vec3& v) { return !v.array().isNaN().any(); }

void write_flight_log_header(std::ostream& out) { out << header() << '\n'; }

void write_flight(std::ostream& out, const FlightLog& log) { write_rows(out, log, false); }

void write_flight_log(std::ostream& out, std::span<const FlightLog> logs) {
  const bool with_end = std::any_of(logs.begin(), logs.end(), has_end);
  out << header(with_end ? kColumns.size() : kUsual) << '\n';
  for (const FlightLog& log : logs) write_rows(out, log, with_end);
}

std::vector<FlightLog> read_flight_log(std::istream& in, std::string_view name) {
  geom::TextLines lines(in, name, true);
  const auto columns = next_no_comment(lines) ? columns_of(lines.line()) : std::nullopt;
  if (!columns) {
    lines.refuse({.expected = fmt::format("the header {}", header()),
                  .found = geom::in_quotes(lines.line().substr(0, 80))});
  }
  std::vector<FlightLog> logs;
  std::set<std::string> known;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    Row row(lines, *columns);
    if (logs.empty() || logs.back().id != row.id()) {
      if (!known.insert(row.id()).second) {
        lines.refuse(
            {.says = fmt::format("the rows of a flight must stand together; \"{}\" was left before",
                                 row.id())});
      }
      logs.push_back({row.id(), row.map(), {}, false});
    } else if (logs.back().cut) {
      lines.refuse({.says = "the flight ended in the row before, by its column end"});
    } else if (!row.map().empty()) {
      lines.refuse({.says = "the map must stand in the first row of a flight",
                    .found = geom::in_quotes(row.map().substr(0, 80))});
    }
    std::vector<FlightSample>& samples = logs.back().samples;
    const FlightSample sample = parse(row, lines);
    if (!samples.empty() && sample.time <= samples.back().time) {
      lines.refuse({.says = "t_s must grow",
                    .found = fmt::format("{} after {}", sample.time, samples.back().time)});
    }
    samples.push_back(sample);
    logs.back().cut = row.cut();
  }
  if (logs.empty())
    lines.refuse({.expected = "at least one row after the header", .found = "none"});
  return logs;
}

}  // namespace traj
