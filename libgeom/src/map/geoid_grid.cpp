#include "geom/map/geoid_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"

namespace geom {
namespace {

constexpr double kMostNodes = 3e8;
constexpr float kNoHeight = -88.8888F;  // in a .gtx
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// A .gtx does not say its error. Straight slopes by quarters of a degree are 1.2 m off EGM96 at
// most; what they are off by grows no faster than the square of the steps.
double error_of_gtx(double north_step, double east_step) {
  constexpr double kQuarter = 1.2;  // m
  const double quarters = std::max({1.0, 4 * north_step, 4 * east_step});
  return kQuarter * quarters * quarters;
}

// The first bytes as a big-endian number.
template <class T>
T big_endian(const char* bytes) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return std::bit_cast<T>(bits);
}

template <class T>
void append_big_endian(std::string& out, T value) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  const auto bits = std::bit_cast<Bits>(value);
  for (std::size_t i = sizeof(T); i-- > 0;) out += static_cast<char>(bits >> (8 * i) & 0xff);
}

[[noreturn]] void refuse(std::string_view source, std::string found) {
  throw InputError(source, {.expected = "a whole geoid grid of PROJ (.gtx) or GeographicLib (.pgm)",
                            .found = std::move(found)});
}

void require_sensible(const GeoidGrid& grid, std::string_view source) {
  const bool steps =
      grid.north_step > 0 && grid.north_step <= 10 && grid.east_step > 0 && grid.east_step <= 10;
  const bool place = std::abs(grid.south) <= 90 && std::abs(grid.west) <= 360;
  if (!steps || !place || grid.columns < 2 || grid.rows < 2) {
    refuse(source, "a grid without place or steps");
  }
  if (!(grid.error >= 0)) refuse(source, fmt::format("an error of {} m", grid.error));
}

GeoidGrid read_gtx(const std::string& bytes, std::string_view source) {
  constexpr std::size_t kHead = 40;
  GeoidGrid grid;
  grid.south = big_endian<double>(bytes.data());
  grid.west = big_endian<double>(bytes.data() + 8);
  grid.north_step = big_endian<double>(bytes.data() + 16);
  grid.east_step = big_endian<double>(bytes.data() + 24);
  const auto rows = big_endian<std::int32_t>(bytes.data() + 32);
  const auto columns = big_endian<std::int32_t>(bytes.data() + 36);
  const double nodes = static_cast<double>(rows) * columns;
  if (rows < 2 || columns < 2 || nodes > kMostNodes ||
      static_cast<double>(bytes.size()) != nodes * 4 + kHead) {
    refuse(source, fmt::format("{} bytes", bytes.size()));
  }
  grid.rows = static_cast<std::size_t>(rows);
  grid.columns = static_cast<std::size_t>(columns);
  grid.error = error_of_gtx(grid.north_step, grid.east_step);
  for (std::size_t i = kHead; i < bytes.size(); i += 4) {
    const auto height = big_endian<float>(bytes.data() + i);
    grid.heights.push_back(std::abs(height) < 200 && height != kNoHeight ? height : kNone);
  }
  return grid;
}

// The number after a word of the comments, such as "# Offset -108".
std::optional<double> said(const std::string& head, const std::string& word) {
  const std::size_t at = head.find("# " + word + ' ');
  if (at == std::string::npos) return std::nullopt;
  TextInput rest(head.substr(at + word.size() + 3, 40));
  rest.imbue(std::locale::classic());
  double value = 0;
  return rest >> value ? std::optional(value) : std::nullopt;
}

// Rows go from 90 N to 90 S, columns from 0 E around the Earth.
GeoidGrid read_pgm(const std::string& bytes, std::string_view source) {
  std::size_t at = bytes.find('\n') + 1;
  while (at < bytes.size() && bytes[at] == '#') at = bytes.find('\n', at) + 1;
  const std::string head = bytes.substr(0, at);
  TextInput sizes(bytes.substr(at, 80));
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t largest = 0;
  sizes >> columns >> rows >> largest;
  const auto offset = said(head, "Offset");
  const auto scale = said(head, "Scale");
  const auto error = said(head, "MaxBilinearError");
  const double nodes = static_cast<double>(rows) * static_cast<double>(columns);
  const std::size_t begin = at + static_cast<std::size_t>(sizes.tellg()) + 1;
  const bool flat = scale && *scale == 0;  // all heights would be the same
  if (!sizes || largest != 65535 || !offset || !scale || flat || !error || rows < 2 ||
      columns < 2 || nodes > kMostNodes ||
      static_cast<double>(bytes.size()) != nodes * 2 + static_cast<double>(begin)) {
    refuse(source, in_quotes(head.substr(0, 30)));
  }
  GeoidGrid grid{.south = -90,
                 .west = 0,
                 .north_step = 180.0 / static_cast<double>(rows - 1),
                 .east_step = 360.0 / static_cast<double>(columns),
                 .columns = columns,
                 .rows = rows,
                 .heights = std::vector<float>(rows * columns),
                 .error = *error + std::abs(*scale)};
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const char* const two = bytes.data() + begin + 2 * (j * columns + i);
      const unsigned number =
          static_cast<unsigned char>(two[0]) * 256U + static_cast<unsigned char>(two[1]);
      grid.heights[(rows - 1 - j) * columns + i] = static_cast<float>(*offset + *scale * number);
    }
  }
  return grid;
}

// Of a node, whose column may go around the Earth; NaN beyond the grid.
float node(const GeoidGrid& grid, long column, long row) {
  const auto columns = static_cast<long>(grid.columns);
  const bool around = grid.east_step * static_cast<double>(columns + 1) > 360;
  if (around) column = (column % columns + columns) % columns;
  if (column < 0 || column >= columns || row < 0 || row >= static_cast<long>(grid.rows)) {
    return kNone;
  }
  return grid.heights[static_cast<std::size_t>(row * columns + column)];
}

// The height at a place within the cell (i, j).
double between(const GeoidGrid& grid, long i, long j, double u, double v) {
  const auto at = [&](long column, long row) -> double { return node(grid, column, row); };
  return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
         v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
}

}  // namespace

// A surface of straight slopes is highest and lowest at the corners of the part of a cell.
std::optional<GeoidRange> GeoidGrid::over(const GeoidArea& area) const {
  constexpr double kHair = 1e-9;
  const double turn = 360 * std::floor((area.west - west) / 360);
  const double x0 = (area.west - west - turn) / east_step - kHair;
  const double x1 = (area.east - west - turn) / east_step + kHair;
  const double y0 = std::max(0.0, (area.south - south) / north_step - kHair);
  const double y1 =
      std::min(static_cast<double>(rows - 1), (area.north - south) / north_step + kHair);
  if (!(x0 <= x1 && y0 <= y1) || x1 - x0 > 1e4 || area.south < south - kHair ||
      area.north > south + static_cast<double>(rows - 1) * north_step + kHair)
    return std::nullopt;
  std::optional<GeoidRange> out;
  for (long j = static_cast<long>(std::floor(y0));
       static_cast<double>(j) < y1 || j == std::floor(y0); ++j) {
    for (long i = static_cast<long>(std::floor(x0)); static_cast<double>(i) <= x1; ++i) {
      for (const double x :
           {std::max(x0, static_cast<double>(i)), std::min(x1, static_cast<double>(i + 1))}) {
        for (const double y :
             {std::max(y0, static_cast<double>(j)), std::min(y1, static_cast<double>(j + 1))}) {
          const long row = std::min(j, static_cast<long>(rows) - 2);
          const double height =
              between(*this, i, row, x - static_cast<double>(i), y - static_cast<double>(row));
          if (std::isnan(height)) return std::nullopt;
          out = out ? GeoidRange{std::min(out->least, height), std::max(out->most, height)}
                    : GeoidRange{height, height};
        }
      }
    }
  }
  if (out) *out = {out->least - error - 1e-4, out->most + error + 1e-4};
  return out;
}

std::string gtx_over(const GeoidGrid& grid, const GeoidArea& area) {
  constexpr const char* kSource = "the geoid grid";
  if (!grid.over(area)) {
    throw InputError(kSource, {.says = "it does not know the sea level all over the map"});
  }
  const double error = error_of_gtx(grid.north_step, grid.east_step);
  if (grid.error > error) {
    throw InputError(kSource, {.expected = fmt::format("an error of at most {} m", error),
                               .found = fmt::to_string(grid.error)});
  }
  const auto cell = [](double at, double from, double step) {
    return static_cast<long>(std::floor((at - from) / step));
  };
  const double turn = 360 * std::floor((area.west - grid.west) / 360);
  const long left = cell(area.west, grid.west + turn, grid.east_step) - 1;
  const long right = cell(area.east, grid.west + turn, grid.east_step) + 2;
  const long low = std::max(0L, cell(area.south, grid.south, grid.north_step) - 1);
  const long high =
      std::min(static_cast<long>(grid.rows) - 1, cell(area.north, grid.south, grid.north_step) + 2);
  std::string out;
  append_big_endian(out, grid.south + grid.north_step * static_cast<double>(low));
  append_big_endian(out, grid.west + grid.east_step * static_cast<double>(left));
  append_big_endian(out, grid.north_step);
  append_big_endian(out, grid.east_step);
  append_big_endian(out, static_cast<std::int32_t>(high - low + 1));
  append_big_endian(out, static_cast<std::int32_t>(right - left + 1));
  for (long row = low; row <= high; ++row) {
    for (long column = left; column <= right; ++column) {
      const float height = node(grid, column, row);
      append_big_endian(out, std::isnan(height) ? kNoHeight : height);
    }
  }
  return out;
}

GeoidGrid read_geoid_grid(std::istream& in, std::string_view source) {
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  if (bytes.size() < 40) refuse(source, fmt::format("{} bytes", bytes.size()));
  GeoidGrid grid = bytes.starts_with("P5") ? read_pgm(bytes, source) : read_gtx(bytes, source);
  require_sensible(grid, source);
  return grid;
}

}  // namespace geom
