#include "geom/record/path_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

std::string without_unit(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (name.ends_with("_m")) name.resize(name.size() - 2);
  return name;
}

bool is_header(const std::vector<std::string>& fields) {
  return fields.size() >= 3 && without_unit(fields[fields.size() - 3]) == "x" &&
         without_unit(fields[fields.size() - 2]) == "y" && without_unit(fields.back()) == "z";
}

class Table {
 public:
  explicit Table(TextLines& lines) : lines_(lines) {}

  void take(const std::vector<std::string>& fields) {
    if (columns_ == 0) columns_ = fields.size();
    if (fields.size() != columns_ || (columns_ != 3 && columns_ != 4)) {
      lines_.refuse({.expected = columns_ == 3   ? "x,y,z"
                                 : columns_ == 4 ? "id,x,y,z"
                                                 : "id,x,y,z or x,y,z",
                     .found = fmt::format("{} columns", fields.size())});
    }
    if (is_header(fields)) return require_id_column(fields);
    const std::string id = columns_ == 4 ? fields[0] : "path";
    if (paths_.empty() || paths_.back().id != id) begin(id);
    const auto at = [&](std::size_t i, const char* name) {
      return coordinate(lines_, name, fields[columns_ - 3 + i]);
    };
    paths_.back().points.push_back({at(0, "x"), at(1, "y"), at(2, "z")});
  }

  std::vector<PathRecord> paths() && { return std::move(paths_); }

 private:
  void require_id_column(const std::vector<std::string>& header) const {
    if (columns_ == 3 || without_unit(header.front()) == "id") return;
    lines_.refuse({.expected = "the columns id,x,y,z or x,y,z",
                   .found = fmt::format("the first of four named \"{}\"", excerpt(header.front())),
                   .advice = "name it id if it says which path a point is of, or leave it out"});
  }

  void begin(const std::string& id) {
    if (!seen_.insert(id).second) {
      lines_.refuse(
          {.expected = "the points of a path together", .found = fmt::format("\"{}\" again", id)});
    }
    paths_.emplace_back();
    paths_.back().id = id;
    paths_.back().status = PathStatus::found;
  }

  TextLines& lines_;
  std::size_t columns_ = 0;
  std::set<std::string> seen_;
  std::vector<PathRecord> paths_;
};

// A first column that counts rows, or is a time, would make a path of each point.
void refuse_single_points(const std::vector<PathRecord>& paths, std::string_view source) {
  const auto is_point = [](const PathRecord& path) { return path.points.size() == 1; };
  if (paths.size() < 2 || !std::all_of(paths.begin(), paths.end(), is_point)) return;
  throw InputError(source,
                   {.expected = "the points of a path in rows with the same id",
                    .found = fmt::format("{} rows with as many ids", paths.size()),
                    .advice = "leave the first column out if it is a number of the row or a time"});
}

}  // namespace

std::vector<PathRecord> read_path_csv(std::istream& in, std::string_view source) {
  TextLines lines(in, source);
  Table table(lines);
  while (lines.next()) {
    if (in.eof())
      lines.refuse({.expected = "a line that ends with LF",
                    .found = "none",
                    .advice = "the file may be cut"});
    if (!lines.line().empty()) table.take(split_fields(lines.line()));
  }
  std::vector<PathRecord> paths = std::move(table).paths();
  if (paths.empty()) throw InputError(source, {.expected = "points id,x,y,z", .found = "none"});
  refuse_single_points(paths, source);
  return paths;
}

}  // namespace geom
