#include "geom/record/query_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "geojson_queries.h"
#include "geom/base/error.h"
#include "geom/record/axes_comment.h"
#include "geom/text/excerpt.h"
#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

double path_length(const TextLines& lines, std::string_view name, double value) {
  if (!(value > 0))
    lines.refuse(
        {.key = std::string(name), .expected = "> 0 metres", .found = fmt::to_string(value)});
  return value;
}

Vec3 located(const Place& place, const TextLines& lines, const Locator* locator) {
  if (const auto* metres = std::get_if<Vec3>(&place)) return *metres;
  if (!locator) lines.refuse({.expected = "places in metres", .found = "one in degrees"});
  return locator->at(place, lines.source(), lines.number());
}

struct Located {
  Vec3 point;
  bool on_earth = false;  // it was said in degrees
};

// A point, or a text that says a place.
Located place(const JsonFields& fields, const char* key, const TextLines& lines,
              const Locator* locator) {
  if (!fields.has(key) || !fields.value(key).is_string()) return {fields.point(key)};
  const std::string text = fields.text(key);
  const auto place = parse_place(text);
  if (!place) {
    lines.refuse({.item = std::string(key),
                  .expected = std::string(kPlaceForms),
                  .found = in_quotes(excerpt(text))});
  }
  return {located(*place, lines, locator), std::holds_alternative<EarthPlace>(*place)};
}

PlanQuery parse_line(const TextLines& lines, const Locator* locator) {
  const JsonFields fields(lines.line(), lines.source(), lines.number());
  PlanQuery query;
  query.id = fields.text("id", fmt::format("q{}", lines.number()));
  const Located from = place(fields, "from", lines, locator);
  const Located to = place(fields, "to", lines, locator);
  query.from = from.point;
  query.from_on_earth = from.on_earth;
  query.to = to.point;
  query.to_on_earth = to.on_earth;
  query.best_known = fields.number("best_known");
  if (query.best_known) path_length(lines, "best_known", *query.best_known);
  query.time = read_flight_time(fields);
  query.asked_of = read_provenance(fields);
  return query;
}

// A CSV table with a header, in which columns are found by their names.
class Columns {
 public:
  explicit Columns(const TextLines& header)
      : header_(header.line()), names_(split_fields(header.line())) {
    id_ = need(header, "id");
    set_ = find(header, "set");
  }

  // Refuses a name that stands twice, because nobody knows which column is meant.
  std::optional<std::size_t> find(const TextLines& header, std::string_view name) const {
    const auto at = std::find(names_.begin(), names_.end(), name);
    if (at == names_.end()) return std::nullopt;
    if (std::find(at + 1, names_.end(), name) != names_.end()) {
      header.refuse({.expected = fmt::format("one column {}", name),
                     .found = "two",
                     .advice = "leave one of them out"});
    }
    return static_cast<std::size_t>(at - names_.begin());
  }

  std::size_t need(const TextLines& header, std::string_view name) const {
    const auto at = find(header, name);
    if (!at) {
      header.refuse({.expected = fmt::format("a column {}", name),
                     .found = in_quotes(header_.substr(0, 80))});
    }
    return *at;
  }

  std::vector<std::string> fields(const TextLines& lines) const {
    auto fields = split_fields(lines.line());
    if (fields.size() != names_.size()) {
      lines.refuse({.expected = fmt::format("{} fields", names_.size()),
                    .found = fmt::format("{}: \"{}\"", fields.size(), lines.line().substr(0, 80))});
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

// The columns that say when a flight begins: those that are there.
class TimeColumns {
 public:
  TimeColumns(const Columns& columns, const TextLines& header) {
    for (std::size_t i = 0; i < at_.size(); ++i) at_[i] = columns.find(header, kNames[i]);
  }

  FlightTime parse(const TextLines& lines, const std::vector<std::string>& fields) const {
    FlightTime time;
    if (at_[0] && !fields[*at_[0]].empty()) {
      time.epoch = epoch_from(fields[*at_[0]]);
      if (!time.epoch) {
        lines.refuse({.key = "epoch",
                      .expected = "an instant in UTC such as 2026-05-04T06:30:00Z (RFC 3339)",
                      .found = in_quotes(excerpt(fields[*at_[0]]))});
      }
    }
    time.start = seconds(lines, fields, 1);
    time.earliest = seconds(lines, fields, 2);
    time.latest = seconds(lines, fields, 3);
    time.priority = priority(lines, fields);
    if (const auto fault = time_fault(time)) lines.refuse(*fault);
    return time;
  }

 private:
  static constexpr std::array kNames = {"epoch", "start_s", "earliest_s", "latest_s", "priority"};

  std::optional<double> seconds(const TextLines& lines, const std::vector<std::string>& fields,
                                std::size_t i) const {
    if (!at_[i] || fields[*at_[i]].empty()) return std::nullopt;
    const auto value = parse_number(fields[*at_[i]]);
    if (!value) {
      lines.refuse({.key = std::string(kNames[i]),
                    .expected = "a number, seconds after the epoch",
                    .found = in_quotes(excerpt(fields[*at_[i]]))});
    }
    return value;
  }

  std::optional<int> priority(const TextLines& lines,
                              const std::vector<std::string>& fields) const {
    if (!at_[4] || fields[*at_[4]].empty()) return std::nullopt;
    const auto value = parse_number(fields[*at_[4]]);
    if (!value || !is_priority(*value)) {
      lines.refuse({.key = "priority",
                    .expected = fmt::format("a whole number within {}", kLargestPriority),
                    .found = in_quotes(excerpt(fields[*at_[4]]))});
    }
    return static_cast<int>(*value);
  }

  std::array<std::optional<std::size_t>, 5> at_;
};

// The three columns of an end, "from" or "to": metres, or degrees and a height.
class EndColumns {
 public:
  EndColumns(const Columns& columns, const TextLines& header, const std::string& end)
      : on_earth_(columns.find(header, end + "_latitude").has_value()) {
    static constexpr std::array kMetres = {"_x", "_y", "_z"};
    static constexpr std::array kDegrees = {"_latitude", "_longitude", "_height"};
    for (std::size_t i = 0; i < at_.size(); ++i) {
      names_[i] = end + (on_earth_ ? kDegrees : kMetres)[i];
      at_[i] = columns.need(header, names_[i]);
    }
    if (on_earth_ && columns.find(header, end + "_x")) {
      header.refuse({.expected = fmt::format("columns {0}_x or {0}_latitude", end),
                     .found = "both",
                     .advice = "leave one of the two places out"});
    }
  }

  Vec3 parse(const TextLines& lines, const std::vector<std::string>& fields,
             const Locator* locator) const {
    if (!on_earth_)
      return {number(lines, fields, 0), number(lines, fields, 1), number(lines, fields, 2)};
    const EarthPlace there{degrees(lines, fields, 0, 90), degrees(lines, fields, 1, 180)};
    const auto height = parse_height(fields[at_[2]]);
    if (!height) {
      lines.refuse({.key = std::string(names_[2]),
                    .expected = "metres, or such as 2above",
                    .found = in_quotes(excerpt(fields[at_[2]]))});
    }
    return located(EarthPlace{there.latitude, there.longitude, height->metres, height->above},
                   lines, locator);
  }

  bool on_earth() const { return on_earth_; }

 private:
  double number(const TextLines& lines, const std::vector<std::string>& fields,
                std::size_t i) const {
    return coordinate(lines, names_[i], fields[at_[i]]);
  }
  double degrees(const TextLines& lines, const std::vector<std::string>& fields, std::size_t i,
                 double most) const {
    const double value = number(lines, fields, i);
    if (!(std::abs(value) <= most)) {
      lines.refuse({.key = std::string(names_[i]),
                    .expected = fmt::format("degrees within {}", most),
                    .found = fmt::to_string(value)});
    }
    return value;
  }

  bool on_earth_;
  std::array<std::string, 3> names_;
  std::array<std::size_t, 3> at_{};
};

class CsvQueries {
 public:
  explicit CsvQueries(const TextLines& header)
      : columns_(header),
        from_(columns_, header, "from"),
        to_(columns_, header, "to"),
        time_(columns_, header),
        best_known_(columns_.find(header, "best_known_m")),
        margin_(columns_.find(header, "margin")) {}

  PlanQuery parse(const TextLines& lines, const Locator* locator) const {
    const auto fields = columns_.fields(lines);
    PlanQuery query{columns_.id(fields),
                    from_.parse(lines, fields, locator),
                    to_.parse(lines, fields, locator),
                    {},
                    0,
                    from_.on_earth(),
                    to_.on_earth(),
                    time_.parse(lines, fields)};
    if (best_known_ && !fields[*best_known_].empty()) {
      query.best_known = path_length(lines, "best_known_m",
                                     coordinate(lines, "best_known_m", fields[*best_known_]));
    }
    if (margin_ && !fields[*margin_].empty()) {
      query.asked_of.margin = coordinate(lines, "margin", fields[*margin_]);
    }
    return query;
  }

 private:
  Columns columns_;
  EndColumns from_;
  EndColumns to_;
  TimeColumns time_;
  std::optional<std::size_t> best_known_;
  std::optional<std::size_t> margin_;
};

// All that is left of the lines, with the one that was read.
std::string rest_of(TextLines& lines) {
  std::string text(lines.line());
  while (lines.next()) text.append("\n").append(lines.line());
  return text;
}

void require_each_id_once(const std::vector<PlanQuery>& queries, std::string_view source) {
  std::set<std::string> ids;
  for (const PlanQuery& query : queries) {
    if (ids.insert(query.id).second) continue;
    throw InputError(source,
                     {.expected = "each id once", .found = fmt::format("\"{}\" again", query.id)});
  }
}

std::vector<PlanQuery> read_geojson(TextLines& lines, const Locator* locator) {
  const nlohmann::json root = parse_json(rest_of(lines), lines.source());
  if (!locator)
    lines.refuse({.expected = "places in metres", .found = "GeoJSON, which has degrees"});
  auto queries = geojson_queries(root, lines.source(), *locator);
  require_each_id_once(queries, lines.source());
  return queries;
}

// The axes that comments before the queries name, for all of them.
class CommentedFrame {
 public:
  void take(const TextLines& lines) {
    const auto named = axes_of_comment(lines.line());
    if (!named) return;
    if (!named->axes || named->downwards || (frame_ && frame_ != named->axes)) {
      lines.refuse(not_these_axes(lines.line(), "places in the axes of the map, enu or neu"));
    }
    frame_ = named->axes;
  }

  void add_to(PlanQuery& query, const TextLines& lines) const {
    if (!frame_) return;
    if (query.asked_of.frame.value_or(*frame_) != *frame_) {
      lines.refuse({.key = "frame",
                    .expected = fmt::format("{}, as a comment names it", name(*frame_)),
                    .found = std::string(name(*query.asked_of.frame))});
    }
    query.asked_of.frame = frame_;
  }

 private:
  std::optional<Axes> frame_;
};

}  // namespace

std::vector<Vec3> ends_in_metres(const PlanQuery& query) {
  std::vector<Vec3> ends;
  if (!query.from_on_earth) ends.push_back(query.from);
  if (!query.to_on_earth) ends.push_back(query.to);
  return ends;
}

std::vector<PlanQuery> read_plan_queries(std::istream& in, std::string_view source,
                                         const Locator* locator) {
  TextLines lines(in, source, true);
  CommentedFrame frame;
  std::vector<PlanQuery> queries;
  std::optional<CsvQueries> csv;
  std::set<std::string> ids;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    if (queries.empty() && !csv) {
      if (lines.line().starts_with('#')) {
        frame.take(lines);
        continue;
      }
      if (looks_like_geojson(lines.line())) return read_geojson(lines, locator);
      if (!lines.line().starts_with('{')) {
        csv.emplace(lines);
        continue;
      }
    }
    queries.push_back(csv ? csv->parse(lines, locator) : parse_line(lines, locator));
    queries.back().line = lines.number();
    frame.add_to(queries.back(), lines);
    if (!ids.insert(queries.back().id).second) {
      lines.refuse(
          {.expected = "each id once", .found = fmt::format("\"{}\" again", queries.back().id)});
    }
  }
  if (queries.empty()) lines.refuse({.expected = "at least one query", .found = "none"});
  return queries;
}

}  // namespace geom
