#pragma once

// Records of a stream, one a line.
//
// Example:
//   std::istringstream in("{\"id\":\"a\"}\n\n{\"id\":\"b\"}\n");
//   std::size_t last = 0;
//   geom::for_each_line(in, "stdin", [&](const std::string&, std::size_t line) { last = line; });
//   assert(last == 3);

#include <cstddef>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <utility>

namespace geom {

struct RecordLine {
  std::string text;        // without its newline
  std::size_t number = 0;  // in the stream, from 1
};

// The lines of a stream, one after the other.
class RecordLines {
 public:
  // `in` must outlive this; `source` names it in errors.
  RecordLines(std::istream& in, std::string source) : in_(in), source_(std::move(source)) {}

  // The next line that is not blank, or nothing at the end; a final newline may be missing. Throws
  // InputError where there was none, and for an archive.
  std::optional<RecordLine> next();

 private:
  std::istream& in_;
  std::string source_;
  std::size_t number_ = 0;
  bool any_ = false;
  std::size_t room_ = 0;  // bytes that the next line will likely take
};

// Calls f(line, number) for each of RecordLines.
void for_each_line(std::istream& in, const std::string& source,
                   const std::function<void(const std::string&, std::size_t)>& f);

}  // namespace geom
