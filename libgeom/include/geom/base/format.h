#pragma once

// A kind of file as one value: its word, its name for people, its beginning and its readers.
//
// Example:
//   static constexpr std::string_view readers[] = {"skyway-cloud"};
//   static constexpr geom::Format pcd{
//       .word = "pcd",
//       .what = "a PCD point cloud",
//       .begins = [](std::string_view head) { return head.starts_with("# .PCD"); },
//       .readers = readers};
//   const geom::Format* const formats[] = {&pcd};
//   assert(geom::recognise("# .PCD v0.7", formats) == &pcd);

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace geom {

// Bytes from the beginning of a file, or all of a shorter one, by which a format is recognised.
inline constexpr std::size_t kFormatHead = 4096;

// A format is one constant, and its address is its identity. All views refer to constants.
struct Format {
  std::string_view word =
      {};                 // of --format and --file-format: "qgc-plan"; empty: no option names it
  std::string_view what;  // "a QGroundControl plan"
  bool (*begins)(std::string_view head) = nullptr;  // null: no beginning tells of it
  std::span<const std::string_view> readers = {};   // names of the tools that read it
  std::string_view advice = {};                     // what to do with it where no tool reads it
};

// The formats of a table, in the order in which they are tried.
using Formats = std::span<const Format* const>;

// The first of `formats` that `head` begins as; null where there is none. A hint: only a reader
// knows.
const Format* recognise(std::string_view head, Formats formats);

// The format of this word; null where there is none.
const Format* format_named(std::string_view word, Formats formats);

// Whether `tool` is one of those that read the format.
bool reads(std::string_view tool, const Format& format);

// A table of readers has rows of a type of its own, which name a format, and kinds of files that
// the same reader takes. A row is a constant, too, and lies with its reader:
//
//   struct CloudFormat {
//     const Format* format;                           // LAS
//     Formats kinds = {};                             // LAZ and COPC
//     bool (*may_be)(std::string_view head) = nullptr;  // where no format of the table is sure
//     CloudCounts (*read)(std::istream& in, ...);
//   };
template <class Row>
using FormatRows = std::span<const Row* const>;

// The row whose format has this word; null where there is none.
template <class Row>
const Row* row_named(std::string_view word, FormatRows<Row> rows) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row* row) { return row->format->word == word; });
  return found == rows.end() || word.empty() ? nullptr : *found;
}

// The row that reads this format, as its own or as a kind; null where there is none.
template <class Row>
const Row* row_of(const Format& format, FormatRows<Row> rows) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row* row) {
    return row->format == &format ||
           std::find(row->kinds.begin(), row->kinds.end(), &format) != row->kinds.end();
  });
  return found == rows.end() ? nullptr : *found;
}

// All formats of a table with their kinds, row by row.
template <class Row>
std::vector<const Format*> formats_of(FormatRows<Row> rows) {
  std::vector<const Format*> out;
  for (const Row* row : rows) {
    out.push_back(row->format);
    out.insert(out.end(), row->kinds.begin(), row->kinds.end());
  }
  return out;
}

// The words of a table, for --format.
template <class Row>
std::vector<std::string_view> words_of(FormatRows<Row> rows) {
  std::vector<std::string_view> out;
  for (const Row* row : rows) out.push_back(row->format->word);
  return out;
}

// The row that reads a file that begins with `head`: the one that recognises it, else the first of
// which it may be. Null where there is none.
template <class Row>
const Row* row_recognised(std::string_view head, FormatRows<Row> rows) {
  if (const Format* const format = recognise(head, formats_of(rows))) return row_of(*format, rows);
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row* row) { return row->may_be && row->may_be(head); });
  return found == rows.end() ? nullptr : *found;
}

}  // namespace geom
