#include "traj/mission/formats/crazyflie.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <istream>
#include <numbers>
#include <ostream>
#include <string>

#include "curve/curve_piece.h"
#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/text/beginning.h"
#include "geom/text/number.h"
#include "mission/formats/text_head.h"
#include "solve/four_lanes.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

constexpr int kAxes = 4;  // x, y, z, yaw
constexpr int kColumns = 1 + kAxes * kPoints;
using Row = std::array<double, kColumns>;
using Powers = std::array<double, kPoints>;
constexpr std::array<int, kPoints> kBinomial = {1, 7, 21, 35, 35, 21, 7, 1};

std::string column_names() {
  std::string names = "duration";
  for (const char* axis : {"x", "y", "z", "yaw"}) {
    for (int k = 0; k < kPoints; ++k) names += fmt::format(",{}^{}", axis, k);
  }
  return names;
}

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

Row parse_row(const std::string& text, std::string_view source, std::size_t line) {
  Row row;
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
                             {.key = fmt::format("column {}", count + 1),
                              .expected = "a number",
                              .found = geom::in_quotes(std::string_view(at, stop))});
    }
    if (count < kColumns) row[count] = static_cast<float>(value);
    ++count;
    if (stop == end) break;
    at = stop + 1;
  }
  if (count != kColumns) {
    throw geom::InputError(source, line,
                           {.expected = "33 columns (separated by commas, decimals by a point)",
                            .found = fmt::to_string(count)});
  }
  return row;
}

Powers powers_of(const Row& row, int axis) {
  Powers powers;
  std::copy_n(row.begin() + 1 + axis * kPoints, kPoints, powers.begin());
  return powers;
}

// Each name that a header has must be that column's.
void require_header(std::string text, std::string_view source) {
  const std::string wanted = column_names();
  while (!text.empty() && (text.back() == '\r' || text.back() == ',')) text.pop_back();
  std::string found;
  for (const char c : text) {
    if (c != ' ') found += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const bool prefix =
      wanted.starts_with(found) && (found.size() == wanted.size() || wanted[found.size()] == ',');
  if (!prefix && !found.starts_with(wanted + ",unchecked")) {
    throw geom::InputError(source, 1,
                           {.expected = fmt::format("the header {}", wanted),
                            .found = geom::in_quotes(text.substr(0, 60))});
  }
}

Segment segment_of(const Row& row, std::string_view source, std::size_t line) {
  Segment s;
  s.duration = row[0];
  std::array<std::array<double, kPoints>, kAxes> values;
  for (int axis = 0; axis < kAxes; ++axis) {
    values[axis] = to_bernstein(powers_of(row, axis), s.duration);
  }
  for (int i = 0; i < kPoints; ++i) {
    s.point[i] = {values[0][i], values[1][i], values[2][i]};
    if (!(s.point[i].cwiseAbs().maxCoeff() <= geom::kLargestCoordinate)) {
      throw geom::InputError(source, line,
                             {.says = "the curve must stay within 1e8 m", .found = "it beyond"});
    }
  }
  s.yaw = values[3];
  return s;
}

// --- single precision -----------------------------------------------------------------------

constexpr double kUnit = 0x1p-24;       // a rounding in single precision, relative
constexpr double kSmallest = 0x1p-126;  // what may be flushed to zero
constexpr double kLargest = 0x1p+127;   // what it surely holds
constexpr double kFarthestStray = 1;    // m: no flight any more
constexpr int kParts = 64;              // of a segment, for the ranges of partial sums

// Of parts at once.
using Lanes = Four;
constexpr int kLanes = 4;
static_assert(kParts % kLanes == 0);

struct Range {
  Lanes low;
  Lanes high;

  // Of its numbers, the largest size.
  SKYWAY_FOUR_LANES void size(Lanes& out) const {
    const Lanes below = low > -low ? low : -low;
    const Lanes above = high > -high ? high : -high;
    out = below > above ? below : above;
  }
  // Times t from `from` to `to`, both >= 0.
  SKYWAY_FOUR_LANES void multiply(const Lanes& from, const Lanes& to) {
    low = low * from < low * to ? low * from : low * to;
    high = high * from > high * to ? high * from : high * to;
  }
};

// How far Horner's rule in single precision may be from the polynomial over [0, duration], where
// each coefficient was rounded `roundings` times before.
double horner_error(const Powers& c, double duration, int roundings) {
  constexpr int kAtOnce = 4;  // lanes whose sums do not wait for each other
  static_assert(kParts % (kAtOnce * kLanes) == 0);
  const auto found = [&]() SKYWAY_FOUR_LANES {
    Lanes worst{};
    auto fits = worst == worst;
    for (int part = 0; part < kParts; part += kAtOnce * kLanes) {
      Lanes low[kAtOnce], high[kAtOnce], error[kAtOnce];
      Range y[kAtOnce];
      Lanes size, times;
      for (int i = 0; i < kAtOnce; ++i) {
        const Lanes first = part + i * kLanes + Lanes{0, 1, 2, 3};
        low[i] = duration * first / kParts;
        high[i] = duration * (first + 1) / kParts;
        y[i] = {c[kDegree] + Lanes{}, c[kDegree] + Lanes{}};
        y[i].size(size);
        error[i] = roundings * kUnit * size;
      }
      for (int k = kDegree - 1; k >= 0; --k) {
        const double own = roundings * kUnit * std::abs(c[k]);
#pragma GCC unroll 4
        for (int i = 0; i < kAtOnce; ++i) {
          y[i].multiply(low[i], high[i]);
          y[i].size(times);
          const Lanes of_product = error[i] * high[i] * (1 + kUnit) + kUnit * times + kSmallest;
          y[i] = {y[i].low + c[k], y[i].high + c[k]};
          y[i].size(size);
          const Lanes before = of_product + own;
          error[i] = before + kUnit * (size + before) + kSmallest;
          fits &= times + size + error[i] <= kLargest;
        }
      }
      for (const Lanes& one : error) worst = worst > one ? worst : one;
    }
    double all = 0;
    for (int i = 0; i < kLanes; ++i) all = fits[i] ? std::max(all, worst[i]) : kInfinity;
    return all;
  };
  // More than this sum's own rounding, in double, and terms of kUnit^2.
  return with_four_lanes(found) * (1 + 1e-6);
}

Powers derivative(const Powers& c) {
  Powers d{};
  for (int k = 1; k < kPoints; ++k) d[k - 1] = k * c[k];
  return d;
}

// What the Bernstein values in double differ by, of position.
double conversion_error(const Powers& c, double duration) {
  double sum = 0;
  double scale = 1;
  for (const double v : c) {
    sum += std::abs(v) * scale;
    scale *= duration;
  }
  return 0x1p-53 * 64 * sum;
}

Stray stray_of(const Row& row, std::string_view source, std::size_t line) {
  const double duration = row[0];
  std::array<Vec3, 4> errors;  // of the derivatives 0 to 3, along each axis
  for (int axis = 0; axis < 3; ++axis) {
    Powers c = powers_of(row, axis);
    double converted = conversion_error(c, duration);
    for (int order = 0; order < 4; ++order) {
      errors[order][axis] = horner_error(c, duration, order) + converted;
      c = derivative(c);
      converted *= 2 * (kDegree - order) / duration;
    }
  }
  const Powers turn = derivative(powers_of(row, 3));
  const double yaw_rate = horner_error(turn, duration, 1) +
                          conversion_error(powers_of(row, 3), duration) * 2 * kDegree / duration;
  const Stray stray{errors[0], errors[1].norm(), errors[2].norm(), errors[3].norm(), yaw_rate};
  const bool told =
      std::all_of(errors.begin(), errors.end(), [](auto& e) { return e.allFinite(); });
  if (!told || !(errors[0].maxCoeff() <= kFarthestStray) || !std::isfinite(yaw_rate)) {
    throw geom::InputError(source, line,
                           {.expected = fmt::format(
                                "a segment that single precision can tell to {} m", kFarthestStray),
                            .found = fmt::format("errors of {:.3g} m", errors[0].maxCoeff()),
                            .advice = "cut it into shorter ones"});
  }
  return stray;
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
  std::string text = column_names() + '\n';
  for (const Segment& s : enu.segments) {
    geom::append_number(text, s.duration);
    for (int axis = 0; axis < kAxes; ++axis) {
      for (const double c : to_powers(axis_of(s, axis), s.duration)) {
        text += ',';
        geom::append_number(text, c);
      }
    }
    text += '\n';
  }
  out << text;
}

CrazyflieFlight read_crazyflie(std::istream& in, std::string_view source) {
  CrazyflieFlight flight;
  double total = 0;
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (in.eof()) {
      throw geom::InputError(source, line,
                             {.expected = "a line that ends with LF",
                              .found = "none",
                              .advice = "the file may be cut"});
    }
    const bool header =
        line == 1 && !text.empty() && std::isalpha(static_cast<unsigned char>(text[0]));
    if (header) require_header(text, source);
    if (header || text.empty() || text == "\r") continue;
    const Row row = parse_row(text, source, line);
    if (!(row[0] > 0)) {
      throw geom::InputError(
          source, line, {.key = "duration", .expected = "> 0", .found = fmt::to_string(row[0])});
    }
    total += row[0];
    if (!(total <= kCrazyflieLongest)) {
      throw geom::InputError(
          source, line,
          {.expected = fmt::format(
               "a flight of at most {} s, as a Crazyflie's clock goes by coarse steps then",
               kCrazyflieLongest),
           .found = fmt::format("{} s", total)});
    }
    flight.trajectory.segments.push_back(segment_of(row, source, line));
    flight.stray.push_back(stray_of(row, source, line));
  }
  if (flight.trajectory.segments.empty()) {
    throw geom::InputError(source, {.expected = "at least one row of 33 columns", .found = "none"});
  }
  return flight;
}

namespace {

ReadFlights read(std::istream& in, const ReadTask& task) {
  CrazyflieFlight flight = read_crazyflie(in, task.source);
  return {{{FlownCurve{std::move(flight.trajectory), std::move(flight.stray)}}}};
}

WrittenMission write(const MissionTask& task, const geom::Polyline&) {
  geom::TextOutput text;
  write_crazyflie(text, task.enu);
  WrittenMission written{text.str()};
  if (const std::string note = unchecked_note(task); !note.empty()) {
    written.text.insert(written.text.find('\n'), ',' + note);  // programs skip the header
  }
  written.reading.placement = task.options.placement;
  written.memory = crazyflie_memory(task.enu);
  return written;
}

std::string memory_warning(const MissionTask& task) {
  const CrazyflieMemory memory = crazyflie_memory(task.enu);
  if (memory.fits) return "";
  return fmt::format(
      "{}: {} segments; a Crazyflie's memory holds {}{}", task.flight->id, task.enu.segments.size(),
      kCrazyflieSegments,
      memory.compressed_fits
          ? fmt::format(" (compressed they take {} of its 4096 bytes, but that rounds to "
                        "millimetres and milliseconds, which was not looked at)",
                        memory.compressed_bytes)
          : ", nor do they fit compressed");
}

// The firmware's default controller follows positions alone, and no faster than 1.1 m/s along an
// axis (position_controller_pid.c); flown through it, faster files fell metres behind their times
// and cut across their curves (docs/firmware.md).
std::string controller_warning(const MissionTask& task, const CheckResult& result) {
  constexpr double kFollowed = 1;  // m/s
  const auto& speed = result.largest[Limit::speed];
  if (!speed || speed->value <= kFollowed) return "";
  return fmt::format(
      "{}: it flies {:.2g} m/s, and a Crazyflie's default controller (PID) follows no more than 1: "
      "set stabilizer.controller to 2 (Mellinger), or solve it with --vmax 1",
      task.flight->id, speed->value);
}

std::vector<std::string> warnings(const MissionTask& task, const CheckResult* result) {
  std::vector<std::string> out;
  if (result) out.push_back(controller_warning(task, *result));
  out.push_back(memory_warning(task));
  return out;
}

}  // namespace

constinit const MissionFormat kCrazyflie{
    .format = {.word = "crazyflie",
               .what = "a Crazyflie trajectory",
               .begins = geom::text_begins_with<"duration,x^0,">,
               .readers = kDroneReaders},
    .may_be =
        [](std::string_view text) {
          const std::string_view head = text_head(text);
          return head.starts_with("duration") || head.starts_with("Duration");
        },
    .read = read,
    .write = write,
    .warnings = warnings,
    .reads_with = {FileOption::navigation, FileOption::tracking, FileOption::gap},
    .writes_with = {FileOption::show, FileOption::navigation, FileOption::tracking}};

}  // namespace traj
