#include "geom/text/instant.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "geom/base/rounding.h"

namespace geom {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The digits at a place of the text, or -1.
int whole_at(std::string_view text, std::size_t at, std::size_t digits) {
  int value = 0;
  for (const char c : text.substr(at, digits)) {
    if (!is_digit(c)) return -1;
    value = 10 * value + (c - '0');
  }
  return value;
}

int days_in(int year, int month) {
  constexpr std::array kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return kDays[static_cast<std::size_t>(month - 1)] + (month == 2 && leap ? 1 : 0);
}

bool within(int value, int least, int most) { return value >= least && value <= most; }

// "2026-05-04T06:30:00" is an instant.
bool is_instant(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00T00:00:00";
  for (std::size_t i = 0; i < kForm.size(); ++i) {
    const bool right = kForm[i] == '0' ? is_digit(text[i]) : text[i] == kForm[i];
    if (!right) return false;
  }
  const int year = whole_at(text, 0, 4);
  const int month = whole_at(text, 5, 2);
  return within(month, 1, 12) && within(whole_at(text, 8, 2), 1, days_in(year, month)) &&
         within(whole_at(text, 11, 2), 0, 23) && within(whole_at(text, 14, 2), 0, 59) &&
         within(whole_at(text, 17, 2), 0, 59);
}

__extension__ using Whole = __int128;

constexpr int kDigits = 18;                                  // of a second that count one by one
constexpr std::int64_t kSecond = 1'000'000'000'000'000'000;  // attoseconds
constexpr std::int64_t kMillisecond = kSecond / 1000;
constexpr std::int64_t kDaySeconds = 86'400;

// Attoseconds since 1970, rounded down, and whether that left something out.
struct Attoseconds {
  Whole count = 0;
  bool more = false;
};

std::int64_t number_in(std::string_view text) {
  std::int64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// "2026-05-04T06:30:00.25Z"
Attoseconds attoseconds_of(std::string_view instant) {
  using namespace std::chrono;
  assert(epoch_from(instant) == instant);
  const auto part = [&](std::size_t at, std::size_t n) { return number_in(instant.substr(at, n)); };
  const sys_days day = year(static_cast<int>(part(0, 4))) / static_cast<int>(part(5, 2)) /
                       static_cast<int>(part(8, 2));
  const std::int64_t seconds = day.time_since_epoch().count() * kDaySeconds + part(11, 2) * 3600 +
                               part(14, 2) * 60 + part(17, 2);
  Attoseconds out{static_cast<Whole>(seconds) * kSecond};
  if (instant[19] != '.') return out;
  std::string digits(instant.substr(20, instant.size() - 21));
  out.more = digits.size() > kDigits;
  digits.resize(kDigits, '0');
  out.count += number_in(digits);
  return out;
}

// The double, where there is one: 10^18 is 2^18 times 5^18.
std::optional<double> exact_seconds(Whole attoseconds) {
  constexpr std::int64_t kFives = kSecond >> kDigits;
  if (attoseconds % kFives != 0) return std::nullopt;
  const Whole parts = attoseconds / kFives;
  const auto nearest = static_cast<double>(parts);
  if (static_cast<Whole>(nearest) != parts) return std::nullopt;
  return std::ldexp(nearest, -kDigits);
}

// Off by a unit in the last place or less before the steps: two roundings.
double nearly_seconds(Whole attoseconds) {
  return static_cast<double>(attoseconds) / static_cast<double>(kSecond);
}
double seconds_down(Whole attoseconds) {
  const auto exact = exact_seconds(attoseconds);
  return exact ? *exact : next_down(next_down(nearly_seconds(attoseconds)));
}
double seconds_up(Whole attoseconds) { return -seconds_down(-attoseconds); }

// By way of whole 2^-60 s.
Whole attoseconds_down(double seconds) {
  assert(std::abs(seconds) <= 1e10);
  const auto parts = static_cast<Whole>(std::floor(std::ldexp(seconds, 60)));
  const Whole whole = parts >> 60;
  return whole * kSecond + ((parts - (whole << 60)) * kSecond >> 60);
}

// Attoseconds since 1970, rounded down and up, of what is some seconds after an epoch.
Whole sum_down(std::string_view epoch, double seconds) {
  return attoseconds_of(epoch).count + attoseconds_down(seconds);
}
Whole sum_up(std::string_view epoch, double seconds) {
  const Attoseconds from = attoseconds_of(epoch);
  return from.count + (from.more ? 1 : 0) - attoseconds_down(-seconds);
}

std::optional<std::string> text_of(Whole milliseconds) {
  using namespace std::chrono;
  const auto floor_of = [](Whole a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); };
  const Whole seconds = floor_of(milliseconds, 1000);
  const Whole days = floor_of(seconds, kDaySeconds);
  const auto thousandths = static_cast<int>(milliseconds - seconds * 1000);
  const auto second = static_cast<int>(seconds - days * kDaySeconds);
  const sys_days first = year(0) / 1 / 1;
  const sys_days last = year(9999) / 12 / 31;
  if (days < first.time_since_epoch().count() || days > last.time_since_epoch().count()) {
    return std::nullopt;
  }
  const year_month_day date(sys_days(std::chrono::days(static_cast<int>(days))));
  return epoch_from(fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z",
                                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                                static_cast<unsigned>(date.day()), second / 3600, second / 60 % 60,
                                second % 60, thousandths));
}

}  // namespace

std::optional<std::string> epoch_from(std::string_view text) {
  constexpr std::size_t kSeconds = 19;  // characters to the end of the seconds
  if (text.size() <= kSeconds || !is_instant(text)) return std::nullopt;
  std::string out(text.substr(0, kSeconds));
  text.remove_prefix(kSeconds);
  if (text.front() == '.') {
    const std::size_t end = text.find_first_not_of("0123456789", 1);
    if (end == 1 || end == std::string_view::npos) return std::nullopt;
    const std::size_t last = text.substr(0, end).find_last_not_of('0');
    if (last > 0) out += text.substr(0, last + 1);
    text.remove_prefix(end);
  }
  if (text != "Z" && text != "+00:00") return std::nullopt;
  return out + 'Z';
}

SecondsBetween seconds_between(std::string_view epoch, std::string_view instant) {
  const Attoseconds from = attoseconds_of(epoch);
  const Attoseconds to = attoseconds_of(instant);
  const Whole difference = to.count - from.count;
  if (from.more && to.more && epoch == instant) return {};
  return {seconds_down(difference - (from.more ? 1 : 0)),
          seconds_up(difference + (to.more ? 1 : 0))};
}

std::optional<std::string> instant_not_after(std::string_view epoch, double seconds) {
  const Whole at = sum_down(epoch, seconds);
  return text_of(at / kMillisecond - (at % kMillisecond < 0 ? 1 : 0));
}

std::optional<std::string> instant_not_before(std::string_view epoch, double seconds) {
  const Whole at = sum_up(epoch, seconds);
  return text_of(at / kMillisecond + (at % kMillisecond > 0 ? 1 : 0));
}

bool is_not_after(std::string_view instant, std::string_view epoch, double seconds) {
  const Attoseconds at = attoseconds_of(instant);
  return at.count + (at.more ? 1 : 0) <= sum_down(epoch, seconds);
}

bool is_not_before(std::string_view instant, std::string_view epoch, double seconds) {
  return attoseconds_of(instant).count >= sum_up(epoch, seconds);
}

}  // namespace geom
