#include "geom/import/fcnd_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <ostream>

#include "geom/base/rounding.h"
#include "geom/import/box_format.h"
#include "geom/text/beginning.h"
#include "geom/text/number.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

constexpr std::array<const char*, 6> kColumns = {"posX",      "posY",      "posZ",
                                                 "halfSizeX", "halfSizeY", "halfSizeZ"};
constexpr std::array<const char*, 6> kNames = {"position x",  "position y",  "position z",
                                               "half size x", "half size y", "half size z"};
constexpr std::array<const char*, 8> kTurns = {"rot",  "yaw",  "pitch", "roll",
                                               "quat", "head", "angle", "orient"};
using Columns = std::array<std::size_t, 6>;  // which field holds what

bool starts_with_number(std::string_view line) {
  return parse_number(split_fields(line).front()).has_value();
}

// What stands between commas, blanks, or both.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBetween = ",; \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBetween); at != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBetween, end);
  }
  return words;
}

// The number behind a word that stands there once; nothing where it does not, or has no number.
std::optional<double> number_after(std::string_view word, std::span<const std::string_view> words) {
  const auto at = std::find(words.begin(), words.end(), word);
  if (at == words.end() || at + 1 == words.end()) return std::nullopt;
  if (std::find(at + 1, words.end(), word) != words.end()) return std::nullopt;
  return parse_number(*(at + 1));
}

// Whether words are pairs of a name and a number: "lat0 37.79 lon0 -122.39 lat1 37.8 lon1 -122.4".
bool are_named_numbers(std::span<const std::string_view> words) {
  if (words.empty() || words.size() % 2) return false;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const bool name = words[i].starts_with("lat") || words[i].starts_with("lon");
    if (!name || !parse_number(words[i + 1])) return false;
  }
  return true;
}

// Of "lat0 37.79, lon0 -122.39", perhaps with further pairs (lat1, lon1), and of "37.79,-122.39";
// other lines give nothing.
std::optional<GeodeticOrigin> parse_origin(const TextLines& lines) {
  const std::vector<std::string_view> words = words_of(lines.line());
  std::optional<double> latitude;
  std::optional<double> longitude;
  if (are_named_numbers(words)) {
    latitude = number_after("lat0", words);
    longitude = number_after("lon0", words);
  } else if (words.size() == 2) {
    latitude = parse_number(words[0]);
    longitude = parse_number(words[1]);
  }
  if (!latitude || !longitude) return std::nullopt;
  if (!(std::abs(*latitude) <= 90 && std::abs(*longitude) <= 360)) {
    lines.refuse({.key = "latitude",
                  .expected = "within 90 and longitude within 360 degrees",
                  .found = in_quotes(lines.line())});
  }
  return GeodeticOrigin{*latitude, *longitude, 0};
}

// Whether a column's name speaks of a turned box, which this table cannot hold.
bool turns(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::any_of(kTurns.begin(), kTurns.end(),
                     [&](const char* word) { return name.find(word) != std::string::npos; });
}

Columns parse_header(const TextLines& lines, FcndTable& out) {
  const auto fields = split_fields(lines.line());
  for (const std::string& field : fields) {
    if (turns(field)) out.skipped.add("column of turned boxes", field.substr(0, 40));
  }
  Columns columns{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto at = std::find(fields.begin(), fields.end(), kColumns[i]);
    if (at == fields.end()) {
      lines.refuse({.expected = fmt::format("a column {}", kColumns[i]),
                    .found = in_quotes(lines.line().substr(0, 80))});
    }
    if (std::find(at + 1, fields.end(), kColumns[i]) != fields.end()) {
      lines.refuse({.expected = fmt::format("one column {}", kColumns[i]), .found = "another"});
    }
    columns[i] = static_cast<std::size_t>(at - fields.begin());
  }
  return columns;
}

// A comment that names columns would be passed over, and numbers taken in another order.
void require_no_names(const TextLines& lines) {
  const bool names = std::any_of(kColumns.begin(), kColumns.end(), [&](const char* column) {
    return lines.line().find(column) != std::string_view::npos;
  });
  if (!names) return;
  lines.refuse({.expected = "the names of columns in a line of their own",
                .found = "them in a comment",
                .advice = fmt::format("remove the # of \"{}\"", lines.line().substr(0, 80))});
}

void add_box(const TextLines& lines, const Columns& columns, std::size_t width, FcndTable& out) {
  const auto fields = split_fields(lines.line());
  const std::size_t needed = *std::max_element(columns.begin(), columns.end()) + 1;
  if (fields.size() < needed) {
    lines.refuse({.expected = fmt::format("{} fields", needed),
                  .found = fmt::format("{}: \"{}\"", fields.size(), lines.line().substr(0, 80))});
  }
  for (std::size_t i = width; i < fields.size(); ++i) {
    if (fields[i].empty()) continue;
    out.skipped.add("field without a column",
                    fmt::format("line {}: {}", lines.number(), fields[i].substr(0, 40)));
  }
  std::array<double, 6> v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    v[i] = coordinate(lines, kNames[i], fields[columns[i]]);
    if (i >= 3 && v[i] < 0) {
      lines.refuse({.key = std::string(kNames[i]),
                    .expected = ">= 0",
                    .found = in_quotes(fields[columns[i]])});
    }
  }
  const auto zeros = std::count(v.begin() + 3, v.end(), 0.0);
  if (zeros == 3) {
    lines.refuse(
        {.expected = "a half size > 0",
         .found = fmt::format("three zeros (is this a latitude and longitude line?): \"{}\"",
                              lines.line().substr(0, 80))});
  }
  out.flat += zeros > 0;
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    box.min[i] = add_down(v[i], -v[i + 3]);
    box.max[i] = add_up(v[i], v[i + 3]);
    out.largest_change =
        std::max(out.largest_change, ulp(std::abs(box.max[i]) + std::abs(box.min[i])));
  }
  out.table.add(box, lines.number());
}

}  // namespace

FcndTable read_fcnd_csv(std::istream& in, std::string_view source) {
  TextLines lines(in, source, true);
  FcndTable out;
  Columns columns = {0, 1, 2, 3, 4, 5};
  std::size_t width = columns.size();
  bool header = false;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    const bool preamble = !header && out.table.boxes.empty();
    if (preamble && lines.line()[0] == '#') {
      require_no_names(lines);
      continue;
    }
    if (preamble && !out.origin && (out.origin = parse_origin(lines))) continue;
    if (preamble && !starts_with_number(lines.line())) {
      // The three-line form names the two columns of its next line first.
      if (split_fields(lines.line()) == std::vector<std::string>{"lat0", "lon0"}) continue;
      columns = parse_header(lines, out);
      width = split_fields(lines.line()).size();
      header = true;
      continue;
    }
    add_box(lines, columns, width, out);
  }
  if (out.table.boxes.empty()) {
    if (!lines.number()) lines.refuse({.expected = "an FCND table", .found = "an empty file"});
    lines.refuse({.expected = "at least one box after the header", .found = "none"});
  }
  return out;
}

void write_fcnd_csv(std::ostream& out, const GeodeticOrigin& origin,
                    std::span<const CenteredBox> boxes) {
  std::string text = "lat0 ";
  append_number(text, origin.latitude);
  text += ", lon0 ";
  append_number(text, origin.longitude);
  text += "\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n";
  for (const CenteredBox& box : boxes) {
    for (const double v : {box.center[0], box.center[1], box.center[2], box.half[0], box.half[1]}) {
      append_number(text, v);
      text += ',';
    }
    append_number(text, box.half[2]);
    text += '\n';
  }
  out << text;
}

namespace {

ImportedBoxes import_fcnd(std::istream& in, std::string_view source, const ImportOptions&) {
  FcndTable fcnd = read_fcnd_csv(in, source);
  ImportedBoxes out;
  out.table = std::move(fcnd.table);
  out.frame = {Axes::neu, fcnd.origin, ""};
  out.floor = 0;
  out.seal = 1;
  out.flat = fcnd.flat;
  out.largest_change = fcnd.largest_change;
  out.skipped = std::move(fcnd.skipped);
  return out;
}

bool begins_as_fcnd(std::string_view head) {
  const std::string_view text = text_of(head).substr(0, 2000);
  const bool other = text.starts_with('<') || text.starts_with('{') || text.starts_with('[');
  return !other && text.find("halfSizeX") != text.npos;
}

// A line of names or numbers, or nothing: an empty file counts as a table.
bool may_be_fcnd(std::string_view head) {
  const std::string_view line = first_line(head);
  const bool names = line.find("pos") != line.npos || line.find("half") != line.npos;
  const bool numbers = line.find_first_of("0123456789") < 2;
  return line.empty() || names || numbers || line.starts_with("lat0") ||
         line.starts_with("\xef\xbb\xbf");
}

constexpr std::string_view kReaders[] = {"skyway-import"};
constexpr Format kFormat{.word = "fcnd",
                         .what = "an FCND table of boxes",
                         .begins = begins_as_fcnd,
                         .readers = kReaders};

}  // namespace

constinit const BoxFormat kFcnd{.format = &kFormat, .may_be = may_be_fcnd, .read = import_fcnd};

}  // namespace geom
