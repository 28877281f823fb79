#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "geom/text/rounded.h"
#include "home_band.h"
#include "shapes.h"
#include "traj/figure/home.h"

namespace traj::figure {
namespace {

constexpr double kLeft = 190;
constexpr double kRight = 26;

// A row of the table of flights.
struct Row {
  std::string label;
  double duration = 0;
  std::optional<TimeSpans> returns;  // gaps
  std::optional<TimeSpans> ways;     // gaps
  std::string least;

  double share() const { return share_without(returns ? *returns : *ways, duration); }
};

constexpr std::size_t kMostRows = 40;
constexpr double kTableRow = 22;
constexpr double kBandWidth = 400;
constexpr double kReturnCell = 86;  // where columns end, from the band on
constexpr double kWayCell = 174;
constexpr double kHeightCell = 294;
constexpr double kTableTop = 128;

std::string label_of(const std::string& id) {
  return id.size() > 24 ? geom::excerpt(id, 22) : geom::excerpt(id);
}

// "74.5 m", or the best where none is enough: "90 m: 81.2 %".
std::string height_words(const ReturnSummary& returns) {
  if (returns.least_height) return fmt::format("{:.4g} m", geom::rounded_up(*returns.least_height));
  if (!returns.gains_by_height()) return "none";
  return fmt::format("{:.4g} m: {}", *returns.best_height, percent(*returns.best_share));
}

std::vector<Row> rows_of(const HomeFlight& flight) {
  std::optional<TimeSpans> ways;
  if (!flight.ways.empty()) ways = without(planned_times(flight.ways), flight.duration());
  if (flight.returns.empty()) return {{label_of(flight.id), flight.duration(), {}, ways, ""}};
  std::vector<Row> out;
  for (const ReturnSummary& one : flight.returns) {
    Row row{label_of(flight.id), one.duration, spans_of(one), ways, ""};
    if (flight.returns.size() > 1) row.label += ", " + one.action;
    if (one.action == "rtl") {
      row.least = height_words(one);
    }
    out.push_back(std::move(row));
  }
  return out;
}

// Gaps that touch are one here: nothing is said of each.
TimeSpans joined(const TimeSpans& gaps) {
  TimeSpans out;
  for (const auto& [from, until] : gaps) {
    if (!out.empty() && from <= out.back().second) {
      out.back().second = until;
    } else {
      out.emplace_back(from, until);
    }
  }
  return out;
}

void draw_row(Svg& svg, const Row& row, double top) {
  const Frame frame{kLeft, top, kBandWidth, kTableRow, {0, 0}, {std::max(row.duration, 1e-3), 1}};
  svg.text({kLeft - 12, top + 15}, row.label, {.anchor = "end"});
  const bool both = row.returns && row.ways;
  const double height = both ? 8 : 14;
  if (row.returns) {
    draw_band(svg, frame, {top + 3, height, kReturnFill, joined(*row.returns), row.duration});
  }
  if (row.ways) {
    draw_band(svg, frame, {top + (both ? 12 : 3), height, kWayFill, *row.ways, row.duration});
  }
  const auto cell = [&](double x, const std::string& words) {
    svg.text({kLeft + kBandWidth + x, top + 15}, words, {.anchor = "end"});
  };
  if (row.returns) cell(kReturnCell, percent(share_without(*row.returns, row.duration)));
  if (row.ways) cell(kWayCell, percent(share_without(*row.ways, row.duration)));
  if (!row.least.empty()) cell(kHeightCell, row.least);
}

// "return proved from every instant of 3 of 12 flights, and from 81.2 % of all their time"
std::string all_words(std::span<const Row> rows, std::optional<TimeSpans> Row::*gaps,
                      std::string_view what) {
  std::size_t whole = 0;
  std::size_t count = 0;
  double held = 0;
  double time = 0;
  for (const Row& row : rows) {
    if (!(row.*gaps)) continue;
    ++count;
    whole += (row.*gaps)->empty();
    time += row.duration;
    held += row.duration * share_without(*(row.*gaps), row.duration);
  }
  if (count == 0) return "";
  return fmt::format("{} from every instant of {} of {}, and from {} of all their time", what,
                     whole, geom::counted(count, "flight"),
                     percent(time > 0         ? held / time
                             : whole == count ? 1.0
                                              : 0.0));
}

void draw_table_head(Svg& svg, std::span<const Row> rows, std::size_t flights) {
  svg.text({20, 26}, geom::counted(flights, "flight") + ", the smallest share first", {.size = 16});
  double y = 50;
  std::string returned = all_words(rows, &Row::returns, "A return is proved");
  if (!returned.empty()) returned += "; what battery it takes is not looked at";
  for (const std::string& words :
       {returned, all_words(rows, &Row::ways, "There is a planned way home")}) {
    if (words.empty()) continue;
    svg.text({20, y}, words);
    y += 18;
  }
  const auto has = [&](std::optional<TimeSpans> Row::*gaps) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return bool(row.*gaps); });
  };
  draw_band_key(svg, {kLeft, 94}, has(&Row::returns), has(&Row::ways));
  const auto head = [&](double x, const char* words) {
    svg.text({kLeft + kBandWidth + x, kTableTop - 8}, words,
             {.size = 11, .anchor = "end", .colour = kLimit});
  };
  svg.text({kLeft, kTableTop - 8}, "from take-off to landing", {.size = 11, .colour = kLimit});
  if (has(&Row::returns)) head(kReturnCell, "return proved");
  if (has(&Row::ways)) head(kWayCell, "planned way");
  if (has(&Row::returns)) head(kHeightCell, "least return height");
}

// How many flights have which share; `top`: of its frame.
void draw_histogram(Svg& svg, std::span<const Row> rows, double top) {
  constexpr int kBins = 20;
  std::vector<std::size_t> counts(kBins + 1, 0);  // the last: the whole of the time
  for (const Row& row : rows) {
    const double share = row.share();
    ++counts[share >= 1 ? kBins
                        : std::min(static_cast<std::size_t>(share * kBins), counts.size() - 2)];
  }
  const double most = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  const Frame frame{kLeft, top, kBandWidth, 150, {0, 0}, {105, 1.08 * std::max(most, 1.0)}};
  svg.text({kLeft, top - 10}, "all of them: how many have which share (last bar: all of the time)");
  svg.grid(frame);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const Point low = frame.at({5.0 * static_cast<double>(i), 0});
    const Point high = frame.at({5.0 * static_cast<double>(i + 1), static_cast<double>(counts[i])});
    svg.rectangle({low.x + 0.5, high.y}, high.x - low.x - 1, std::max(1.0, low.y - high.y),
                  fmt::format("fill=\"{}\"", i == kBins ? kReturnFill : colour(1)));
  }
  svg.axes(frame, "share of the flight's time with a way home, %", "flights");
}

}  // namespace

std::string homes(std::span<const HomeFlight> flights) {
  std::vector<Row> rows;
  for (const HomeFlight& flight : flights) {
    for (Row& row : rows_of(flight)) rows.push_back(std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.share() < b.share(); });
  const std::size_t shown = std::min(rows.size(), kMostRows);
  const bool more = rows.size() > shown;
  const double bottom = kTableTop + kTableRow * static_cast<double>(shown);
  Svg svg(kLeft + kBandWidth + kHeightCell + kRight, bottom + (more ? 284 : 20));
  draw_table_head(svg, rows, flights.size());
  for (std::size_t i = 0; i < shown; ++i) {
    draw_row(svg, rows[i], kTableTop + kTableRow * static_cast<double>(i));
  }
  if (more) {
    svg.text({kLeft, bottom + 16}, fmt::format("and {} more", rows.size() - shown));
    draw_histogram(svg, rows, bottom + 66);
  }
  return svg.str();
}

}  // namespace traj::figure
