#include "geom/import/fcnd_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <mutex>
#include <optional>
#include <ostream>
#include <utility>

#include "geom/base/in_order.h"
#include "geom/base/rounding.h"
#include "geom/import/box_format.h"
#include "geom/text/beginning.h"
#include "geom/text/number.h"
#include "geom/text/text_table.h"
#include "text/line_blocks.h"
#include "text/short_row.h"

namespace geom {
namespace {

constexpr std::uint64_t kShare = std::uint64_t{1} << 20;  // bytes that are worth a thread

constexpr std::array<const char*, 6> kColumns = {"posX",      "posY",      "posZ",
                                                 "halfSizeX", "halfSizeY", "halfSizeZ"};
constexpr std::array<const char*, 6> kNames = {"position x",  "position y",  "position z",
                                               "half size x", "half size y", "half size z"};
// Columns that say nothing about where a box is. Any other may turn, move or measure it.
constexpr std::array<std::string_view, 16> kNoPlace = {
    "",     "class", "color", "colour", "comment", "description", "id",   "index",
    "kind", "label", "name",  "note",   "notes",   "remark",      "tags", "type"};
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

bool may_place(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(kNoPlace.begin(), kNoPlace.end(), name) == kNoPlace.end();
}

Columns parse_header(const TextLines& lines, FcndTable& out) {
  const auto fields = split_fields(lines.line());
  for (const std::string& field : fields) {
    const bool known = std::find(kColumns.begin(), kColumns.end(), field) != kColumns.end();
    if (!known && may_place(field)) {
      out.skipped.add("column that may turn or move boxes", field.substr(0, 40));
    }
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

using Numbers = std::array<double, 6>;  // centre and half sizes

// Returns what is behind the line feed. Null if there is more than blanks before it.
const char* line_end(const char* at, const char* end) {
  while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
  if (at == end) return at;
  return *at == '\n' ? at + 1 : nullptr;
}

// Null where no number of a double begins.
const char* read_field(const char* at, const char* end, double& value) {
  if (const char* const behind = read_short(at, end, value)) return behind;
  const auto [behind, error] = read_number(at, end, value);
  return error == std::errc() ? behind : nullptr;
}

// Six plain numbers between commas, perhaps with blanks, as nearly all lines have them. Returns
// what is behind the line; null where the line may be anything else.
const char* read_plain_line(const char* at, const char* end, Numbers& fields) {
  const auto pass_blanks = [&] {
    while (at != end && (*at == ' ' || *at == '\t')) ++at;
  };
  for (std::size_t i = 0; i < fields.size(); ++i) {
    pass_blanks();
    at = read_field(at, end, fields[i]);
    if (!at) return nullptr;
    if (i + 1 == fields.size()) break;
    pass_blanks();
    if (at == end || *at++ != ',') return nullptr;
  }
  return line_end(at, end);
}

// Fields in place `columns`; nothing where a line of them needs a closer look.
std::optional<Numbers> plain_numbers(const Numbers& fields, const Columns& columns) {
  Numbers v;
  bool ok = true;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (columns[i] >= fields.size()) return std::nullopt;
    v[i] = fields[columns[i]];
    ok &= std::abs(v[i]) <= kLargestCoordinate;
  }
  ok &= v[3] >= 0 && v[4] >= 0 && v[5] >= 0 && v[3] + v[4] + v[5] > 0;
  return ok ? std::optional(v) : std::nullopt;
}

// Of any line, or its refusal.
Numbers checked_numbers(const TextLines& lines, const Columns& columns, std::size_t width,
                        FcndTable& out) {
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
  Numbers v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    v[i] = coordinate(lines, kNames[i], fields[columns[i]]);
    if (i >= 3 && v[i] < 0) {
      lines.refuse({.key = std::string(kNames[i]),
                    .expected = ">= 0",
                    .found = in_quotes(fields[columns[i]])});
    }
  }
  if (std::count(v.begin() + 3, v.end(), 0.0) == 3) {
    lines.refuse(
        {.expected = "a half size > 0",
         .found = fmt::format("three zeros (is this a latitude and longitude line?): \"{}\"",
                              lines.line().substr(0, 80))});
  }
  return v;
}

void add_box(const Numbers& v, std::size_t line, FcndTable& out) {
  out.flat += v[3] == 0 || v[4] == 0 || v[5] == 0;
  Aabb box;
  double size = 0;
  for (int i = 0; i < 3; ++i) {
    box.min[i] = add_down(v[i], -v[i + 3]);
    box.max[i] = add_up(v[i], v[i + 3]);
    size = std::max(size, std::abs(box.max[i]) + std::abs(box.min[i]));
  }
  out.largest_change = std::max(out.largest_change, ulp(size));  // which grows with the size
  out.table.add(box, line);
}

// What stands before the boxes, and which columns they have.
struct Layout {
  Columns columns = {0, 1, 2, 3, 4, 5};
  std::size_t width = 6;  // columns
};

// Reads up to the header, or up to the first box where there is none, which is then in `out`.
Layout read_layout(TextLines& lines, FcndTable& out) {
  Layout layout;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    if (lines.line()[0] == '#') {
      require_no_names(lines);
      continue;
    }
    if (!out.origin && (out.origin = parse_origin(lines))) continue;
    if (starts_with_number(lines.line())) {
      add_box(checked_numbers(lines, layout.columns, layout.width, out), lines.number(), out);
      break;
    }
    // The three-line form names the two columns of its next line first.
    if (split_fields(lines.line()) == std::vector<std::string>{"lat0", "lon0"}) continue;
    layout.columns = parse_header(lines, out);
    layout.width = split_fields(lines.line()).size();
    break;
  }
  return layout;
}

void reserve(BoxTable& table, std::size_t boxes) {
  table.boxes.reserve(boxes);
  table.ids.reserve(boxes);
  table.label.reserve(boxes);
}

// A part of the file, and what it holds. Memory that was used once is used again: fresh memory
// costs more than the copy into the table.
struct Block {
  LineBlock lines;
  FcndTable boxes;

  void parse(std::string_view source, const Layout& layout) {
    BoxTable table = std::move(boxes.table);
    table.boxes.clear();
    table.ids.clear();
    table.label.clear();
    boxes = {std::move(table), {}, 0, {}, 0};
    std::size_t line = lines.before;
    const char* const end = lines.text.data() + lines.text.size();
    for (const char* at = lines.text.data(); at != end;) {
      ++line;
      Numbers fields;
      const char* next = read_short_row(at, lines.text, fields);
      if (!next) next = read_plain_line(at, end, fields);
      if (const auto plain = next ? plain_numbers(fields, layout.columns) : std::nullopt) {
        add_box(*plain, line, boxes);
        at = next;
        continue;
      }
      const char* const feed = std::find(at, end, '\n');
      add_any_line({at, feed}, line, source, layout);
      at = feed == end ? end : feed + 1;
    }
  }

 private:
  void add_any_line(std::string_view text, std::size_t number, std::string_view source,
                    const Layout& layout) {
    TextLines line(text, number - 1, source);
    if (!line.next() || line.line().empty()) return;
    add_box(checked_numbers(line, layout.columns, layout.width, boxes), number, boxes);
  }
};

// Blocks that were taken, for those to come.
class SpareBlocks {
 public:
  Block take() {
    const std::lock_guard lock(mutex_);
    if (blocks_.empty()) return {};
    Block block = std::move(blocks_.back());
    blocks_.pop_back();
    return block;
  }
  void give(Block block) {
    const std::lock_guard lock(mutex_);
    blocks_.push_back(std::move(block));
  }

 private:
  std::mutex mutex_;
  std::vector<Block> blocks_;
};

void append(FcndTable& out, const FcndTable& block) {
  append(out.table, block.table);
  out.flat += block.flat;
  out.skipped.add(block.skipped);
  out.largest_change = std::max(out.largest_change, block.largest_change);
}

// Parses all that is left of the stream on all threads; gives the number of its last line.
std::size_t read_boxes(std::istream& in, std::size_t before, std::string_view source,
                       const Layout& layout, const Execution& run, std::uint64_t bytes,
                       FcndTable& out) {
  LineBlocks blocks(in, before, source);
  SpareBlocks spare;
  const auto next = [&]() -> std::optional<Block> {
    Block block = spare.take();
    if (!blocks.next(block.lines)) return std::nullopt;
    return block;
  };
  bool first = true;
  const auto take = [&](Block& block) {
    // A twentieth more than a file has whose lines are as long as those of its first block.
    if (std::exchange(first, false)) {
      const std::uint64_t text = block.lines.text.size();
      reserve(out.table, block.boxes.table.boxes.size() * (bytes + bytes / 20 + text) / text);
    }
    append(out, block.boxes);
    spare.give(std::move(block));
  };
  const Execution few = bytes > 0 ? for_work(run, bytes, kShare) : run;
  in_order<Block>(
      few, 4 * few.threads, next, [&](Block& block) { block.parse(source, layout); }, take);
  return blocks.lines();
}

}  // namespace

FcndTable read_fcnd_csv(std::istream& in, std::string_view source, const Execution& run,
                        std::uint64_t bytes) {
  FcndTable out;
  TextLines lines(in, source, true);
  const Layout layout = read_layout(lines, out);
  const std::size_t last = read_boxes(in, lines.number(), source, layout, run, bytes, out);
  if (out.table.boxes.empty()) {
    if (last == 0) {
      throw InputError(source, {.expected = "an FCND table", .found = "an empty file"});
    }
    throw InputError(source, last,
                     {.expected = "at least one box after the header", .found = "none"});
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

ImportedBoxes import_fcnd(std::istream& in, std::string_view source, const ImportOptions& options) {
  FcndTable fcnd = read_fcnd_csv(in, source, options.run, options.bytes);
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
