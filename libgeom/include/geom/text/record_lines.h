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
#include <vector>

#include "geom/base/parallel.h"

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

// Lines that are parsed at once: so many bytes, and a line.
inline constexpr std::size_t kLinesAtOnce = std::size_t{1} << 22;

// Calls `parse(text, number)` of each line that is not blank, on the threads of `run`, and
// `take(record, number)` of what each gave, in order and by the caller's thread. What is thrown
// is what one thread would throw that takes each record before it reads the next line.
template <class Parse, class Take>
void for_each_parsed(std::istream& in, const std::string& source, const Execution& run,
                     const Parse& parse, const Take& take) {
  using Lines = std::vector<std::pair<std::string, std::size_t>>;
  Lines held;
  std::size_t bytes = 0;
  const auto finish_held = [&] {
    const Lines lines = std::exchange(held, {});
    bytes = 0;
    std::vector<std::optional<decltype(parse(std::string(), std::size_t{1}))>> records(
        lines.size());
    const auto take_parsed = [&] {  // all before the first that is no record
      for (std::size_t i = 0; i < records.size() && records[i]; ++i) {
        take(*std::move(records[i]), lines[i].second);
      }
    };
    try {
      parallel_for(lines.size(), {run.threads, {}},
                   [&](std::size_t i) { records[i] = parse(lines[i].first, lines[i].second); });
    } catch (...) {
      take_parsed();
      throw;
    }
    take_parsed();
  };
  try {
    for_each_line(in, source, [&](const std::string& line, std::size_t number) {
      if (bytes >= kLinesAtOnce) finish_held();
      held.emplace_back(line, number);
      bytes += line.size();
    });
  } catch (...) {  // of reading: the lines before it come first; of those, none are held
    finish_held();
    throw;
  }
  finish_held();
}

}  // namespace geom
