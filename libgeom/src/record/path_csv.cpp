#include "geom/record/path_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "geom/base/error.h"
#include "geom/record/axes_comment.h"
#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"
#include "text/unit_comment.h"

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

// The metres in the unit that a comment names, also as "all in feet".
std::optional<double> unit_in(std::string_view comment) {
  if (const auto unit = unit_of_comment(comment)) return unit;
  const std::size_t in = comment.find(" in ");
  if (in == comment.npos) return std::nullopt;
  return unit_of_comment(fmt::format("unit:{}", comment.substr(in + 3)));
}

// A word, as names of columns are.
bool is_name(const std::string& field) {
  return !field.empty() && std::isalpha(static_cast<unsigned char>(field.front())) &&
         field.find(' ') == field.npos;
}

// Whether an id may be a time or a coordinate: a number that is not whole.
bool is_measured(const std::string& id) {
  return id.find_first_of(".eE") != id.npos && parse_number(id).has_value();
}

class Table {
 public:
  Table(TextLines& lines, Axes axes) : lines_(lines), axes_(axes), of_rows_{axes} {}

  // One before the points. It may name a unit, axes, or the columns as numpy.savetxt() does.
  void take_comment(std::string_view text) {
    if (const auto named = axes_of_comment(text)) take_axes(*named, text);
    const auto unit = unit_in(text);
    if (unit && *unit != 1) {
      lines_.refuse(
          {.expected = "coordinates in metres",
           .found = fmt::format("a comment that names another unit, \"{}\"", excerpt(text)),
           .advice = "convert the coordinates to metres, and leave the comment out"});
    }
    const auto names =
        split_fields(text.substr(std::min(text.find_first_not_of("# "), text.size())));
    if (names.size() < 3 || !std::all_of(names.begin(), names.end(), is_name)) return;
    if (!is_header(names) || names.size() > 4) {
      lines_.refuse({.expected = "the columns id,x,y,z or x,y,z",
                     .found = fmt::format("others in a comment, \"{}\"", excerpt(text)),
                     .advice = "put the columns in this order, or leave the comment out"});
    }
    columns_ = names.size();
    named_ = true;
    require_id_column(names);
  }

  bool has_begun() const { return begun_; }

  void take(const std::vector<std::string>& fields) {
    begun_ = true;
    if (columns_ == 0) columns_ = fields.size();
    if (fields.size() != columns_ || (columns_ != 3 && columns_ != 4)) {
      lines_.refuse({.expected = columns_ == 3   ? "x,y,z"
                                 : columns_ == 4 ? "id,x,y,z"
                                                 : "id,x,y,z or x,y,z",
                     .found = fmt::format("{} columns", fields.size())});
    }
    if (is_header(fields)) {
      named_ = true;
      return require_id_column(fields);
    }
    const std::string id = columns_ == 4 ? fields[0] : "path";
    if (paths_.empty() || paths_.back().id != id) begin(id);
    const auto at = [&](std::size_t i, const char* name) {
      return coordinate(lines_, name, fields[columns_ - 3 + i]);
    };
    const Vec3 point{at(0, "x"), at(1, "y"), at(2, "z")};
    paths_.back().points.push_back(in_axes(axes_, of_rows_, point));
  }

  std::vector<PathRecord> paths() && {
    if (columns_ == 4) refuse_other_ids();
    return std::move(paths_);
  }

 private:
  void take_axes(const CommentedAxes& named, std::string_view text) {
    const bool again =
        axes_named_ && (named.axes != of_rows_.axes || named.downwards != of_rows_.downwards);
    if (!named.axes || again) {
      lines_.refuse(
          not_these_axes(text, again ? "axes that are named once" : "axes enu, neu or ned"));
    }
    of_rows_ = named;
    axes_named_ = true;
  }

  // A first column that counts rows or is a time makes a path of each point. One that is a time or
  // a coordinate makes paths of points that come together by chance.
  void refuse_other_ids() const {
    const auto is_point = [](const PathRecord& path) { return path.points.size() == 1; };
    if (paths_.size() > 1 && std::all_of(paths_.begin(), paths_.end(), is_point)) {
      throw InputError(
          std::string(lines_.source()),
          {.expected = "the points of a path in rows with the same id",
           .found = fmt::format("{} rows with as many ids", paths_.size()),
           .advice = "leave the first column out if it is a number of the row or a time"});
    }
    const auto measured = std::find_if(paths_.begin(), paths_.end(),
                                       [](const PathRecord& path) { return is_measured(path.id); });
    if (named_ || measured == paths_.end()) return;
    throw InputError(std::string(lines_.source()),
                     {.expected = "ids of paths in the first of four columns",
                      .found = fmt::format("\"{}\"", excerpt(measured->id)),
                      .advice = "begin with the header id,x,y,z if that is an id, else leave only "
                                "the columns x,y,z"});
  }

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
  Axes axes_;              // of the map
  CommentedAxes of_rows_;  // known
  bool axes_named_ = false;
  std::size_t columns_ = 0;
  bool begun_ = false;  // past the comments
  bool named_ = false;  // the columns, by a header
  std::set<std::string> seen_;
  std::vector<PathRecord> paths_;
};

}  // namespace

std::vector<PathRecord> read_path_csv(std::istream& in, std::string_view source, Axes axes) {
  TextLines lines(in, source, true);
  Table table(lines, axes);
  while (lines.next()) {
    if (in.eof())
      lines.refuse({.expected = "a line that ends with LF",
                    .found = "none",
                    .advice = "the file may be cut"});
    if (lines.line().empty()) continue;
    if (lines.line().starts_with('#') && !table.has_begun()) {
      table.take_comment(lines.line());
    } else {
      table.take(split_fields(lines.line()));
    }
  }
  std::vector<PathRecord> paths = std::move(table).paths();
  if (paths.empty()) throw InputError(source, {.expected = "points id,x,y,z", .found = "none"});
  return paths;
}

}  // namespace geom
