#include "traj/export/setpoints.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "geom/error.h"
#include "geom/io/record.h"
#include "traj/yaw.h"

namespace traj {
namespace {

constexpr std::string_view kHeader =
    "t_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,ax_m_s2,ay_m_s2,az_m_s2,yaw_rad";
constexpr std::size_t kColumns = 11;

void append_row(std::string& text, const Trajectory& trajectory, geom::Axes axes, double t) {
  const State s = evaluate(trajectory, t);
  const std::optional<double> yaw = yaw_at(trajectory, t);
  geom::append_json(text, t);
  for (const Vec3& v : {s.position, s.velocity, s.acceleration}) {
    const Vec3 enu = geom::to_enu(axes, v);
    for (int i = 0; i < 3; ++i) {
      text += ',';
      geom::append_json(text, enu[i]);
    }
  }
  text += ',';
  geom::append_json(text, yaw ? geom::yaw_to_enu(axes, *yaw) : 0);
  text += '\n';
}

std::vector<double> parse_row(std::string_view text, std::string_view source, std::size_t line) {
  std::vector<double> row;
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t stop = std::min(text.find(',', at), text.size());
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data() + at, text.data() + stop, value);
    if (error != std::errc() || rest != text.data() + stop || !std::isfinite(value)) {
      throw geom::InputError(source, line,
                             fmt::format("column {} must be a number, found \"{}\"", row.size() + 1,
                                         text.substr(at, stop - at)));
    }
    row.push_back(value);
    at = stop + 1;
  }
  if (row.size() != kColumns) {
    throw geom::InputError(source, line,
                           fmt::format("expected {} columns, found {}", kColumns, row.size()));
  }
  return row;
}

}  // namespace

void write_setpoints(std::ostream& out, const Trajectory& trajectory, geom::Axes axes,
                     double rate) {
  const double end = duration(trajectory);
  std::string text(kHeader);
  text += '\n';
  for (double k = 0; k / rate < end; ++k) append_row(text, trajectory, axes, k / rate);
  append_row(text, trajectory, axes, end);
  out << text;
}

Trajectory read_setpoints(std::istream& in, std::string_view source, geom::Axes axes) {
  Trajectory trajectory;
  std::optional<std::vector<double>> last;
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (line == 1) {
      if (text != kHeader) {
        throw geom::InputError(source, line,
                               fmt::format("expected the header {}, found \"{}\"", kHeader, text));
      }
      continue;
    }
    const auto row = parse_row(text, source, line);
    if (last) {
      Segment s;
      s.duration = row[0] - (*last)[0];
      if (!(s.duration > 0)) {
        throw geom::InputError(source, line, fmt::format("t_s must grow, found {}", row[0]));
      }
      const Vec3 a = geom::to_enu(axes, {(*last)[1], (*last)[2], (*last)[3]});
      const Vec3 b = geom::to_enu(axes, {row[1], row[2], row[3]});
      s.point = {a, a, a, a, b, b, b, b};
      trajectory.segments.push_back(s);
    }
    last = row;
  }
  if (trajectory.segments.empty()) {
    throw geom::InputError(source, "expected a header and at least two rows");
  }
  return trajectory;
}

}  // namespace traj
