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

std::optional<Fault> fault_of(std::string_view key, const std::optional<double>& value) {
  if (!value) return std::nullopt;
  if (!(std::abs(*value) <= kLargestTime)) {
    return Fault{.key = std::string(key),
                 .expected = fmt::format("seconds after the epoch within {:g}", kLargestTime),
                 .found = fmt::to_string(*value)};
  }
  if (*value != 0 && std::abs(*value) < kLeastTime) {
    return Fault{.key = std::string(key),
                 .expected = fmt::format("0 or at least {:g} s from the epoch", kLeastTime),
                 .found = fmt::to_string(*value)};
  }
  return std::nullopt;
}

std::optional<std::string> read_epoch(const nlohmann::json& object, const Refusal& refuse) {
  if (!object.contains("epoch") || object["epoch"].is_null()) return std::nullopt;
  const nlohmann::json& value = object["epoch"];
  const auto epoch = value.is_string() ? epoch_from(value.get<std::string>()) : std::nullopt;
  if (!epoch) {
    refuse({.key = "epoch",
            .expected = "an instant in UTC such as \"2026-05-04T06:30:00Z\" (RFC 3339)",
            .found = shown(value)});
  }
  return epoch;
}

std::optional<double> read_seconds(const nlohmann::json& object, const char* key,
                                   const Refusal& refuse) {
  if (!object.contains(key) || object[key].is_null()) return std::nullopt;
  const nlohmann::json& value = object[key];
  if (value.is_number()) return value.get<double>();
  refuse({.key = std::string(key),
          .expected = "a number, seconds after the epoch",
          .found = shown(value),
          .advice = value.is_string() ? "the date of second 0 belongs in \"epoch\"" : ""});
  return std::nullopt;
}

std::optional<int> read_priority(const nlohmann::json& object, const Refusal& refuse) {
  if (!object.contains("priority") || object["priority"].is_null()) return std::nullopt;
  const nlohmann::json& value = object["priority"];
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (is_priority(number)) return static_cast<int>(number);
  refuse({.key = "priority",
          .expected = fmt::format("a whole number within {}", kLargestPriority),
          .found = shown(value)});
  return std::nullopt;
}

}  // namespace

bool is_priority(double value) {
  return std::abs(value) <= kLargestPriority && value == std::floor(value);
}

std::optional<Fault> time_fault(const FlightTime& time) {
  if (auto fault = fault_of("start", time.start)) return fault;
  if (auto fault = fault_of("earliest", time.earliest)) return fault;
  if (auto fault = fault_of("latest", time.latest)) return fault;
  if (time.earliest && time.latest && *time.earliest > *time.latest) {
    return Fault{.key = "earliest",
                 .expected = "at most latest",
                 .found = fmt::format("{} and {}", *time.earliest, *time.latest)};
  }
  if (time.earliest && time.starts() < *time.earliest) {
    return Fault{.key = "start",
                 .expected = "at least earliest",
                 .found = fmt::format("{} and {}", time.starts(), *time.earliest)};
  }
  if (time.latest && time.starts() > *time.latest) {
    return Fault{.key = "start",
                 .expected = "at most latest",
                 .found = fmt::format("{} and {}", time.starts(), *time.latest)};
  }
  return std::nullopt;
}

FlightTime flight_time_of(const nlohmann::json& object, const Refusal& refuse) {
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
  return flight_time_of(fields.object(), [&](Fault fault) { fields.refuse(std::move(fault)); });
}

void require_epoch_agrees(const std::optional<std::string>& epoch,
                          const std::optional<std::string>& ours, std::string_view source,
                          std::size_t line) {
  if (epoch == ours) return;
  const auto words = [](const std::optional<std::string>& one) {
    return one ? '"' + *one + '"' : std::string("none");
  };
  throw InputError(source, line,
                   {.expected = fmt::format("the epoch of the others, {}", words(ours)),
                    .found = std::string(words(epoch)),
                    .advice = "seconds after different instants cannot be compared"});
}

}  // namespace geom
