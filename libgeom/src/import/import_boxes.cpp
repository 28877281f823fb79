#include "geom/import/import_boxes.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/text/counted.h"
#include "geom/text/json_line.h"
#include "geom/text/spoken_list.h"

namespace geom {
namespace {

// FCND tables last, because any line of numbers may be one.
constexpr const BoxFormat* kTable[] = {&kBoxCsv,      &kBlockText,   &kRotorPyWorld, &kVoxelMap,
                                       &kOctomapTree, &kGazeboWorld, &kJps3d,        &kFcnd};

// "a block text, a jps3d map or an FCND table of boxes"
std::string any_format() {
  std::vector<std::string_view> names;
  for (const BoxFormat* format : kTable) names.push_back(format->format->what);
  return spoken_list(names, "or");
}

}  // namespace

FormatRows<BoxFormat> box_formats() { return kTable; }

const BoxFormat& box_format_of(std::string_view head, std::string_view source) {
  if (const BoxFormat* const format = row_recognised(head, box_formats())) return *format;
  throw InputError(
      source, 1,
      {.expected = any_format(),
       .found = fmt::format("a file that begins with \"{}\"",
                            head.substr(0, std::min<std::size_t>(60, head.find_first_of("\r\n")))),
       .advice = "name its format with --format"});
}

ImportedBoxes import_boxes(std::istream& in, const BoxFormat& format, std::string_view source,
                           const ImportOptions& options) {
  return format.read(in, source, options);
}

MadeMap make_map(ImportedBoxes boxes, std::string_view source, MakeMapOptions options) {
  std::string history = "[]";
  if (!boxes.skipped.empty()) {
    if (!boxes.allow_skipped) {
      throw InputError(source,
                       {.says = fmt::format("{} cannot be built: {}",
                                            counted(boxes.skipped.count(), "possible obstacle"),
                                            boxes.skipped.text())});
    }
    history = '[' + JsonLine().add("skipped", boxes.skipped.count()).object() + ']';
  }
  if (boxes.table.boxes.empty())
    throw InputError(source, {.expected = "at least one obstacle", .found = "none"});
  if (!options.source_bounds) options.source_bounds = boxes.bounds;
  if (!options.floor) options.floor = boxes.floor;
  if (!options.seal) options.seal = boxes.seal;
  return make_map(std::move(boxes.table), boxes.frame, std::move(history), source, options);
}

}  // namespace geom
