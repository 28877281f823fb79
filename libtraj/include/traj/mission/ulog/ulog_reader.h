#pragma once

// PX4's binary flight logs (ULog, versions 1 and 2), message by message.
//
// Example:
//   std::ifstream in("hop.ulg", std::ios::binary);
//   const std::string_view topics[] = {"battery_status"};
//   traj::read_ulog(in, "hop.ulg", topics, [](const traj::UlogMessage& message) {
//     if (const auto left = message.number("remaining")) std::cout << 100 * *left << " %\n";
//   });
//
// The format is described at docs.px4.io, "ULog File Format".

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "traj/mission/ulog/ulog_format.h"

namespace traj {

// One logged message of a topic, while it is being taken.
class UlogMessage {
 public:
  UlogMessage(std::string_view topic, const UlogLayout& layout, std::string_view bytes)
      : topic_(topic), layout_(layout), bytes_(bytes) {}

  std::string_view topic() const { return topic_; }
  std::uint64_t timestamp() const;  // microseconds since the vehicle was switched on

  // The i-th value of a field. Nothing if the format has none, for text, and for a value that is
  // not finite, by which PX4 means "not known".
  std::optional<double> number(std::string_view field, std::size_t i = 0) const;
  std::optional<bool> flag(std::string_view field) const;  // whether it is not 0

 private:
  std::string_view topic_;
  const UlogLayout& layout_;
  std::string_view bytes_;
};

// A summary of a log.
struct UlogSummary {
  int version = 0;
  std::uint64_t start = 0;     // microseconds: when logging began
  std::size_t messages = 0;    // of all kinds
  std::size_t unknown = 0;     // of kinds that this reader does not know: passed over
  std::size_t dropouts = 0;    // times that the vehicle could not write all it had to log
  double dropout_seconds = 0;  // all of them together
  double longest_dropout = 0;  // s
  std::size_t torn = 0;        // messages that broke off where data was appended later
  // The byte at which the rest was left, because a message is longer than the file, or cannot be
  // one.
  std::optional<std::uint64_t> cut_at;
  std::string cut_why;
  std::map<std::string, double> parameters;  // the last value of each
  bool has_data = false;  // it goes on after its definitions, so that all parameters are there
};

// Gives `take` each message of the `topics`, in the order of the file, of the first instance of
// each (multi_id 0). One message is held at a time. A log that breaks off, or goes on with bytes
// that are no message, is read up to there (`cut_at`); one cut exactly between two messages looks
// whole, as a log does not say how long it is. Throws geom::InputError if it is no ULog, for
// features that are marked as incompatible, for appended data whose place cannot be, and for
// formats of `topics` that are no formats (ulog_format.h) or have no time.
UlogSummary read_ulog(std::istream& in, std::string_view source,
                      std::span<const std::string_view> topics,
                      const std::function<void(const UlogMessage&)>& take);

}  // namespace traj
