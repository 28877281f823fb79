#pragma once

// Lines and fields of delimited text: BOM, CRLF, comma or semicolon, no locale.
//
// Example:
//   std::istringstream in("x,y\n1.5,2\n");
//   geom::TextLines lines(in, "points.csv");
//   lines.next();  // the header
//   while (lines.next()) {
//     const std::vector<std::string> fields = geom::split_fields(lines.line());
//     assert(geom::coordinate(lines, "x", fields[0]) == 1.5);
//   }

#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"

namespace geom {

// The lines of a stream, trimmed of a leading BOM and of white space at both ends. Lines that begin
// with `#` are passed over as comments, unless `comments_too`, until the first line that is neither
// a comment nor blank. After it they are lines like all others, because an id may begin with `#`.
class TextLines {
 public:
  TextLines(std::istream& in, std::string_view source, bool comments_too = false)
      : in_(&in), source_(source), begun_(comments_too) {}

  // Lines of a source that are in memory, where they must stay; `before` lines of it stand before
  // them. Comments are lines.
  TextLines(std::string_view text, std::size_t before, std::string_view source)
      : rest_(text), source_(source), number_(before), begun_(true) {}

  // False at the end. Throws std::system_error if reading fails, and InputError for a carriage
  // return within a line: what another program takes for two lines must not become one.
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }  // from 1
  std::string_view source() const { return source_; }
  [[noreturn]] void refuse(Fault fault) const;

 private:
  bool take_line();

  std::istream* in_ = nullptr;  // or
  std::string_view rest_;       // of the text in memory
  std::string source_;
  std::string buffer_;
  std::string_view line_;
  std::size_t number_ = 0;
  bool begun_;  // past the comments at the beginning
};

std::string_view trimmed(std::string_view text);

// What readers of text say of a carriage return that stands alone.
Fault lone_return();

// Fields between commas, or between semicolons where the line has one; trimmed. With `quoted`,
// a field may stand in double quotes, in which a doubled quote is one.
std::vector<std::string> split_fields(std::string_view line, bool quoted = false);

// The whole field as a number ("nan" and "inf" included), or nothing.
std::optional<double> parse_number(std::string_view field);

// A coordinate: finite and within kLargestCoordinate; refuses with `what` otherwise.
double coordinate(const TextLines& lines, std::string_view what, std::string_view field);

}  // namespace geom
