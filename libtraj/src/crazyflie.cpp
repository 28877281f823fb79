#include "traj/export/crazyflie.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <istream>
#include <numbers>
#include <ostream>
#include <string>

#include "geom/error.h"
#include "geom/io/record.h"

namespace traj {
namespace {

constexpr int kAxes = 4;  // x, y, z, yaw
constexpr int kColumns = 1 + kAxes * kPoints;
constexpr std::array<int, kPoints> kBinomial = {1, 7, 21, 35, 35, 21, 7, 1};

int choose(int n, int k) {
  int result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

// Ascending powers of t / duration from Bernstein values: c_k = C(7,k) times the k-th difference.
std::array<double, kPoints> to_powers(std::array<double, kPoints> b, double duration) {
  std::array<double, kPoints> powers;
  double scale = 1;
  for (int k = 0; k < kPoints; ++k) {
    powers[k] = kBinomial[k] * b[0] / scale;
    scale *= duration;
    for (int i = 0; i + 1 + k < kPoints; ++i) b[i] = b[i + 1] - b[i];
  }
  return powers;
}

std::array<double, kPoints> to_bernstein(const std::array<double, kPoints>& powers,
                                         double duration) {
  std::array<double, kPoints> scaled;
  double scale = 1;
  for (int k = 0; k < kPoints; ++k) {
    scaled[k] = powers[k] * scale;
    scale *= duration;
  }
  std::array<double, kPoints> b{};
  for (int i = 0; i < kPoints; ++i) {
    for (int k = 0; k <= i; ++k) {
      b[i] += static_cast<double>(choose(i, k)) / kBinomial[k] * scaled[k];
    }
  }
  return b;
}

std::array<double, kPoints> axis_of(const Segment& s, int axis) {
  std::array<double, kPoints> values{};
  if (axis == 3) return s.yaw.value_or(values);
  for (int i = 0; i < kPoints; ++i) values[i] = s.point[i][axis];
  return values;
}

std::array<double, kColumns> parse_row(const std::string& text, std::string_view source,
                                       std::size_t line) {
  std::array<double, kColumns> row;
  const char* at = text.data();
  const char* end = at + text.size();
  if (end != at && end[-1] == '\r') --end;
  if (end != at && end[-1] == ',') --end;
  int count = 0;
  while (true) {
    const char* stop = std::find(at, end, ',');
    while (at < stop && *at == ' ') ++at;
    double value = 0;
    const auto [rest, error] = std::from_chars(at, stop, value);
    if (error != std::errc() || rest != stop || !std::isfinite(static_cast<float>(value))) {
      throw geom::InputError(source, line,
                             fmt::format("column {} must be a number, found \"{}\"", count + 1,
                                         std::string_view(at, stop)));
    }
    if (count < kColumns) row[count] = static_cast<float>(value);
    ++count;
    if (stop == end) break;
    at = stop + 1;
  }
  if (count != kColumns) {
    throw geom::InputError(
        source, line,
        fmt::format("expected 33 columns (separated by commas, decimals by a point), "
                    "found {}",
                    count));
  }
  return row;
}

// Whether an axis stays in the same millimetre (tenth of a degree for yaw) of the compressed form.
bool is_constant(const Segment& s, int axis) {
  const auto values = axis_of(s, axis);
  const double scale = axis == 3 ? 1800 / std::numbers::pi : 1000;
  return std::all_of(values.begin(), values.end(), [&](double v) {
    return std::trunc(v * scale) == std::trunc(values[0] * scale);
  });
}

bool is_compressible(const Segment& s) {
  bool fits = s.duration <= 65.535;
  for (const Vec3& p : s.point) fits = fits && p.cwiseAbs().maxCoeff() <= 32.767;
  if (!s.yaw) return fits;
  for (const double yaw : *s.yaw) fits = fits && std::abs(yaw) * 1800 / std::numbers::pi <= 32767;
  return fits;
}

}  // namespace

CrazyflieMemory crazyflie_memory(const Trajectory& enu) {
  constexpr std::size_t kMemory = 4096;
  CrazyflieMemory memory{0, 8, false, true};
  for (const Segment& s : enu.segments) {
    memory.bytes += 132;
    memory.compressed_bytes += 3;
    for (int axis = 0; axis < kAxes; ++axis) {
      if (!is_constant(s, axis)) memory.compressed_bytes += 14;
    }
    memory.compressed_fits = memory.compressed_fits && is_compressible(s);
  }
  memory.fits = memory.bytes <= kMemory;
  memory.compressed_fits = memory.compressed_fits && memory.compressed_bytes <= kMemory;
  return memory;
}

void write_crazyflie(std::ostream& out, const Trajectory& enu) {
  std::string text = "duration";
  for (const char* axis : {"x", "y", "z", "yaw"}) {
    for (int k = 0; k < kPoints; ++k) text += fmt::format(",{}^{}", axis, k);
  }
  text += '\n';
  for (const Segment& s : enu.segments) {
    geom::append_json(text, s.duration);
    for (int axis = 0; axis < kAxes; ++axis) {
      for (const double c : to_powers(axis_of(s, axis), s.duration)) {
        text += ',';
        geom::append_json(text, c);
      }
    }
    text += '\n';
  }
  out << text;
}

Trajectory read_crazyflie(std::istream& in, std::string_view source) {
  Trajectory trajectory;
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    const bool header = line == 1 && !text.empty() && std::isalpha(text[0]);
    if (header || text.empty() || text == "\r") continue;
    const auto row = parse_row(text, source, line);
    Segment s;
    s.duration = row[0];
    if (!(s.duration > 0)) {
      throw geom::InputError(source, line, fmt::format("duration must be > 0, found {}", row[0]));
    }
    std::array<std::array<double, kPoints>, kAxes> values;
    for (int axis = 0; axis < kAxes; ++axis) {
      std::array<double, kPoints> powers;
      std::copy_n(row.begin() + 1 + axis * kPoints, kPoints, powers.begin());
      values[axis] = to_bernstein(powers, s.duration);
    }
    for (int i = 0; i < kPoints; ++i) {
      s.point[i] = {values[0][i], values[1][i], values[2][i]};
      if (!(s.point[i].cwiseAbs().maxCoeff() <= geom::kLargestCoordinate)) {
        throw geom::InputError(source, line, "the curve must stay within 1e8 m, found it beyond");
      }
    }
    s.yaw = values[3];
    trajectory.segments.push_back(s);
  }
  if (trajectory.segments.empty()) {
    throw geom::InputError(source, "expected at least one row of 33 columns, found none");
  }
  return trajectory;
}

}  // namespace traj
