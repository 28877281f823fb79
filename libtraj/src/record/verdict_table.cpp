#include "traj/record/verdict_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "traj/record/verdict.h"

namespace traj {
namespace {

constexpr std::size_t kWidestId = 40;

std::string coloured(std::string_view text, bool ok, Colour colour) {
  if (colour == Colour::none) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", ok ? 32 : 31, text);
}

// How many characters a text in UTF-8 has.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string blanks(std::string_view text, std::size_t wide) {
  return std::string(wide > width(text) ? wide - width(text) : 0, ' ');
}

std::string number(const std::optional<double>& value, std::string_view unit) {
  return value ? fmt::format("{:.4g} {}", *value, unit) : "-";
}

// How far the pairs are kept apart.
std::string apart_in_words(const TogetherTask& task) {
  const auto& zone = task.rule.spacing.zone;
  std::string out = "so that no two vehicles touch";
  if (zone) {
    out = fmt::format("by more than {:.6g} m{} or more than {:.6g} m in height", zone->reach.x(),
                      zone->round
                          ? " across"
                          : fmt::format(" along x, more than {:.6g} m along y", zone->reach.y()),
                      zone->reach.z());
  }
  if (const auto& zone = task.rule.spacing.downwash) {
    out += fmt::format(", and none is within {:.6g} m across and {:.6g} m below another",
                       zone->reach.x(), zone->reach.z());
  }
  if (task.overridden)
    out += ", with a vehicle or margin smaller than its record says (--override or --spare)";
  if (!task.dropped.empty()) {
    out += fmt::format(
        ", without {} left out",
        geom::counted(task.dropped.size(), "refused flight that is", "refused flights that are"));
  }
  return out;
}

}  // namespace

void VerdictTable::add(const ReportRecord& report, const geom::BoxMap& map) {
  const CheckResult& result = report.result;
  Row& row = rows_.emplace_back();
  row.id = geom::excerpt(report.id, kWidestId);
  row.word = verdict_word(report);
  row.ok = accepted(report);
  if (result.clearance) row.clearance = result.clearance->value;
  if (result.duration > 0) row.duration = result.duration;
  row.sentence = in_words(report, map);
  row.why = row.ok ? rests_on_in_words(report) : row.sentence;
}

void VerdictTable::add(const SampledReport& report, const geom::BoxMap& map) {
  const SampledFlight& result = report.result;
  const std::string_view reason = reason_of(report, map);
  Row& row = rows_.emplace_back();
  row.id = geom::excerpt(report.id, kWidestId);
  row.ok = reason.empty();
  row.yes = "sampled";
  row.word = row.ok ? "sampled" : reason;
  if (result.clearance) row.clearance = result.clearance->value;
  if (result.duration > 0) row.duration = result.duration;
  row.sentence = in_words(report, map);
  row.why = row.ok ? rests_on_in_words(report) : row.sentence;
}

void VerdictTable::add(const TogetherResult& result, const TogetherTask& task,
                       std::size_t left_out) {
  for (const RefusedPair& pair : result.refused) {
    lines_.push_back({false, traj::in_words(pair, task)});
  }
  if (left_out > 0) {
    lines_.push_back({false, fmt::format("{} no trajectory to hold against the others",
                                         geom::counted(left_out, "record has", "records have"))});
  }
  if (result.ok() && left_out == 0) {
    lines_.push_back({true, fmt::format("{} proved to keep apart at every instant{}, {}",
                                        geom::counted(result.pairs, "pair is", "pairs are"),
                                        task.rule.parked == Parked::gone ? " while both fly" : "",
                                        apart_in_words(task))});
  }
}

void VerdictTable::add(std::span<const MovingConflict> conflicts, const MovingSummary& summary) {
  for (const MovingConflict& one : conflicts) lines_.push_back({false, traj::in_words(one)});
  if (!summary.ok()) return;
  lines_.push_back({true, fmt::format("{} proved clear of {}",
                                      geom::counted(summary.flights, "flight is", "flights are"),
                                      geom::counted(summary.obstacles, "obstacle that moves",
                                                    "obstacles that move"))});
}

std::string VerdictTable::table(Colour colour) const {
  std::size_t id = 2;
  std::size_t word = 7;
  for (const Row& row : rows_) {
    id = std::max(id, width(row.id));
    word = std::max(word, width(row.word));
  }
  std::string out = fmt::format("{:{}}  {:{}}  {:>11}  {:>9}  why\n", "id", id, "verdict", word,
                                "clearance", "duration");
  for (const Row& row : rows_) {
    out += fmt::format("{}{}  {}{}  {:>11}  {:>9}{}{}\n", row.id, blanks(row.id, id),
                       coloured(row.word, row.ok, colour), blanks(row.word, word),
                       number(row.clearance, "m"), number(row.duration, "s"),
                       row.why.empty() ? "" : "  ", row.why);
  }
  return out + summary();
}

std::string VerdictTable::summary() const {
  std::map<std::string, std::size_t, std::less<>> reasons;
  std::size_t refused = 0;
  for (const Row& row : rows_) {
    if (row.ok) continue;
    ++refused;
    ++reasons[row.word];
  }
  if (refused == 0) {
    return fmt::format("all {} records are {}\n", rows_.size(), rows_.front().yes);
  }
  std::string out = fmt::format("{} of {} records are refused:", refused, rows_.size());
  std::string_view comma = " ";
  for (const auto& [reason, count] : reasons) {
    out += fmt::format("{}{} {}", comma, count, reason);
    comma = ", ";
  }
  return out + '\n';
}

std::string VerdictTable::text(Colour colour) const {
  std::string out;
  if (rows_.size() == 1) {
    const Row& row = rows_.front();
    out = fmt::format("{}: {}: {}\n", row.id,
                      coloured(row.ok ? row.yes : "refused", row.ok, colour), row.sentence);
  } else if (!rows_.empty()) {
    out = table(colour);
  }
  for (const Line& line : lines_) {
    out += fmt::format("{}: {}\n", coloured(line.ok ? "proved" : "refused", line.ok, colour),
                       line.text);
  }
  return out;
}

}  // namespace traj
