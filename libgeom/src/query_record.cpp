#include "geom/io/query_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "geom/io/json_fields.h"
#include "text_table.h"

namespace geom {
namespace {

PlanQuery parse_json(const TextLines& lines) {
  const JsonFields fields(lines.line(), lines.source(), lines.number());
  return {fields.text("id", fmt::format("q{}", lines.number())), fields.point("from"),
          fields.point("to")};
}

class CsvQueries {
 public:
  explicit CsvQueries(const TextLines& header) {
    const auto fields = split_fields(header.line());
    const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
      const auto at = std::find(fields.begin(), fields.end(), name);
      if (at == fields.end()) return std::nullopt;
      return static_cast<std::size_t>(at - fields.begin());
    };
    const auto need = [&](std::string_view name) {
      const auto at = find(name);
      if (!at) {
        header.refuse(
            fmt::format("expected a column {}, found \"{}\"", name, header.line().substr(0, 80)));
      }
      return *at;
    };
    id_ = need("id");
    for (std::size_t i = 0; i < 6; ++i) numbers_[i] = need(kNames[i]);
    set_ = find("set");
    count_ = fields.size();
  }

  PlanQuery parse(const TextLines& lines) const {
    const auto fields = split_fields(lines.line());
    if (fields.size() != count_) {
      lines.refuse(fmt::format("expected {} fields, found {}: \"{}\"", count_, fields.size(),
                               lines.line().substr(0, 80)));
    }
    double v[6];
    for (std::size_t i = 0; i < 6; ++i) v[i] = coordinate(lines, kNames[i], fields[numbers_[i]]);
    const std::string id = set_ ? fields[*set_] + '-' + fields[id_] : fields[id_];
    return {id, {v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  }

 private:
  static constexpr std::array<const char*, 6> kNames = {"from_x", "from_y", "from_z",
                                                        "to_x",   "to_y",   "to_z"};
  std::size_t id_ = 0;
  std::optional<std::size_t> set_;
  std::array<std::size_t, 6> numbers_{};
  std::size_t count_ = 0;
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
    if (!ids.insert(queries.back().id).second) {
      lines.refuse(fmt::format("expected each id once, found \"{}\" again", queries.back().id));
    }
  }
  if (queries.empty()) lines.refuse("expected at least one query, found none");
  return queries;
}

}  // namespace geom
