#include "traj/mission/formats/wpl.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <istream>
#include <ostream>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/text/beginning.h"
#include "geom/text/number.h"
#include "mission/formats/mavlink_format.h"
#include "mission/formats/text_head.h"
#include "traj/mission/formats/fence_file.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/mission/mavlink/mission_flight.h"

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

  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source, line, std::move(fault));
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
      refuse({.expected = "12 fields separated by tabs", .found = fmt::to_string(count)});
    }
    return values;
  }

  double number(std::string_view text, const char* name) const {
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || rest != text.data() + text.size() || std::isinf(value)) {
      refuse({.key = std::string(name),
              .expected = "a number with a decimal point",
              .found = geom::in_quotes(text.substr(0, 40))});
    }
    return value;
  }

  int whole(double value, const char* name) const {
    if (value != std::floor(value) || value < 0 || value > 65535) {
      refuse({.key = std::string(name),
              .expected = "a whole number from 0 to 65535",
              .found = fmt::to_string(value)});
    }
    return static_cast<int>(value);
  }

  // `least`: the number that the item must have at least.
  MissionItem item(std::string_view text, std::size_t least) const {
    const auto v = fields(text);
    if (!(v[0] >= static_cast<double>(least) && v[0] <= 1e9) || v[0] != std::floor(v[0])) {
      refuse({.key = "index",
              .expected = fmt::format("a whole number from {} on", least),
              .found = fmt::to_string(v[0])});
    }
    const auto index = static_cast<std::size_t>(v[0]);
    for (const int k : {1, 2, 3, 10, 11}) {
      if (std::isnan(v[static_cast<std::size_t>(k)]))
        refuse({.key = std::string(kNames[static_cast<std::size_t>(k)]),
                .expected = "a number",
                .found = "nan"});
    }
    for (const int flag : {1, 11}) {
      if (v[flag] != 0 && v[flag] != 1) {
        refuse({.key = std::string(kNames[flag]),
                .expected = "0 or 1",
                .found = fmt::to_string(v[flag])});
      }
    }
    // A vehicle begins at the item that is current: the first, be it home, or the one after home.
    if (v[1] == 1 && index > 1)
      refuse({.key = "current", .expected = "0 after the first two items", .found = "1"});
    return {whole(v[2], "frame"),
            whole(v[3], "command"),
            {v[4], v[5], v[6], v[7]},
            v[8],
            v[9],
            v[10],
            line,
            index,
            0,
            v[11] == 1};
  }
};

constexpr MavCommand kFenceCorners[] = {kCornerToStayIn, kCornerToStayOut};
constexpr MavCommand kFenceCircles[] = {kCircleToStayIn, kCircleToStayOut};

class WplReader {
 public:
  WplReader(std::istream& in, std::string_view source) : in_(in), source_(source) {}

  const Mission& read() {
    std::string text;
    for (line_ = 1; std::getline(in_, text); ++line_) {
      std::string_view line = text;
      if (line_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line_ == 1) {
        read_header(line);
      } else if (!line.empty() && !line.starts_with('#')) {
        take(LineReader{source_, line_}.item(line, next_));
      }
    }
    finish();
    return mission_;
  }

  void require_mission() const {
    if (!mission_.items.empty()) return;
    const bool others = !mission_.fences.empty() || !mission_.rally.empty();
    if (others) {
      throw geom::InputError(source_,
                             {.expected = "a mission", .found = "only a fence or rally points"});
    }
    throw geom::InputError(source_,
                           {.expected = "\"QGC WPL 110\" and at least one item", .found = "none"});
  }

 private:
  void read_header(std::string_view line) {
    if (line != "QGC WPL 110" && line != "QGC WPL 120") {
      LineReader{source_, line_}.refuse(
          {.expected = "\"QGC WPL 110\"", .found = geom::in_quotes(line.substr(0, 60))});
    }
    has_home_ = line.ends_with("110");
  }

  void take(const MissionItem& item) {
    if (mission_.items.size() >= kMostItems) {
      refuse({.expected = fmt::format("at most {} items", kMostItems), .found = "more"});
    }
    const bool first = next_ == 0 && item.number == 0;
    skips_ = skips_ || item.number != next_;
    next_ = item.number + 1;
    if (first && has_home_ && item.frame == kGlobal && item.command == kWaypoint) {
      has_home_ = false;  // no other item stands in its place
      take_home(item);
    } else if (item.command == kRallyPoint) {
      beside_ = true;
      require_above_home(item);
      mission_.rally.push_back({item.latitude, item.longitude, item.altitude});
    } else if (take_fence(item)) {
      beside_ = true;
    } else {
      mission_.first_for_home = mission_.first_for_home || (mission_.items.empty() && has_home_);
      // A ground station uploads fences and rally points apart, and counts the items without them.
      skips_ = skips_ || beside_;
      mission_.items.push_back(item);
    }
  }

  void require_above_home(const MissionItem& rally) const {
    if (rally.frame == kGlobalRelative || rally.frame == kGlobalRelativeInt) return;
    refuse({.key = "frame",
            .expected = "3 or 6 for a rally point, whose height counts from home",
            .found = fmt::to_string(rally.frame)});
  }

  // A file that was saved without a vehicle has zeros there.
  void take_home(const MissionItem& item) {
    if (item.latitude != 0 || item.longitude != 0) {
      mission_.home = {item.latitude, item.longitude, item.altitude};
    } else {
      mission_.notes.emplace_back(
          "its home is latitude 0, longitude 0, which is taken for none: home is below the first "
          "point");
    }
  }

  // Corners of a polygon stand together, and each says how many they are.
  bool take_fence(const MissionItem& item) {
    if (item.command == kFenceReturn) return true;
    for (const int i : {0, 1}) {
      if (item.command == kFenceCircles[i]) {
        mission_.fences.push_back({i == 0, {}, {item.latitude, item.longitude, 0}, item.param[0]});
        return true;
      }
      if (item.command != kFenceCorners[i]) continue;
      const double corners = item.param[0];
      if (corners_left_ == 0) {
        if (!(corners >= 3 && corners <= 1e5) || corners != std::floor(corners)) {
          refuse({.says = "a fence must have 3 corners or more", .found = fmt::to_string(corners)});
        }
        corners_left_ = static_cast<std::size_t>(corners);
        mission_.fences.push_back({i == 0, {}, {}, 0});
      }
      GeodeticFence& fence = mission_.fences.back();
      const double left = static_cast<double>(fence.ring.size() + corners_left_);
      if (fence.inclusion != (i == 0) || corners != left) {
        refuse({.expected = fmt::format("{} more corners of the fence before", corners_left_),
                .found = "another"});
      }
      fence.ring.push_back({item.latitude, item.longitude, 0});
      --corners_left_;
      return true;
    }
    return false;
  }

  void finish() {
    if (corners_left_ > 0) {
      throw geom::InputError(source_,
                             {.expected = fmt::format("{} more corners of a fence", corners_left_),
                              .found = "the end of the file"});
    }
    if (!skips_) return;
    for (const MissionItem& item : mission_.items) {
      if (item.command != kJump) continue;
      throw geom::InputError(
          source_, item.line,
          {.expected = "numbers that begin at 0 and leave none out, as a jump counts on them",
           .found = "others"});
    }
    mission_.notes.emplace_back(
        "the numbers of its items do not count 0, 1, 2, …: a ground station counts them anew");
  }

  [[noreturn]] void refuse(geom::Fault fault) const {
    LineReader{source_, line_}.refuse(std::move(fault));
  }

  std::istream& in_;
  std::string_view source_;
  std::size_t line_ = 1;
  std::size_t next_ = 0;  // number of the next item
  bool has_home_ = false;
  bool skips_ = false;
  bool beside_ = false;  // a fence or a rally point stood before
  std::size_t corners_left_ = 0;
  Mission mission_;
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

namespace {

void append_home(std::string& text, const Mission& mission) {
  const geom::GeodeticPlace home = mission.home.value_or(geom::GeodeticPlace{});
  append_item(text, 0, {kGlobal, kWaypoint, {}, home.latitude, home.longitude, home.height, 0});
}

}  // namespace

void write_wpl_fences(std::ostream& out, const Mission& mission) {
  std::string text = "QGC WPL 110\n";
  append_home(text, mission);
  std::size_t index = 1;
  for (const GeodeticFence& fence : mission.fences) {
    const bool circle = fence.ring.empty();
    const std::vector<geom::GeodeticPlace> places = circle ? std::vector{fence.centre} : fence.ring;
    const auto& commands = circle ? kFenceCircles : kFenceCorners;
    const double param = circle ? fence.radius : static_cast<double>(places.size());
    for (const geom::GeodeticPlace& place : places) {
      append_item(text, index++,
                  {kGlobalRelative,
                   commands[fence.inclusion ? 0 : 1],
                   {param},
                   place.latitude,
                   place.longitude,
                   0});
    }
  }
  out << text;
}

void write_wpl_rally(std::ostream& out, const Mission& mission) {
  std::string text = "QGC WPL 110\n";
  append_home(text, mission);
  std::size_t index = 1;
  for (const geom::GeodeticPlace& place : mission.rally) {
    append_item(text, index++,
                {kGlobalRelative, kRallyPoint, {}, place.latitude, place.longitude, place.height});
  }
  out << text;
}

Mission read_wpl(std::istream& in, std::string_view source) {
  WplReader reader(in, source);
  Mission mission = reader.read();
  reader.require_mission();
  return mission;
}

std::vector<GeodeticFence> read_wpl_fences(std::istream& in, std::string_view source) {
  return WplReader(in, source).read().fences;
}

std::vector<geom::GeodeticPlace> read_wpl_rally(std::istream& in, std::string_view source) {
  return WplReader(in, source).read().rally;
}

namespace {

template <class Write>
std::string text_of(const Write& write, const Mission& mission) {
  geom::TextOutput text;
  write(text, mission);
  return text.str();
}

WrittenMission write(const MissionTask& task, const geom::Polyline& legs) {
  return write_mission(task, legs, [](const Mission& mission, const MissionTask&) {
    WrittenMission written{text_of(write_wpl, mission)};
    if (!mission.fences.empty()) written.fences = text_of(write_wpl_fences, mission);
    if (!mission.rally.empty()) written.rally = text_of(write_wpl_rally, mission);
    return written;
  });
}

}  // namespace

constinit const MissionFormat kWpl = mavlink_format(
    {.word = "wpl",
     .what = "a mission (WPL)",
     .begins =
         [](std::string_view head) {
           return geom::begins_with<"QGC WPL">(head) && !is_fence_text(head);
         },
     .readers = kDroneReaders},
    [](std::string_view text) { return text_head(text).starts_with("QGC WPL"); },
    [](std::istream& in, const ReadTask& task) {
      return fly_mission(read_wpl(in, task.source), task);
    },
    write, {FileOption::fence_out, FileOption::rally_out});

}  // namespace traj
