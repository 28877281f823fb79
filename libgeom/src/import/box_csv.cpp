#include "geom/import/box_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "geom/import/box_format.h"
#include "geom/text/beginning.h"
#include "geom/text/csv_field.h"
#include "geom/text/number.h"
#include "geom/text/text_table.h"
#include "text/csv_records.h"

namespace geom {
namespace {

constexpr std::string_view kHeader = "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label";
constexpr const char* kNames[] = {"min x", "min y", "min z", "max x", "max y", "max z"};

std::string joined(const std::vector<std::string>& fields) {
  std::string out;
  for (std::size_t i = 0; i < fields.size(); ++i) out += (i ? "," : "") + fields[i];
  return out;
}

double coordinate_of(const CsvRecords& records, const char* name, const std::string& field) {
  const auto value = parse_number(field);
  if (!value || !(std::abs(*value) <= kLargestCoordinate)) {
    records.refuse({.key = std::string(name),
                    .expected = "a finite number within 1e8 m",
                    .found = in_quotes(field.substr(0, 40))});
  }
  return *value;
}

}  // namespace

BoxTable read_box_csv(std::istream& in, std::string_view source) {
  CsvRecords records(in, source);
  BoxTable table;
  if (!records.next() || joined(records.fields()) != kHeader) {
    records.refuse({.expected = fmt::format("the header {}", kHeader),
                    .found = in_quotes(joined(records.fields()).substr(0, 80))});
  }
  while (records.next()) {
    const std::vector<std::string>& fields = records.fields();
    if (fields.size() != 7) {
      records.refuse(
          {.expected = "7 fields",
           .found = fmt::format("{}: \"{}\"", fields.size(), joined(fields).substr(0, 80))});
    }
    double v[6];
    for (int i = 0; i < 6; ++i) v[i] = coordinate_of(records, kNames[i], fields[i]);
    for (int i = 0; i < 3; ++i) {
      if (v[i] > v[i + 3]) {
        records.refuse({.key = std::string(kNames[i]),
                        .expected = fmt::format("<= {}", kNames[i + 3]),
                        .found = fmt::format("\"{}\" and \"{}\"", fields[i], fields[i + 3])});
      }
    }
    table.add({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}, records.number(),
              table.label_of(fields[6]));
  }
  if (table.boxes.empty())
    records.refuse({.expected = "at least one box after the header", .found = "none"});
  return table;
}

void write_box_csv(std::ostream& out, const BoxTable& table) {
  const bool timed = std::any_of(table.times.begin(), table.times.end(),
                                 [](const TimeSpan& time) { return !time.always(); });
  std::string text(kHeader);
  text += timed ? ",from_s,until_s\n" : "\n";
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    for (const Vec3* corner : {&table.boxes[i].min, &table.boxes[i].max}) {
      for (const double v : *corner) {
        append_number(text, v);
        text += ',';
      }
    }
    text += csv_field(table.labels[table.label[i]]);
    if (timed) {
      const TimeSpan time = table.time(i);
      for (const double end : {time.from, time.until}) {
        text += ',';
        if (std::isfinite(end)) append_number(text, end);
      }
    }
    text += '\n';
  }
  out << text;
}

namespace {

ImportedBoxes import_box_csv(std::istream& in, std::string_view source, const ImportOptions&) {
  ImportedBoxes out;
  out.table = read_box_csv(in, source);
  return out;
}

// The header stands in the first line, or in a comment before it.
bool may_be_box_csv(std::string_view head) {
  const std::string_view line = first_line(head);
  const bool none = line.empty();
  const std::string_view until =
      none ? head : head.substr(0, line.data() + line.size() - head.data());
  return until.find("min_x_m") != until.npos;
}

constexpr std::string_view kReaders[] = {"skyway-import", "skyway-map"};
constexpr Format kFormat{.word = "box-csv",
                         .what = "a table of boxes (box CSV)",
                         .begins = text_begins_with<"min_x_m,">,
                         .readers = kReaders};

}  // namespace

constinit const BoxFormat kBoxCsv{
    .format = &kFormat, .may_be = may_be_box_csv, .read = import_box_csv};

}  // namespace geom
