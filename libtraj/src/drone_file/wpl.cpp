#include "traj/drone_file/wpl.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <istream>
#include <ostream>

#include "geom/base/error.h"
#include "geom/text/number.h"

namespace traj {
namespace {

constexpr std::size_t kFields = 12;
constexpr std::array<const char*, kFields> kNames = {
    "index",       "current",     "frame",    "command",   "parameter 1", "parameter 2",
    "parameter 3", "parameter 4", "latitude", "longitude", "altitude",    "autocontinue"};

void append_item(std::string& text, std::size_t index, const MissionItem& item) {
  text += fmt::format("{}\t{}\t{}\t{}", index, index == 0 ? 1 : 0, item.frame, item.command);
  for (const double p : item.param) {
    text += '\t';
    geom::append_number(text, p);
  }
  text +=
      fmt::format("\t{:.7f}\t{:.7f}\t{:.3f}\t1\n", item.latitude, item.longitude, item.altitude);
}

struct LineReader {
  std::string_view source;
  std::size_t line;

  [[noreturn]] void refuse(const std::string& message) const {
    throw geom::InputError(source, line, message);
  }

  std::array<double, kFields> fields(std::string_view text) const {
    std::array<double, kFields> values{};
    std::size_t count = 0;
    for (std::size_t at = text.find_first_not_of("\t "); at < text.size();) {
      const std::size_t stop = std::min(text.find_first_of("\t ", at), text.size());
      if (count < kFields) values[count] = number(text.substr(at, stop - at), kNames[count]);
      ++count;
      at = std::min(text.find_first_not_of("\t ", stop), text.size());
    }
    if (count != kFields) {
      refuse(fmt::format("expected 12 fields separated by tabs, found {}", count));
    }
    return values;
  }

  double number(std::string_view text, const char* name) const {
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value)) {
      refuse(fmt::format("{} must be a number with a decimal point, found \"{}\"", name,
                         text.substr(0, 40)));
    }
    return value;
  }

  int whole(double value, const char* name) const {
    if (value != std::floor(value) || value < 0 || value > 65535) {
      refuse(fmt::format("{} must be a whole number from 0 to 65535, found {}", name, value));
    }
    return static_cast<int>(value);
  }

  MissionItem item(std::string_view text, std::size_t index) const {
    const auto v = fields(text);
    if (v[0] != static_cast<double>(index)) {
      refuse(fmt::format("index must be {}, the next, found {}", index, v[0]));
    }
    for (const int flag : {1, 11}) {
      if (v[flag] != 0 && v[flag] != 1) {
        refuse(fmt::format("{} must be 0 or 1, found {}", kNames[flag], v[flag]));
      }
    }
    // A vehicle begins at the item that is current: the first, be it home, or the one after home.
    if (v[1] == 1 && index > 1) refuse("current must be 0 after the first two items, found 1");
    return {whole(v[2], "frame"),
            whole(v[3], "command"),
            {v[4], v[5], v[6], v[7]},
            v[8],
            v[9],
            v[10],
            line};
  }
};

}  // namespace

void write_wpl(std::ostream& out, const Mission& mission) {
  std::string text = "QGC WPL 110\n";
  std::size_t index = 0;
  if (mission.home) {
    const geom::GeodeticPlace& h = *mission.home;
    append_item(text, index++, {kGlobal, kWaypoint, {}, h.latitude, h.longitude, h.height, 0});
  }
  for (const MissionItem& item : mission.items) append_item(text, index++, item);
  out << text;
}

Mission read_wpl(std::istream& in, std::string_view source) {
  Mission mission;
  std::string text;
  std::size_t index = 0;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    const LineReader reader{source, line};
    if (text.ends_with('\r')) reader.refuse("expected a line that ends with LF, found CRLF");
    if (line == 1 && text != "QGC WPL 110") {
      reader.refuse(fmt::format("expected \"QGC WPL 110\", found \"{}\"", text.substr(0, 60)));
    }
    if (line == 1 || text.empty() || text.starts_with('#')) continue;
    const MissionItem item = reader.item(text, index);
    if (index++ == 0 && item.frame == kGlobal && item.command == kWaypoint) {
      mission.home = {item.latitude, item.longitude, item.altitude};
    } else {
      mission.items.push_back(item);
    }
  }
  if (mission.items.empty()) {
    throw geom::InputError(source, "expected \"QGC WPL 110\" and at least one item, found none");
  }
  return mission;
}

}  // namespace traj
