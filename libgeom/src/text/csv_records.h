#pragma once

// Records of comma-separated text as RFC 4180 has them: a quoted field may hold anything, line
// breaks included.

#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"

namespace geom {

// `a,"b, ""c""",d` has the fields a, `b, "c"` and d. A field in quotes comes as it stands between
// them; one without is trimmed of blanks. Lines end in LF or CRLF; a carriage return alone, outside
// quotes, is refused. A leading BOM, empty lines, and lines that begin with `#` before the first
// record are passed over.
class CsvRecords {
 public:
  CsvRecords(std::istream& in, std::string_view source) : in_(in), source_(source) {}

  // False at the end. Throws std::system_error when reading fails, and InputError(source, line, …)
  // for a carriage return alone, for a quote that is not closed and for text between a closing
  // quote and the next comma.
  bool next();
  const std::vector<std::string>& fields() const { return fields_; }
  std::size_t number() const { return number_; }  // of the line on which the record begins, from 1
  [[noreturn]] void refuse(Fault fault) const;

 private:
  bool read_record();
  void skip_line();
  char read_field(int first);
  int get();
  int get_outside_quotes();

  std::istream& in_;
  std::string source_;
  std::vector<std::string> fields_;
  std::size_t number_ = 0;
  std::size_t line_ = 1;  // of the next byte
  bool begun_ = false;
  bool commented_ = true;  // comments may still come
};

}  // namespace geom
