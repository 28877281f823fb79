#include "traj/mission/formats/setpoints.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <numbers>
#include <ostream>
#include <string>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/base/usage_error.h"
#include "geom/text/beginning.h"
#include "geom/text/number.h"
#include "mission/formats/text_head.h"
#include "traj/curve/yaw.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

constexpr std::string_view kEnuHeader =
    "t_s,east_m,north_m,up_m,v_east_m_s,v_north_m_s,v_up_m_s,a_east_m_s2,a_north_m_s2,a_up_m_s2,"
    "yaw_rad,yaw_rate_rad_s";
constexpr std::string_view kNedHeader =
    "t_s,n_m,e_m,d_m,vn_m_s,ve_m_s,vd_m_s,an_m_s2,ae_m_s2,ad_m_s2,yaw_rad,yaw_rate_rad_s";
constexpr std::string_view kUnchecked = ",unchecked";  // one more column, of 1 in each row
constexpr std::size_t kColumns = 12;
using Row = std::array<double, kColumns>;

// East, north, up as north, east, down; its own inverse. A yaw likewise.
Vec3 swapped(const Vec3& v) { return {v.y(), v.x(), -v.z()}; }

Setpoint swapped(Setpoint s) {
  for (Vec3* v : {&s.state.position, &s.state.velocity, &s.state.acceleration}) *v = swapped(*v);
  s.yaw = std::numbers::pi / 2 - s.yaw;
  s.yaw_rate = -s.yaw_rate;
  return s;
}

Row row_of(const Setpoint& s) {
  const Vec3& p = s.state.position;
  const Vec3& v = s.state.velocity;
  const Vec3& a = s.state.acceleration;
  return {s.time, p[0], p[1], p[2], v[0], v[1], v[2], a[0], a[1], a[2], s.yaw, s.yaw_rate};
}

Setpoint setpoint_of(const Row& row) {
  Setpoint s;
  s.time = row[0];
  s.state.position = {row[1], row[2], row[3]};
  s.state.velocity = {row[4], row[5], row[6]};
  s.state.acceleration = {row[7], row[8], row[9]};
  s.yaw = row[10];
  s.yaw_rate = row[11];
  return s;
}

Row parse_row(std::string_view text, std::size_t columns, std::string_view source,
              std::size_t line) {
  Row row;
  std::size_t count = 0;
  for (std::size_t at = 0; at <= text.size(); ++count) {
    const std::size_t stop = std::min(text.find(',', at), text.size());
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data() + at, text.data() + stop, value);
    if (error != std::errc() || rest != text.data() + stop ||
        !(std::abs(value) <= geom::kLargestCoordinate)) {
      throw geom::InputError(source, line,
                             {.key = fmt::format("column {}", count + 1),
                              .expected = "a number within 1e8",
                              .found = geom::in_quotes(text.substr(at, stop - at))});
    }
    if (count < kColumns) row[count] = value;
    at = stop + 1;
  }
  if (count != columns) {
    throw geom::InputError(
        source, line,
        {.expected = fmt::format("{} columns", columns), .found = fmt::to_string(count)});
  }
  return row;
}

SetpointAxes axes_of_header(std::string_view text, std::string_view source) {
  if (text == kEnuHeader) return SetpointAxes::enu;
  if (text == kNedHeader) return SetpointAxes::ned;
  throw geom::InputError(source, 1,
                         {.expected = fmt::format("the header {} or {}", kEnuHeader, kNedHeader),
                          .found = geom::in_quotes(text)});
}

}  // namespace

std::vector<Setpoint> setpoints(const Trajectory& enu, double rate) {
  std::vector<Setpoint> made;
  const double end = duration(enu);
  std::size_t segment = 0;
  double begin = 0;
  const auto add = [&](double t) {
    while (segment + 1 < enu.segments.size() && t >= begin + enu.segments[segment].duration) {
      begin += enu.segments[segment++].duration;
    }
    const Segment& s = enu.segments[segment];
    const double in = std::min(t - begin, s.duration);
    made.push_back({t, evaluate(s, in), 0, 0});
    const auto looks = heading(s, in / s.duration).value_or(Heading{});
    made.back().yaw = looks.yaw;
    made.back().yaw_rate = looks.rate;
  };
  for (double k = 0; k / rate < end; ++k) add(k / rate);
  add(end);
  return made;
}

void write_setpoints(std::ostream& out, const std::vector<Setpoint>& setpoints, SetpointAxes axes,
                     bool checked) {
  std::string text(axes == SetpointAxes::enu ? kEnuHeader : kNedHeader);
  if (!checked) text += kUnchecked;
  for (const Setpoint& s : setpoints) {
    const char* separator = "\n";
    for (const double value : row_of(axes == SetpointAxes::enu ? s : swapped(s))) {
      text += separator;
      geom::append_number(text, value == 0 ? 0.0 : value);  // no "-0"
      separator = ",";
    }
    if (!checked) text += ",1";
  }
  out << text << '\n';
}

std::vector<Setpoint> read_setpoints(std::istream& in, std::string_view source) {
  std::vector<Setpoint> read;
  SetpointAxes axes = SetpointAxes::enu;
  std::size_t columns = kColumns;
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (in.eof()) {
      throw geom::InputError(source, line,
                             {.expected = "a line that ends with LF",
                              .found = "none",
                              .advice = "the file may be cut"});
    }
    if (text.ends_with('\r')) text.pop_back();
    if (line == 1) {
      if (text.ends_with(kUnchecked)) {
        text.resize(text.size() - kUnchecked.size());
        ++columns;
      }
      axes = axes_of_header(text, source);
      continue;
    }
    Setpoint s = setpoint_of(parse_row(text, columns, source, line));
    if (axes == SetpointAxes::ned) s = swapped(s);
    if (!read.empty() && !(s.time > read.back().time)) {
      throw geom::InputError(source, line,
                             {.says = "t_s must grow", .found = fmt::to_string(s.time)});
    }
    read.push_back(s);
  }
  if (read.size() < 2)
    throw geom::InputError(source, {.expected = "a header and at least two rows"});
  return read;
}

namespace {

constexpr std::string_view kReaders[] = {"skyway-check"};
constexpr double kHighestRate = 10000;  // Hz, of --rate

void require_few_rows(double seconds, double rate) {
  constexpr double kMostRows = 1e7;  // 2 GB of text
  if (seconds * rate <= kMostRows) return;
  throw geom::UsageError(fmt::format(
      "--rate: expected at most {:g} setpoints in all, found {:.0f}; --rate {:g} or less fits",
      kMostRows, seconds * rate, kMostRows / seconds));
}

WrittenMission write(const MissionTask& task, const geom::Polyline&) {
  require_few_rows(duration(task.enu), task.options.rate);
  geom::TextOutput text;
  write_setpoints(text, setpoints(task.enu, task.options.rate),
                  task.options.ned ? SetpointAxes::ned : SetpointAxes::enu, task.checked);
  WrittenMission written{text.str()};
  written.reading.placement = task.options.placement;
  return written;
}

std::vector<std::string> warnings(const MissionTask& task, const CheckResult* result) {
  if (!result || task.options.flier.tracking) return {};
  return {task.flight->id +
          ": a setpoints file is proved for a vehicle that is where its setpoint "
          "is; PX4 1.17 was up to 0.73 m away: --tracking H,V allows for that"};
}

std::string remedy(const MissionTask& task, const CheckResult& result) {
  const bool near = result.reason == Reason::collision || result.reason == Reason::bounds;
  const bool limit =
      std::any_of(kLimitKinds.begin(), kLimitKinds.end(),
                  [&](const LimitKind& kind) { return result.reason == broken(kind.limit); });
  if (!(near || limit) || task.options.rate >= kHighestRate) return "";
  return fmt::format("write more setpoints a second (--rate {:g})",
                     std::min(4 * task.options.rate, kHighestRate));
}

}  // namespace

constinit const MissionFormat kSetpoints{
    .format =
        {.word = "setpoints",
         .what = "a table of setpoints",
         .begins =
             geom::any_of<geom::text_begins_with<"t_s,east_m,">, geom::text_begins_with<"t_s,n_m,">,
                          geom::text_begins_with<"t_s,x_m,">>,
         .readers = kReaders},
    .may_be = [](std::string_view text) { return text_head(text).starts_with("t_s,"); },
    .read = [](std::istream& in, const ReadTask& task) -> ReadFlights {
      return {{{FlownSetpoints{read_setpoints(in, task.source)}}}};
    },
    .write = write,
    .warnings = warnings,
    .remedy = remedy,
    .reads_with = {FileOption::navigation, FileOption::tracking},
    .writes_with = {FileOption::rate, FileOption::axes, FileOption::navigation,
                    FileOption::tracking}};

}  // namespace traj
