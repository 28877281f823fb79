// Voxel maps of jps3d (KumarRobotics): lines `- KEY: VALUE` (or `KEY: VALUE`) of YAML, where a
// value is a number, or numbers between [ and ], perhaps over several lines; # starts a comment.
// origin (3 coordinates of the grid's lower corner), dim (3 counts), resolution (metres, > 0) and
// data, x fastest, are needed; above 0 is occupied, 0 free, below 0 unknown. start and goal are no
// obstacles. Ids are indices into data, and the bounds are the whole grid.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/rounding.h"
#include "geom/import/import_boxes.h"
#include "geom/text/beginning.h"
#include "geom/text/number.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

constexpr std::string_view kBlank = " \t\r";
constexpr std::array<std::string_view, 6> kKeys = {"origin", "dim",   "resolution",
                                                   "data",   "start", "goal"};

// A list or a scalar of the file.
struct Value {
  std::size_t line = 0;
  bool list = false;
  std::vector<double> numbers;
};

class Reader {
 public:
  Reader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  std::map<std::string, Value, std::less<>> read() {
    std::map<std::string, Value, std::less<>> out;
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    require_line_ends();
    for (pass(true); !text_.empty(); end_line()) {
      take_dash();
      const std::string key = take_key();
      if (out.contains(key))
        refuse({.expected = "each key once", .found = fmt::format("{} again", key)});
      out[key] = take_value();
    }
    return out;
  }

  [[noreturn]] void refuse(Fault fault, std::size_t line = 0) const {
    throw InputError(source_, line ? line : line_, std::move(fault));
  }

 private:
  // A comment would go on over a line that ends in a carriage return alone.
  void require_line_ends() const {
    for (std::size_t at = 0; (at = text_.find('\r', at)) != text_.npos; ++at) {
      if (at + 1 < text_.size() && text_[at + 1] != '\n' && text_[at + 1] != '\r') {
        refuse(lone_return());
      }
    }
  }

  // Blanks and comments, and with `lines` the ends of lines.
  void pass(bool lines) {
    while (!text_.empty()) {
      const char c = text_.front();
      if (c == '#') {
        text_.remove_prefix(std::min(text_.find('\n'), text_.size()));
      } else if (c == '\n' && lines) {
        ++line_;
        text_.remove_prefix(1);
      } else if (kBlank.find(c) != kBlank.npos) {
        text_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  void end_line() {
    pass(false);
    if (!text_.empty() && text_.front() != '\n') {
      refuse({.expected = "one key in each line",
              .found = fmt::format("\"{}\" after its value", word())});
    }
    pass(true);
  }

  // What stands next, for a message.
  std::string_view word() const {
    return text_.substr(0, std::min<std::size_t>(40, text_.find('\n')));
  }

  void take_dash() {
    if (!text_.starts_with("- ")) return;
    text_.remove_prefix(2);
    pass(false);
  }

  std::string take_key() {
    const std::size_t end = std::min(text_.find_first_of(": \t\r\n"), text_.size());
    const std::string key(text_.substr(0, end));
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
      refuse({.expected = "a key of jps3d (origin, dim, resolution, data, start, goal)",
              .found = in_quotes(word())});
    }
    text_.remove_prefix(end);
    pass(false);
    if (!text_.starts_with(":")) refuse({.expected = fmt::format(": after {}", key)});
    text_.remove_prefix(1);
    pass(false);
    return key;
  }

  Value take_value() {
    Value out;
    out.line = line_;
    if (!text_.starts_with("[")) {
      out.numbers.push_back(take_number());
      return out;
    }
    out.list = true;
    text_.remove_prefix(1);
    for (pass(true); !text_.starts_with("]"); pass(true)) {
      out.numbers.push_back(take_number());
      pass(true);
      if (text_.starts_with(",")) {
        text_.remove_prefix(1);
      } else if (!text_.starts_with("]")) {
        refuse({.expected = ", or ] in a list", .found = in_quotes(word())});
      }
    }
    text_.remove_prefix(1);
    return out;
  }

  double take_number() {
    double value = 0;
    const char* const end = text_.data() + text_.size();
    const auto [rest, error] = read_number(text_.data(), end, value);
    const bool whole =
        rest == end || std::string_view(" \t\r\n,]#").find(*rest) != std::string_view::npos;
    if (error != std::errc() || !whole || !(std::abs(value) <= kLargestCoordinate)) {
      refuse({.expected = "a finite number within 1e8", .found = in_quotes(word())});
    }
    text_.remove_prefix(static_cast<std::size_t>(rest - text_.data()));
    return value;
  }

  std::string_view text_;
  std::string_view source_;
  std::size_t line_ = 1;
};

struct Grid {
  std::array<double, 3> origin;
  std::array<std::size_t, 3> dim;
  double resolution;
};

Grid grid_of(const Reader& reader, const std::map<std::string, Value, std::less<>>& values) {
  const auto of = [&](std::string_view key, bool list, std::size_t count) -> const Value& {
    const auto at = values.find(key);
    if (at == values.end())
      reader.refuse({.expected = fmt::format("the key {}", key), .found = "none"});
    if (at->second.list != list || (list && count && at->second.numbers.size() != count)) {
      reader.refuse({.key = std::string(key),
                     .expected = list ? fmt::format("a list of {}", count) : "one number",
                     .found = fmt::format("{} number{}", at->second.numbers.size(),
                                          at->second.numbers.size() == 1 ? "" : "s")},
                    at->second.line);
    }
    return at->second;
  };
  Grid grid{};
  const Value& origin = of("origin", true, 3);
  const Value& dim = of("dim", true, 3);
  const Value& resolution = of("resolution", false, 1);
  const Value& data = of("data", true, 0);
  std::copy(origin.numbers.begin(), origin.numbers.end(), grid.origin.begin());
  grid.resolution = resolution.numbers[0];
  if (!(grid.resolution > 1e-6)) {
    reader.refuse(
        {.key = "resolution", .expected = "above 1e-6", .found = fmt::to_string(grid.resolution)},
        resolution.line);
  }
  double cells = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double count = dim.numbers[i];
    if (!(count >= 1 && count <= 1e6 && count == std::floor(count))) {
      reader.refuse(
          {.key = "dim", .expected = "whole numbers from 1 to 1e6", .found = fmt::to_string(count)},
          dim.line);
    }
    grid.dim[i] = static_cast<std::size_t>(count);
    cells *= count;
    if (!(std::abs(grid.origin[i]) + count * grid.resolution <= kLargestCoordinate)) {
      reader.refuse({.expected = "a grid within 1e8 m", .found = "one beyond"}, dim.line);
    }
  }
  if (cells != static_cast<double>(data.numbers.size())) {
    reader.refuse({.says = fmt::format("data must have the {} numbers that dim says", cells),
                   .found = fmt::to_string(data.numbers.size())},
                  data.line);
  }
  return grid;
}

// The planes between cells along an axis, rounded down and up.
struct Planes {
  Planes(double origin, std::size_t count, double resolution) {
    for (std::size_t k = 0; k <= count; ++k) {
      const auto n = static_cast<double>(k);
      low.push_back(add_down(origin, multiply_down(n, resolution)));
      high.push_back(add_up(origin, multiply_up(n, resolution)));
      change = std::max(change, high.back() - low.back());
    }
  }
  std::vector<double> low;
  std::vector<double> high;
  double change = 0;
};

ImportedBoxes read_jps3d_map(std::istream& in, std::string_view source,
                             const ImportOptions& options) {
  const std::string text(std::istreambuf_iterator<char>(in), {});
  Reader reader(text, source);
  const auto values = reader.read();
  const Grid grid = grid_of(reader, values);
  const std::vector<double>& data = values.find("data")->second.numbers;
  const Planes x(grid.origin[0], grid.dim[0], grid.resolution);
  const Planes y(grid.origin[1], grid.dim[1], grid.resolution);
  const Planes z(grid.origin[2], grid.dim[2], grid.resolution);
  ImportedBoxes out;
  out.table.labels = {"", "unknown"};
  out.bounds = Aabb{{x.low.front(), y.low.front(), z.low.front()},
                    {x.high.back(), y.high.back(), z.high.back()}};
  out.largest_change = std::max({x.change, y.change, z.change});
  for (std::size_t at = 0; at < data.size(); ++at) {
    if (data[at] == 0) continue;
    const bool unknown = data[at] < 0;
    out.unknown += unknown;
    if (unknown && !options.unknown_blocked) continue;
    const std::size_t i = at % grid.dim[0];
    const std::size_t j = at / grid.dim[0] % grid.dim[1];
    const std::size_t k = at / grid.dim[0] / grid.dim[1];
    out.table.add({{x.low[i], y.low[j], z.low[k]}, {x.high[i + 1], y.high[j + 1], z.high[k + 1]}},
                  at, unknown ? 1 : 0);
  }
  if (out.table.boxes.empty())
    reader.refuse({.expected = "at least one occupied cell", .found = "none"});
  return out;
}

// A list of YAML.
bool may_be_jps3d_map(std::string_view head) {
  const std::string_view line = first_line(head);
  return line.starts_with("- ") && line.find(':') != line.npos;
}

constexpr std::string_view kReaders[] = {"skyway-import"};
constexpr Format kFormat{
    .word = "jps3d",
    .what = "a jps3d map",
    .begins = any_of<text_begins_with<"- start:">, text_begins_with<"- origin:">>,
    .readers = kReaders};

}  // namespace

constinit const BoxFormat kJps3d{
    .format = &kFormat, .may_be = may_be_jps3d_map, .read = read_jps3d_map, .has_unknown = true};

}  // namespace geom
