// Block text, as courses use it: `boundary|block x0 y0 z0 x1 y1 z1 [r g b]`, fields by white space,
// `#` starts a comment. There is exactly one boundary, and at least one block; each block has some
// extent. Ids are line numbers, and a colour becomes the label "R G B". A line with another keyword
// may have been meant as a block: it is skipped.

#include <fmt/format.h>

#include <optional>

#include "geom/import/import_boxes.h"
#include "geom/text/beginning.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> out;
  line = line.substr(0, line.find('#'));
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t\r", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    out.push_back(line.substr(at, end - at));
    at = end;
  }
  return out;
}

Aabb parse_box(const TextLines& lines, const std::vector<std::string_view>& fields,
               std::size_t& reversed) {
  if (fields.size() != 7 && fields.size() != 10) {
    lines.refuse({.says = fmt::format("{} must have 6 or 9 numbers", fields[0]),
                  .found = fmt::to_string(fields.size() - 1)});
  }
  double v[6];
  for (int i = 0; i < 6; ++i) {
    v[i] = coordinate(lines, fmt::format("number {} of {}", i + 1, fields[0]), fields[i + 1]);
  }
  const Vec3 first(v[0], v[1], v[2]);
  const Vec3 second(v[3], v[4], v[5]);
  const Aabb box{first.cwiseMin(second), first.cwiseMax(second)};
  reversed += box.min != first;
  return box;
}

std::string colour_of(const TextLines& lines, const std::vector<std::string_view>& fields) {
  if (fields.size() != 10) return "";
  std::string label;
  for (int i = 7; i < 10; ++i) {
    label += fmt::format("{}{}", i > 7 ? " " : "", coordinate(lines, "colour", fields[i]));
  }
  return label;
}

ImportedBoxes read_block_text(std::istream& in, std::string_view source, const ImportOptions&) {
  TextLines lines(in, source);
  ImportedBoxes out;
  std::optional<Aabb> boundary;
  while (lines.next()) {
    const auto fields = words(lines.line());
    if (fields.empty()) continue;
    if (fields[0] == "boundary") {
      if (boundary) lines.refuse({.expected = "one boundary", .found = "another"});
      boundary = parse_box(lines, fields, out.reversed);
    } else if (fields[0] == "block") {
      const Aabb box = parse_box(lines, fields, out.reversed);
      const int zeros = static_cast<int>((box.min.array() == box.max.array()).count());
      if (zeros == 3) lines.refuse({.says = "a block must have some extent", .found = "a point"});
      out.flat += zeros > 0;
      const std::string colour = colour_of(lines, fields);
      out.table.add(box, lines.number(), out.table.label_of(colour));
    } else {
      out.skipped.add("unknown keyword",
                      fmt::format("line {}: {}", lines.number(), fields[0].substr(0, 40)));
    }
  }
  if (!boundary) lines.refuse({.expected = "a boundary line", .found = "none"});
  if (out.table.boxes.empty()) {
    lines.refuse(
        {.expected = "at least one block",
         .found =
             out.skipped.count() == 0 ? "a boundary alone" : "a boundary and " + out.skipped.text(),
         .advice = "a map needs an obstacle; a block that is the floor, as flat as 0, will do"});
  }
  out.bounds = boundary;
  return out;
}

bool may_be_block_text(std::string_view head) {
  const std::string_view line = first_line(head);
  return line.starts_with("boundary") || line.starts_with("block");
}

constexpr std::string_view kReaders[] = {"skyway-import"};
constexpr Format kFormat{.word = "block-text",
                         .what = "a block text",
                         .begins = text_begins_with<"boundary ">,
                         .readers = kReaders};

}  // namespace

constinit const BoxFormat kBlockText{
    .format = &kFormat, .may_be = may_be_block_text, .read = read_block_text};

}  // namespace geom
