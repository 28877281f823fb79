#include "text/csv_records.h"

#include "geom/base/file_error.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

constexpr int kEnd = std::char_traits<char>::eof();

bool is_blank(int c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

void CsvRecords::refuse(Fault fault) const { throw InputError(source_, number_, std::move(fault)); }

int CsvRecords::get() {
  const int c = in_.get();
  if (c == kEnd && in_.bad()) {
    throw FileError(FileUse::reading, source_, EIO);
  }
  line_ += c == '\n';
  return c;
}

// The next byte where no quotes are open.
int CsvRecords::get_outside_quotes() {
  const int c = get();
  if (c != '\r') return c;
  const int after = in_.peek();
  if (after != '\n' && after != '\r' && after != kEnd) refuse(lone_return());
  return c;
}

// Appends the field that begins with `first`; returns what ends it: a comma, or a line feed for the
// end of the record.
char CsvRecords::read_field(int first) {
  std::string& field = fields_.emplace_back();
  int c = first;
  while (is_blank(c)) c = get_outside_quotes();
  if (c != '"') {
    for (; c != ',' && c != '\n' && c != kEnd; c = get_outside_quotes()) {
      field += static_cast<char>(c);
    }
    field = std::string(trimmed(field));
    return c == ',' ? ',' : '\n';
  }
  while (true) {
    c = get();
    if (c == kEnd) refuse({.says = "a quote is opened and not closed before the file ends"});
    if (c == '"' && (c = get_outside_quotes()) != '"') break;
    field += static_cast<char>(c);
  }
  while (is_blank(c)) c = get_outside_quotes();
  if (c != ',' && c != '\n' && c != kEnd) {
    refuse({.says = "expected a comma or the end of the line after a closing quote, and a quote "
                    "within a field to be doubled"});
  }
  return c == ',' ? ',' : '\n';
}

bool CsvRecords::read_record() {
  fields_.clear();
  number_ = line_;
  int first = get_outside_quotes();
  if (first == kEnd) return false;
  while (read_field(first) == ',') first = get_outside_quotes();
  return true;
}

bool CsvRecords::next() {
  if (!begun_) {
    begun_ = true;
    if (in_.peek() == 0xef) {
      for (const int expected : {0xef, 0xbb, 0xbf}) {
        if (get() != expected) {
          number_ = 1;
          refuse({.expected = "text in UTF-8", .found = "other bytes at the start"});
        }
      }
    }
  }
  do {
    while (commented_ && in_.peek() == '#') skip_line();
    if (!read_record()) return false;
  } while (fields_.size() == 1 && fields_[0].empty());
  commented_ = false;
  return true;
}

void CsvRecords::skip_line() {
  number_ = line_;
  int c = get_outside_quotes();
  while (c != '\n' && c != kEnd) c = get_outside_quotes();
}

}  // namespace geom
