#include "strict_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "geom/error.h"

namespace traj {
namespace {

constexpr int kDeepest = 100;

std::size_t line_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

DroneJson parse_strict_json(std::string_view text, std::string_view source) {
  using Event = DroneJson::parse_event_t;
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const auto watch = [&](int depth, Event event, DroneJson& value) {
    if (depth > kDeepest) {
      throw geom::InputError(
          source, fmt::format("expected JSON nested at most {} deep, found more", kDeepest));
    }
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(value.get<std::string>()).second) {
      throw geom::InputError(
          source,
          fmt::format("expected the key {} once in an object, found it again", shown(value)));
    }
    return true;
  };
  try {
    return DroneJson::parse(text, watch);
  } catch (const DroneJson::parse_error& error) {
    const bool cut = error.byte > text.size();
    throw geom::InputError(
        source, line_of(text, error.byte),
        cut ? std::string("expected JSON, found its end too early: the file "
                          "may be cut")
            : fmt::format("expected JSON, found something else at byte {}", error.byte));
  } catch (const DroneJson::exception&) {  // a number beyond what a double holds
    throw geom::InputError(source, "expected JSON numbers within the range of a double");
  }
}

std::string shown(const DroneJson& value) {
  if (value.is_structured()) return fmt::format("an {} of {}", value.type_name(), value.size());
  const std::string text = value.dump(-1, ' ', true, DroneJson::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

}  // namespace traj
