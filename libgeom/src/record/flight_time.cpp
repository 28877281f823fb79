#include "geom/record/flight_time.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"
#include "read_flight_time.h"

namespace geom {
namespace {

std::optional<std::string> fault_of(std::string_view key, const std::optional<double>& value) {
  if (!value) return std::nullopt;
  if (!(std::abs(*value) <= kLargestTime)) {
    return fmt::format("{} must be seconds after the epoch within {:g}, found {}", key,
                       kLargestTime, *value);
  }
  if (*value != 0 && std::abs(*value) < kLeastTime) {
    return fmt::format("{} must be 0 or at least {:g} s from the epoch, found {}", key, kLeastTime,
                       *value);
  }
  return std::nullopt;
}

std::optional<std::string> read_epoch(const nlohmann::json& object,
                                      const std::function<void(const std::string&)>& refuse) {
  if (!object.contains("epoch") || object["epoch"].is_null()) return std::nullopt;
  const nlohmann::json& value = object["epoch"];
  const auto epoch = value.is_string() ? epoch_from(value.get<std::string>()) : std::nullopt;
  if (!epoch) {
    refuse("epoch must be an instant in UTC such as \"2026-05-04T06:30:00Z\" (RFC 3339), found " +
           shown(value));
  }
  return epoch;
}

std::optional<double> read_seconds(const nlohmann::json& object, const char* key,
                                   const std::function<void(const std::string&)>& refuse) {
  if (!object.contains(key) || object[key].is_null()) return std::nullopt;
  const nlohmann::json& value = object[key];
  if (value.is_number()) return value.get<double>();
  refuse(fmt::format("{} must be a number, seconds after the epoch, found {}{}", key, shown(value),
                     value.is_string() ? ": the date of second 0 belongs in \"epoch\"" : ""));
  return std::nullopt;
}

std::optional<int> read_priority(const nlohmann::json& object,
                                 const std::function<void(const std::string&)>& refuse) {
  if (!object.contains("priority") || object["priority"].is_null()) return std::nullopt;
  const nlohmann::json& value = object["priority"];
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (is_priority(number)) return static_cast<int>(number);
  refuse(fmt::format("priority must be a whole number within {}, found {}", kLargestPriority,
                     shown(value)));
  return std::nullopt;
}

}  // namespace

bool is_priority(double value) {
  return std::abs(value) <= kLargestPriority && value == std::floor(value);
}

std::optional<std::string> time_fault(const FlightTime& time) {
  if (auto fault = fault_of("start", time.start)) return fault;
  if (auto fault = fault_of("earliest", time.earliest)) return fault;
  if (auto fault = fault_of("latest", time.latest)) return fault;
  if (time.earliest && time.latest && *time.earliest > *time.latest) {
    return fmt::format("earliest must be at most latest, found {} and {}", *time.earliest,
                       *time.latest);
  }
  if (time.earliest && time.starts() < *time.earliest) {
    return fmt::format("start must be at least earliest, found {} and {}", time.starts(),
                       *time.earliest);
  }
  if (time.latest && time.starts() > *time.latest) {
    return fmt::format("start must be at most latest, found {} and {}", time.starts(),
                       *time.latest);
  }
  return std::nullopt;
}

FlightTime flight_time_of(const nlohmann::json& object,
                          const std::function<void(const std::string&)>& refuse) {
  FlightTime time;
  time.epoch = read_epoch(object, refuse);
  time.start = read_seconds(object, "start", refuse);
  time.earliest = read_seconds(object, "earliest", refuse);
  time.latest = read_seconds(object, "latest", refuse);
  time.priority = read_priority(object, refuse);
  if (const auto fault = time_fault(time)) refuse(*fault);
  return time;
}

void add(JsonLine& line, const FlightTime& time) {
  line.add("epoch", time.epoch).add("start", time.start);
  line.add("earliest", time.earliest).add("latest", time.latest).add("priority", time.priority);
}

FlightTime read_flight_time(const JsonFields& fields) {
  return flight_time_of(fields.object(),
                        [&](const std::string& message) { fields.refuse(message); });
}

void require_epoch_agrees(const std::optional<std::string>& epoch,
                          const std::optional<std::string>& ours, std::string_view source,
                          std::size_t line) {
  if (epoch == ours) return;
  const auto words = [](const std::optional<std::string>& one) {
    return one ? '"' + *one + '"' : std::string("none");
  };
  throw InputError(source, line,
                   fmt::format("expected the epoch of the others, {}, found {}: seconds after "
                               "different instants cannot be compared",
                               words(ours), words(epoch)));
}

}  // namespace geom
