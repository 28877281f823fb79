#include "geom/text/text_table.h"

#include <algorithm>
#include <cmath>

#include "geom/base/file_error.h"
#include "geom/base/vec3.h"
#include "geom/text/number.h"

namespace geom {

Fault lone_return() {
  return {.expected = "lines that end in LF or CRLF",
          .found = "a carriage return alone",
          .advice = "convert the line ends, for example with `tr '\\r' '\\n'`"};
}

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// The next line as it stands; false at the end.
bool TextLines::take_line() {
  if (in_) {
    const bool more = static_cast<bool>(std::getline(*in_, buffer_));
    if (in_->bad()) throw FileError(FileUse::reading, source_, EIO);
    line_ = buffer_;
    return more;
  }
  if (rest_.empty()) return false;
  line_ = rest_.substr(0, rest_.find('\n'));
  rest_.remove_prefix(std::min(line_.size() + 1, rest_.size()));
  return true;
}

bool TextLines::next() {
  do {
    if (!take_line()) return false;
    if (++number_ == 1 && line_.starts_with("\xef\xbb\xbf")) line_.remove_prefix(3);
    line_ = trimmed(line_);
    if (line_.find('\r') != line_.npos) refuse(lone_return());
  } while (!begun_ && line_.starts_with('#'));
  begun_ = begun_ || !line_.empty();
  return true;
}

void TextLines::refuse(Fault fault) const { throw InputError(source_, number_, std::move(fault)); }

namespace {

std::vector<std::string> split_at(char separator, std::string_view line) {
  std::vector<std::string> fields;
  fields.reserve(8);
  for (std::size_t end = line.find(separator); end != line.npos; end = line.find(separator)) {
    fields.emplace_back(trimmed(line.substr(0, end)));
    line.remove_prefix(end + 1);
  }
  fields.emplace_back(trimmed(line));
  return fields;
}

}  // namespace

std::vector<std::string> split_fields(std::string_view line, bool quoted) {
  const char separator = !quoted && line.find(';') != std::string_view::npos ? ';' : ',';
  if (!quoted || line.find('"') == line.npos) return split_at(separator, line);
  std::vector<std::string> fields(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') {
      if (inside && i + 1 < line.size() && line[i + 1] == '"') {
        fields.back() += '"';
        ++i;
      } else {
        inside = !inside;
      }
    } else if (c == separator && !inside) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

std::optional<double> parse_number(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0;
  const auto [rest, error] = read_number(field.data(), field.data() + field.size(), value);
  if (rest != field.data() + field.size() || field.empty()) return std::nullopt;
  if (error != std::errc()) return std::nullopt;
  return value;
}

double coordinate(const TextLines& lines, std::string_view what, std::string_view field) {
  const auto value = parse_number(field);
  if (!value || !(std::abs(*value) <= kLargestCoordinate)) {
    lines.refuse({.key = std::string(what),
                  .expected = "a finite number within 1e8 m",
                  .found = in_quotes(field.substr(0, 40))});
  }
  return *value;
}

}  // namespace geom
