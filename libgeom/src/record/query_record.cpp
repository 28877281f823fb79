#include "geom/record/query_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "geom/text/json_fields.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

double path_length(const TextLines& lines, std::string_view name, double value) {
  if (!(value > 0)) lines.refuse(fmt::format("{} must be > 0 metres, found {}", name, value));
  return value;
}

PlanQuery parse_json(const TextLines& lines) {
  const JsonFields fields(lines.line(), lines.source(), lines.number());
  PlanQuery query{fields.text("id", fmt::format("q{}", lines.number())), fields.point("from"),
                  fields.point("to"), fields.number("best_known"), 0};
  if (query.best_known) path_length(lines, "best_known", *query.best_known);
  return query;
}

// A CSV table with a header, in which columns are found by their names.
class Columns {
 public:
  explicit Columns(const TextLines& header)
      : header_(header.line()), names_(split_fields(header.line())) {
    id_ = need(header, "id");
    set_ = find("set");
  }

  std::optional<std::size_t> find(std::string_view name) const {
    const auto at = std::find(names_.begin(), names_.end(), name);
    if (at == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(at - names_.begin());
  }

  std::size_t need(const TextLines& header, std::string_view name) const {
    const auto at = find(name);
    if (!at) {
      header.refuse(fmt::format("expected a column {}, found \"{}\"", name, header_.substr(0, 80)));
    }
    return *at;
  }

  std::vector<std::string> fields(const TextLines& lines) const {
    auto fields = split_fields(lines.line());
    if (fields.size() != names_.size()) {
      lines.refuse(fmt::format("expected {} fields, found {}: \"{}\"", names_.size(), fields.size(),
                               lines.line().substr(0, 80)));
    }
    return fields;
  }

  std::string id(const std::vector<std::string>& fields) const {
    return set_ ? fields[*set_] + '-' + fields[id_] : fields[id_];
  }

 private:
  std::string header_;
  std::vector<std::string> names_;
  std::size_t id_ = 0;
  std::optional<std::size_t> set_;
};

class CsvQueries {
 public:
  explicit CsvQueries(const TextLines& header) : columns_(header) {
    for (std::size_t i = 0; i < 6; ++i) numbers_[i] = columns_.need(header, kNames[i]);
    best_known_ = columns_.find("best_known_m");
  }

  PlanQuery parse(const TextLines& lines) const {
    const auto fields = columns_.fields(lines);
    double v[6];
    for (std::size_t i = 0; i < 6; ++i) v[i] = coordinate(lines, kNames[i], fields[numbers_[i]]);
    PlanQuery query{columns_.id(fields), {v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {}, 0};
    if (best_known_ && !fields[*best_known_].empty()) {
      query.best_known = path_length(lines, "best_known_m",
                                     coordinate(lines, "best_known_m", fields[*best_known_]));
    }
    return query;
  }

 private:
  static constexpr std::array<const char*, 6> kNames = {"from_x", "from_y", "from_z",
                                                        "to_x",   "to_y",   "to_z"};
  Columns columns_;
  std::array<std::size_t, 6> numbers_{};
  std::optional<std::size_t> best_known_;
};

}  // namespace

std::vector<PlanQuery> read_plan_queries(std::istream& in, std::string_view source) {
  TextLines lines(in, source);
  std::vector<PlanQuery> queries;
  std::optional<CsvQueries> csv;
  std::set<std::string> ids;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    if (queries.empty() && !csv && !lines.line().starts_with('{')) {
      csv.emplace(lines);
      continue;
    }
    queries.push_back(csv ? csv->parse(lines) : parse_json(lines));
    queries.back().line = lines.number();
    if (!ids.insert(queries.back().id).second) {
      lines.refuse(fmt::format("expected each id once, found \"{}\" again", queries.back().id));
    }
  }
  if (queries.empty()) lines.refuse("expected at least one query, found none");
  return queries;
}

std::map<std::string, double> read_reference_lengths(std::istream& in, std::string_view source) {
  TextLines lines(in, source);
  std::map<std::string, double> lengths;
  std::optional<Columns> columns;
  std::size_t length = 0;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    if (!columns) {
      columns.emplace(lines);
      length = columns->need(lines, "length");
      continue;
    }
    const auto fields = columns->fields(lines);
    const double value = coordinate(lines, "length", fields[length]);
    if (!lengths.emplace(columns->id(fields), path_length(lines, "length", value)).second) {
      lines.refuse(fmt::format("expected each id once, found \"{}\" again", columns->id(fields)));
    }
  }
  if (lengths.empty()) lines.refuse("expected at least one length, found none");
  return lengths;
}

}  // namespace geom
