#include "traj/mission/ulog/ulog_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <istream>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"

namespace traj {
namespace {

using std::string_view_literals::operator""sv;

static_assert(std::endian::native == std::endian::little);  // as the files are

constexpr std::string_view kMagic = "ULog\x01\x12\x35"sv;
constexpr std::size_t kHeader = 16;  // of the file
constexpr std::size_t kFlagBits = 40;
constexpr std::size_t kOffsets = 3;

template <class Value>
Value value_at(std::string_view bytes, std::size_t at) {
  Value value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

double number_at(std::string_view bytes, UlogType type, std::size_t at) {
  switch (type) {
    case UlogType::int8:
      return value_at<std::int8_t>(bytes, at);
    case UlogType::int16:
      return value_at<std::int16_t>(bytes, at);
    case UlogType::uint16:
      return value_at<std::uint16_t>(bytes, at);
    case UlogType::int32:
      return value_at<std::int32_t>(bytes, at);
    case UlogType::uint32:
      return value_at<std::uint32_t>(bytes, at);
    case UlogType::int64:
      return static_cast<double>(value_at<std::int64_t>(bytes, at));
    case UlogType::uint64:
      return static_cast<double>(value_at<std::uint64_t>(bytes, at));
    case UlogType::float32:
      return value_at<float>(bytes, at);
    case UlogType::float64:
      return value_at<double>(bytes, at);
    default:
      return value_at<std::uint8_t>(bytes, at);
  }
}

// The bytes of the file, and where they are in it.
class Bytes {
 public:
  explicit Bytes(std::istream& in) : in_(in) {}

  std::uint64_t at() const { return at_; }

  // As many of `count` as there are; they stay until the next call.
  std::string_view next(std::size_t count) {
    buffer_.resize(count);
    in_.read(buffer_.data(), static_cast<std::streamsize>(count));
    const auto got = static_cast<std::size_t>(in_.gcount());
    at_ += got;
    return {buffer_.data(), got};
  }

 private:
  std::istream& in_;
  std::uint64_t at_ = 0;
  std::string buffer_;
};

class Reader {
 public:
  Reader(std::istream& in, std::string_view source, std::span<const std::string_view> topics,
         const std::function<void(const UlogMessage&)>& take)
      : bytes_(in), source_(source), topics_(topics), take_(take), formats_(source) {}

  UlogSummary read() {
    read_header();
    while (!out_.cut_at && read_message()) {
    }
    return std::move(out_);
  }

 private:
  // Of an id: its layout, where the topic is asked for.
  struct Subscription {
    std::string topic;
    std::optional<UlogLayout> layout;
  };

  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source_, std::move(fault));
  }

  void cut(std::uint64_t at, std::string why) {
    out_.cut_at = at;
    out_.cut_why = std::move(why);
  }

  void read_header() {
    const std::string_view header = bytes_.next(kHeader);
    if (header.substr(0, kMagic.size()) != kMagic) {
      refuse({.expected = "a PX4 log (ULog)",
              .found = geom::in_quotes(geom::excerpt(header.substr(0, kMagic.size())))});
    }
    if (header.size() < kHeader) {
      refuse({.expected = fmt::format("a header of {} bytes", kHeader),
              .found = fmt::to_string(header.size())});
    }
    out_.version = static_cast<unsigned char>(header[7]);
    out_.start = value_at<std::uint64_t>(header, 8);
  }

  // Whether there is another.
  bool read_message() {
    const std::uint64_t begin = bytes_.at();
    const std::string_view head = bytes_.next(before_appended(begin, 3));
    if (head.empty()) return goes_on(begin);
    if (head.size() < 3) return tear(begin);
    const std::size_t size = value_at<std::uint16_t>(head, 0);
    const char kind = head[2];
    const std::string_view body = bytes_.next(before_appended(bytes_.at(), size));
    if (body.size() < size) return tear(begin);
    ++out_.messages;
    take_message(kind, body, begin);
    return true;
  }

  // How many of `count` bytes stand before data that was appended later.
  std::size_t before_appended(std::uint64_t at, std::size_t count) const {
    if (appended_.empty()) return count;
    return static_cast<std::size_t>(std::min<std::uint64_t>(count, appended_.front() - at));
  }

  bool goes_on(std::uint64_t at) {
    if (appended_.empty()) return false;
    if (at < appended_.front()) {
      cut(at, fmt::format("data that was appended at byte {} is not there", appended_.front()));
      return false;
    }
    appended_.erase(appended_.begin());
    return true;
  }

  // A message that breaks off: for good, or where other data was appended.
  bool tear(std::uint64_t begin) {
    if (!appended_.empty() && bytes_.at() == appended_.front()) {
      ++out_.torn;
      appended_.erase(appended_.begin());
      return true;
    }
    cut(begin, "the file ends in the middle of a message");
    return false;
  }

  void take_message(char kind, std::string_view body, std::uint64_t begin) {
    switch (kind) {
      case 'D':
        return take_data(body, begin);
      case 'A':
        return take_subscription(body, begin);
      case 'F':
        return formats_.add(body);
      case 'B':
        return take_flags(body, begin);
      case 'O':
        return take_dropout(body, begin);
      case 'R':
        return take_end_of_subscription(body, begin);
      case 'P':
        return take_parameter(body);
      case 'I':
      case 'M':
      case 'Q':
      case 'L':
      case 'C':
      case 'S':
        return;
      default:
        if (kind < 'A' || kind > 'Z') {
          return cut(begin, fmt::format("expected a message, found one of kind \"{}\"",
                                        geom::excerpt({&kind, 1})));
        }
        ++out_.unknown;
    }
  }

  void take_flags(std::string_view body, std::uint64_t begin) {
    if (begin != kHeader) return cut(begin, "flags stand in the middle of the log");
    if (body.size() < kFlagBits) {
      refuse({.expected = fmt::format("flags of {} bytes", kFlagBits),
              .found = fmt::to_string(body.size())});
    }
    const auto appended = static_cast<unsigned char>(body[8]);
    const std::string_view others = body.substr(9, 7);
    if ((appended & ~1u) != 0 || others.find_first_not_of('\0') != others.npos) {
      refuse(
          {.says =
               "the log says that it has features which readers must know, and this one does not"});
    }
    for (std::size_t i = 0; i < kOffsets && (appended & 1u) != 0; ++i) {
      const auto offset = value_at<std::uint64_t>(body, 16 + 8 * i);
      if (offset == 0) break;
      if (offset < (appended_.empty() ? bytes_.at() : appended_.back() + 1)) {
        refuse({.expected = "appended data after what stands before it",
                .found = fmt::format("byte {}", offset)});
      }
      appended_.push_back(offset);
    }
  }

  // "float NAME" or "int32_t NAME", and its value. Others are passed over, as no flight hangs on
  // them.
  void take_parameter(std::string_view body) {
    const std::size_t length = body.empty() ? 0 : static_cast<unsigned char>(body[0]);
    const std::string_view key = body.substr(std::min<std::size_t>(1, body.size()), length);
    const std::size_t space = key.find(' ');
    if (body.size() != 1 + length + 4 || space == key.npos) return;
    const std::string_view type = key.substr(0, space);
    const std::string name(key.substr(space + 1));
    if (type == "float") out_.parameters[name] = value_at<float>(body, 1 + length);
    if (type == "int32_t") out_.parameters[name] = value_at<std::int32_t>(body, 1 + length);
  }

  void take_subscription(std::string_view body, std::uint64_t begin) {
    out_.has_data = true;  // its section begins with these
    if (body.size() < 4) return cut(begin, "a subscription without a name");
    const std::string_view name = body.substr(3);
    if (!formats_.has(name)) {
      return cut(begin, fmt::format("the format \"{}\" of a subscription is not known",
                                    geom::excerpt(name)));
    }
    const auto id = value_at<std::uint16_t>(body, 1);
    Subscription subscription{std::string(name), std::nullopt};
    const bool wanted = std::find(topics_.begin(), topics_.end(), name) != topics_.end();
    const bool taken = wanted && body[0] == 0;  // of the topic's first instance
    if (taken) subscription.layout = layout_of(name);
    const auto [known, fresh] = subscriptions_.emplace(id, std::move(subscription));
    if (!fresh && (known->second.topic != name || known->second.layout.has_value() != taken)) {
      cut(begin, fmt::format("the number {} stands for two topics", id));
    }
  }

  UlogLayout layout_of(std::string_view name) const {
    UlogLayout layout = formats_.layout(name);
    const auto time = layout.fields.find("timestamp");
    if (time == layout.fields.end() || time->second.type != UlogType::uint64) {
      refuse({.item = fmt::format("format {}", geom::excerpt(name)),
              .expected = "a field \"uint64_t timestamp\"",
              .found = "none"});
    }
    return layout;
  }

  void take_data(std::string_view body, std::uint64_t begin) {
    const auto found = body.size() < 2 ? subscriptions_.end()
                                       : subscriptions_.find(value_at<std::uint16_t>(body, 0));
    if (found == subscriptions_.end()) return cut(begin, "data of no topic");
    const auto& [topic, layout] = found->second;
    if (!layout) return;
    const std::string_view data = body.substr(2);
    if (data.size() < layout->least || data.size() > layout->size) {
      return cut(begin, fmt::format("expected {} bytes of {}, found {}", layout->size,
                                    geom::excerpt(topic), data.size()));
    }
    take_(UlogMessage(topic, *layout, data));
  }

  void take_dropout(std::string_view body, std::uint64_t begin) {
    if (body.size() < 2) return cut(begin, "a dropout without a duration");
    const double seconds = 1e-3 * value_at<std::uint16_t>(body, 0);
    ++out_.dropouts;
    out_.dropout_seconds += seconds;
    out_.longest_dropout = std::max(out_.longest_dropout, seconds);
  }

  void take_end_of_subscription(std::string_view body, std::uint64_t begin) {
    if (body.size() < 2 || subscriptions_.erase(value_at<std::uint16_t>(body, 0)) == 0) {
      cut(begin, "the end of a subscription that there is not");
    }
  }

  Bytes bytes_;
  std::string source_;
  std::span<const std::string_view> topics_;
  const std::function<void(const UlogMessage&)>& take_;
  UlogFormats formats_;
  std::unordered_map<std::uint16_t, Subscription> subscriptions_;
  std::vector<std::uint64_t> appended_;  // where data was appended, ahead
  UlogSummary out_;
};

}  // namespace

std::uint64_t UlogMessage::timestamp() const {
  return value_at<std::uint64_t>(bytes_, layout_.fields.find("timestamp")->second.at);
}

std::optional<double> UlogMessage::number(std::string_view field, std::size_t i) const {
  const auto found = layout_.fields.find(field);
  if (found == layout_.fields.end() || i >= found->second.count ||
      found->second.type == UlogType::character) {
    return std::nullopt;
  }
  const double value =
      number_at(bytes_, found->second.type, found->second.at + i * size_of(found->second.type));
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<bool> UlogMessage::flag(std::string_view field) const {
  const auto value = number(field);
  return value ? std::optional(*value != 0) : std::nullopt;
}

UlogSummary read_ulog(std::istream& in, std::string_view source,
                      std::span<const std::string_view> topics,
                      const std::function<void(const UlogMessage&)>& take) {
  return Reader(in, source, topics, take).read();
}

}  // namespace traj
