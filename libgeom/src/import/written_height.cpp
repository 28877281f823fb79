#include "import/written_height.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "geom/text/text_table.h"

namespace geom {
namespace {

using Words = std::initializer_list<std::string_view>;

constexpr double kFoot = 0.3048;
constexpr double kInch = 0.0254;
constexpr double kHighest = 1000;  // metres, of anything built
constexpr double kLongest = 1e4;
constexpr double kMostLevels = 300;
constexpr std::string_view kDigits = "0123456789";

struct Unit {
  double metres;
  std::string_view word;
};

constexpr std::array kUnits{Unit{1, "m"},         Unit{1, "metre"},    Unit{1, "metres"},
                            Unit{1, "meter"},     Unit{1, "meters"},   Unit{kFoot, "ft"},
                            Unit{kFoot, "feet"},  Unit{kFoot, "foot"}, Unit{0.01, "cm"},
                            Unit{1000, "km"},     Unit{kInch, "in"},   Unit{kInch, "inch"},
                            Unit{kInch, "inches"}};

// Text that is taken from the left, piece by piece.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(trimmed(text)) {}

  bool done() const { return rest_.empty(); }

  bool take(std::string_view piece) {
    if (!rest_.starts_with(piece)) return false;
    rest_ = trimmed(rest_.substr(piece.size()));
    return true;
  }
  bool take_one_of(Words pieces) {
    return std::any_of(pieces.begin(), pieces.end(), [&](auto piece) { return take(piece); });
  }

  // A whole word of letters, in any case.
  bool take_word(Words words) {
    std::size_t size = 0;
    while (size < rest_.size() && std::isalpha(static_cast<unsigned char>(rest_[size]))) ++size;
    std::string word(rest_.substr(0, size));
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (size == 0 || std::find(words.begin(), words.end(), word) == words.end()) return false;
    rest_ = trimmed(rest_.substr(size));
    return true;
  }

  // The characters of a number without its sign; empty where there is none.
  std::string_view take_digits() {
    std::size_t size = std::min(rest_.find_first_not_of("0123456789.,"), rest_.size());
    const std::string_view digits = rest_.substr(0, size);
    if (digits.find_first_of(kDigits) == digits.npos) return {};
    rest_ = trimmed(rest_.substr(size));
    return digits;
  }

  // Between two values: "3;4", "3-5", "3 – 5".
  bool take_separator() { return take_one_of({";", "-", "\u2013", "\u2014"}); }

 private:
  std::string_view rest_;
};

// Digits with one point or comma for decimals.
std::optional<double> decimal(std::string_view digits) {
  std::string plain(digits);
  std::replace(plain.begin(), plain.end(), ',', '.');
  if (std::count(plain.begin(), plain.end(), '.') > 1) return std::nullopt;
  return parse_number(plain);
}

// Digits in groups of three between commas, and perhaps a point for decimals: "1,250.5".
std::optional<double> grouped(std::string_view digits) {
  const std::string_view whole = digits.substr(0, digits.find('.'));
  std::size_t begin = whole.find(',');
  if (begin == 0 || begin > 3 || whole.front() == '0') return std::nullopt;
  for (; begin < whole.size(); begin += 4) {
    const bool group = whole[begin] == ',' && begin + 4 <= whole.size() &&
                       whole.substr(begin + 1, 3).find_first_not_of(kDigits) == whole.npos;
    if (!group) return std::nullopt;
  }
  std::string plain(digits);
  std::erase(plain, ',');
  return decimal(plain);
}

// In metres, of digits that count units of so many.
std::optional<double> metres_of(std::string_view digits, double unit) {
  const auto plain = decimal(digits);
  const auto thousands = grouped(digits);
  const bool taken = thousands && (!plain || *thousands * unit < kHighest);
  const auto value = taken ? thousands : plain;
  if (!value) return std::nullopt;
  return *value * unit;
}

// "6 in", "-11\"" behind feet; or without a unit where nothing follows: "7'4". Moves on only where
// such inches stand there.
std::optional<double> take_inches(Reader& reader, bool marked) {
  Reader ahead = reader;
  const bool dash = ahead.take("-");
  const auto inches = decimal(ahead.take_digits());
  if (!inches || !(*inches < 12)) return std::nullopt;
  const bool unit = ahead.take_one_of({"\"", "''", "\u2033", "\u201d"}) ||
                    ahead.take_word({"in", "inch", "inches"});
  if (!unit && !(marked && !dash && ahead.done())) return std::nullopt;
  ahead.take(".");
  reader = ahead;
  return *inches * kInch;
}

// Whether "-11" follows feet, and no unit follows it: inches, or another length.
bool is_at_bare_inches(Reader reader) {
  if (!reader.take_one_of({"-", "\u2013", "\u2014"})) return false;
  const auto number = decimal(reader.take_digits());
  return number && *number < 12 && (reader.done() || reader.take_separator());
}

// One value of a list; its metres are known once its unit is.
struct Length {
  std::string_view digits;
  bool negative = false;
  double unit = 0;  // metres; 0: none was named
  double inches = 0;
  bool listed = false;  // behind a semicolon

  std::optional<double> metres(double bare) const {
    const auto value = metres_of(digits, unit > 0 ? unit : bare);
    if (!value || !(*value + inches <= kLongest)) return std::nullopt;
    return negative ? -(*value + inches) : *value + inches;
  }
};

double take_unit(Reader& reader) {
  for (const Unit& unit : kUnits) {
    if (!reader.take_word({unit.word})) continue;
    reader.take(".");
    return unit.metres;
  }
  return 0;
}

std::optional<Length> take_length(Reader& reader) {
  Length out;
  reader.take_one_of({"~", "\u2248"});
  out.negative = reader.take("-");
  if (!out.negative) reader.take("+");
  out.digits = reader.take_digits();
  if (out.digits.empty()) return std::nullopt;
  const bool marked = !Reader(reader).take("''") && reader.take_one_of({"'", "\u2032", "\u2019"});
  out.unit = marked ? kFoot : take_unit(reader);
  if (out.unit != kFoot) return out;
  if (const auto inches = take_inches(reader, marked)) {
    out.inches = *inches;
  } else if (is_at_bare_inches(reader)) {
    return std::nullopt;
  }
  return out;
}

// All values of a list, in metres; none where anything in it is not understood.
std::vector<double> lengths_of(std::string_view text, double bare) {
  Reader reader(text);
  std::vector<Length> list;
  bool semicolon = false;
  do {
    const auto length = take_length(reader);
    if (!length) return {};
    list.push_back(*length);
    list.back().listed = semicolon;
    semicolon = reader.take(";");
  } while (semicolon || reader.take_separator());
  if (!reader.done()) return {};
  std::vector<double> out;
  double unit = 0;
  bool listed = false;
  for (auto one = list.rbegin(); one != list.rend(); ++one) {
    if (one->unit == 0 && unit > 0) {
      if (listed && unit != bare) return {};  // "3;40 ft": three of what?
      one->unit = unit;
    }
    unit = one->unit;
    listed = one->listed;
    const auto metres = one->metres(bare);
    if (!metres) return {};
    out.push_back(*metres);
  }
  return out;
}

// A sum of storeys; `exact`: without a sum.
std::optional<double> take_levels(Reader& reader, bool exact) {
  const bool negative = reader.take("-");
  double sum = 0;
  bool more = false;
  do {
    const bool ground = reader.take_word({"g", "gf", "eg", "r", "rdc"});
    if (!ground) reader.take_word({"l"});
    const std::string_view digits = ground ? "1" : reader.take_digits();
    if (digits.empty() || digits.find(',') != digits.npos) return std::nullopt;
    const auto levels = parse_number(digits);
    if (!levels) return std::nullopt;
    sum += *levels;
    const bool again = reader.take("+");
    if ((ground && !more && !again) || (again && (exact || negative))) return std::nullopt;
    more = again;
  } while (more);
  reader.take_word({"storey", "storeys", "story", "stories", "floor", "floors", "level", "levels"});
  if (!(sum <= kMostLevels)) return std::nullopt;
  return negative ? -sum : sum;
}

std::vector<double> levels_of(std::string_view text, bool exact) {
  Reader reader(text);
  std::vector<double> out;
  do {
    const auto levels = take_levels(reader, exact);
    if (!levels) return {};
    out.push_back(*levels);
  } while (reader.take_separator());
  return reader.done() ? out : std::vector<double>{};
}

std::optional<double> largest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return *std::max_element(values.begin(), values.end());
}

std::optional<double> smallest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return *std::min_element(values.begin(), values.end());
}

}  // namespace

std::optional<double> parse_highest(std::string_view text, double bare) {
  return largest(lengths_of(text, bare));
}

std::optional<double> parse_lowest(std::string_view text, double bare) {
  return smallest(lengths_of(text, bare));
}

std::optional<double> parse_levels(std::string_view text) {
  return largest(levels_of(text, false));
}

std::optional<double> parse_lowest_level(std::string_view text) {
  return smallest(levels_of(text, true));
}

}  // namespace geom
