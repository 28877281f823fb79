#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "geom/base/error.h"
#include "geom/cloud/cloud_format.h"
#include "geom/cloud/point_cloud.h"
#include "geom/text/beginning.h"
#include "geom/text/excerpt.h"
#include "geom/text/number.h"
#include "geom/text/text_table.h"
#include "moved_comment.h"
#include "point_chunks.h"
#include "xyz_header.h"

namespace geom {
namespace {

class XyzReader {
 public:
  XyzReader(std::istream& in, std::string_view source, const PointSink& sink,
            const ReferenceSink& reference)
      : lines_(in, source, true), chunks_(source, sink), reference_(reference) {}

  CloudCounts read() {
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (line.empty()) continue;
      if (line[0] == '#' || line.starts_with("//")) {
        take_comment(line);
      } else if (begun_ || !(is_count(line) || is_header(line))) {
        take_point(line);
      }
    }
    if (promised_ && *promised_ != static_cast<double>(found_)) {
      lines_.refuse({.expected = fmt::format("{} points, as the first line says", *promised_),
                     .found = fmt::to_string(found_)});
    }
    return chunks_.finish();
  }

 private:
  // Words that may name the columns, and stand before what separates these is known.
  struct Header {
    std::string text;
    std::size_t line;
    bool comment;
  };

  void take_comment(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of("#/ \t"), line.size()));
    if (!begun_) comments_.take(line);
    if (const std::size_t colon = line.rfind(':'); colon != line.npos)
      line.remove_prefix(colon + 1);
    split_words(line);
    if (!name_all_axes(fields_)) return;
    if (begun_) return require_same(xyz_columns(fields_, {lines_.source(), lines_.number()}));
    headers_.push_back({std::string(line), lines_.number(), true});
    if (headers_.size() > kMostHeaders) {
      lines_.refuse({.expected = "one line that names the columns", .found = "many"});
    }
  }

  void require_same(const XyzColumns& columns) const {
    if (columns.of_axis == columns_.value_or(XyzColumns()).of_axis) return;
    lines_.refuse({.expected = "the same columns throughout the file",
                   .found = fmt::format("others: \"{}\"", excerpt(lines_.line()))});
  }

  // A number alone, before the first point: how many there are.
  bool is_count(std::string_view line) {
    const auto count = parse_number(line);
    if (!count) return false;
    if (promised_) {
      lines_.refuse(
          {.expected = "three numbers",
           .found = "two lines of one number each, as a PTX file begins",
           .advice = "its scans have places of their own; write them as LAS or PLY, for example "
                     "with `CloudCompare -O scan.ptx -C_EXPORT_FMT LAS -SAVE_CLOUDS`"});
    }
    if (!(*count >= 0) || *count != std::floor(*count)) refuse_line();
    promised_ = count;
    return true;
  }

  // A line that begins with no number, before the first point.
  bool is_header(std::string_view line) {
    fields_of(separator_of(line), line, fields_);
    const bool number = std::string_view("0123456789+-.").find(line[0]) != std::string_view::npos;
    if (number || parse_number(fields_[0])) return false;
    for (const Header& known : headers_) {
      if (!known.comment) refuse_line();
    }
    headers_.push_back({std::string(line), lines_.number(), false});
    return true;
  }

  void begin(std::string_view line) {
    begun_ = true;
    if (reference_) reference_(comments_.told());
    separator_ = separator_of(line);
    fields_of(separator_, line, fields_);
    width_ = fields_.size();
    const bool empty_end = fields_.back().empty();
    for (const Header& header : headers_) obey(header, empty_end);
    headers_.clear();
  }

  // Takes the columns that a header names; in a comment, commas may separate its words as well.
  // The last column of points that end in a separator may have no name.
  void obey(const Header& header, bool empty_end) {
    const auto refuse = [&](Fault fault) {
      throw InputError(lines_.source(), header.line, std::move(fault));
    };
    fields_of(separator_, header.text, fields_);
    if (header.comment && fields_.size() != width_) split_words(header.text);
    if (fields_.back().empty()) fields_.pop_back();
    const XyzColumns columns = xyz_columns(fields_, {lines_.source(), header.line});
    if (columns.count != width_ && !(empty_end && columns.count + 1 == width_)) {
      refuse({.expected =
                  fmt::format("a name for each of the {} columns between {} of the first point",
                              width_, name_of_separator(separator_)),
              .found = fmt::format("{}: \"{}\"", columns.count, excerpt(header.text))});
    }
    if (columns_ && columns != *columns_) {
      refuse({.expected = "the same columns as above",
              .found = fmt::format("others: \"{}\"", excerpt(header.text))});
    }
    columns_ = columns;
    width_ = columns.count;
  }

  // Whether a line has as many columns as the first; behind three numbers between blanks, without a
  // header, any words may stand.
  bool fits() const {
    const std::size_t count = fields_.size();
    if (separator_ == ' ' && !columns_) return count >= 3;
    return count >= 3 && (count == width_ || (count == width_ + 1 && fields_.back().empty()));
  }

  void take_point(std::string_view line) {
    if (!begun_) begin(line);
    fields_of(separator_, line, fields_);
    if (!fits()) refuse_line(fields_.size() < 3 ? "" : fmt::format(" in {} columns", width_));
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t column = columns_ ? columns_->of_axis[static_cast<std::size_t>(axis)]
                                          : static_cast<std::size_t>(axis);
      const auto value = parse_number(fields_[column]);
      if (!value) refuse_line();
      p[axis] = *value;
    }
    chunks_.add(p);
    ++found_;
  }

  [[noreturn]] void refuse_line(const std::string& how = "") const {
    const char separator = begun_ ? separator_ : separator_of(lines_.line());
    lines_.refuse({.expected = fmt::format("three numbers{} between {}, with points for decimals",
                                           how, name_of_separator(separator)),
                   .found = in_quotes(excerpt(lines_.line()))});
  }

  void split_words(std::string_view text) {
    blank_.assign(text);
    for (char& c : blank_) c = c == ',' || c == ';' || c == '\t' ? ' ' : c;
    fields_of(' ', blank_, fields_);
  }

  static constexpr std::size_t kMostHeaders = 100;

  TextLines lines_;
  PointChunks chunks_;
  const ReferenceSink& reference_;
  MovedComments comments_;  // before the first point
  bool begun_ = false;      // with points
  char separator_ = ' ';
  std::size_t width_ = 0;  // columns of the first point
  std::optional<XyzColumns> columns_;
  std::vector<Header> headers_;
  std::vector<std::string_view> fields_;
  std::string blank_;
  std::optional<double> promised_;  // by a header that is a count
  std::size_t found_ = 0;
};

}  // namespace

CloudCounts read_xyz(std::istream& in, std::string_view source, const PointSink& sink) {
  const ReferenceSink nobody;
  return XyzReader(in, source, sink, nobody).read();
}

namespace {

CloudCounts read_xyz_cloud(std::istream& in, std::string_view source, const PointSink& sink,
                           const ReferenceSink& reference, const LasReading&) {
  return XyzReader(in, source, sink, reference).read();
}

// Three or four numbers, with blanks or commas between.
bool is_row_of_point(std::string_view line) {
  constexpr std::string_view kBetween = " \t\r,;";
  std::size_t numbers = 0;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
    if (line.empty()) return numbers == 3 || numbers == 4;
    double value = 0;
    const auto [rest, error] = read_number(line.data(), line.data() + line.size(), value);
    if (error != std::errc()) return false;
    ++numbers;
    line.remove_prefix(static_cast<std::size_t>(rest - line.data()));
    if (!line.empty() && kBetween.find(line.front()) == kBetween.npos) return false;
  }
}

// Two rows of numbers, behind one line of names at most.
bool is_table_of_points(std::string_view head) {
  std::string_view text = text_of(head).substr(0, 2000);
  const auto next = [&] {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
  };
  const std::string_view first = next();
  if (!is_row_of_point(first) && first != "x y z" && first != "x,y,z") return false;
  return is_row_of_point(next());
}

constexpr std::string_view kReaders[] = {"skyway-cloud", "skyway-check",
                                         "skyway-import-trajectory"};
constexpr Format kXyz{
    .word = "xyz", .what = "a table of points", .begins = is_table_of_points, .readers = kReaders};

}  // namespace

// Any text may be a table of points.
constinit const CloudFormat kXyzCloud{
    .format = &kXyz, .may_be = [](std::string_view) { return true; }, .read = read_xyz_cloud};

}  // namespace geom
