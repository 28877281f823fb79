#include "plan/bench/trial_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/base/percentile.h"
#include "plan/bench/measure.h"

namespace plan::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMilli = 1e3;

double mean(const std::vector<double>& values) {
  RunningMean out;
  for (const double value : values) out.add(value);
  return out.mean();
}

std::vector<double> milliseconds(const Run& run) {
  std::vector<double> out;
  for (const Trial& trial : run.trials) out.push_back(kMilli * trial.seconds);
  return out;
}

// Of paths between ends that are apart.
std::vector<double> over_straight(const Run& run) {
  std::vector<double> out;
  for (const Trial& trial : run.trials) {
    if (trial.verdict != Verdict::found || trial.straight == 0) continue;
    out.push_back(trial.length / trial.straight);
  }
  return out;
}

std::vector<double> over_reference(const Run& run) {
  std::vector<double> out;
  for (const Trial& trial : run.trials) {
    if (trial.verdict != Verdict::found || !trial.best_known) continue;
    out.push_back(trial.length / *trial.best_known);
  }
  return out;
}

std::vector<double> over_bound(const Run& run) {
  std::vector<double> out;
  for (const Trial& trial : run.trials) {
    if (trial.bound && trial.bound->length > 0) out.push_back(trial.length / trial.bound->length);
  }
  return out;
}

std::size_t closed_bounds(const Run& run) {
  return static_cast<std::size_t>(
      std::count_if(run.trials.begin(), run.trials.end(),
                    [](const Trial& trial) { return trial.bound && trial.bound->closed; }));
}

std::vector<double> expanded(const Run& run) {
  std::vector<double> out;
  for (const Trial& trial : run.trials) {
    if (trial.expanded) out.push_back(static_cast<double>(*trial.expanded));
  }
  return out;
}

Json time_of(const Run& run) {
  if (run.one_process) {
    return {{"clock", "wall of the process, over its queries"},
            {"mean", kMilli * run.trials.front().seconds}};
  }
  const std::vector<double> ms = milliseconds(run);
  RunningMean time;
  for (const double value : ms) time.add(value);
  return {{"clock", "thread CPU"},
          {"mean", time.mean()},
          {"p50", geom::percentile(ms, 0.5)},
          {"p90", geom::percentile(ms, 0.9)},
          {"p99", geom::percentile(ms, 0.99)},
          {"max", geom::percentile(ms, 1)},
          {"standard_error", time.standard_error()}};
}

Json ratios(const std::vector<double>& values) {
  return {{"paths", values.size()},
          {"mean", mean(values)},
          {"p50", geom::percentile(values, 0.5)},
          {"p99", geom::percentile(values, 0.99)},
          {"max", geom::percentile(values, 1)}};
}

std::string cell(const std::vector<double>& values, double share) {
  return values.empty() ? "-" : fmt::format("{:.4f}", geom::percentile(values, share));
}

std::string cell_mean(const std::vector<double>& values) {
  return values.empty() ? "-" : fmt::format("{:.4f}", mean(values));
}

constexpr const char* kRow =
    "{:<24.24} {:>7} {:>7} {:>7} {:>7} {:>7} {:>10} {:>10} {:>10} {:>8} {:>8} {:>8} {:>8} {:>9} "
    "{:>8} {:>9} {:>8}\n";

std::string row(const Run& run, const Run& first) {
  const std::vector<double> ms = milliseconds(run);
  const std::vector<double> straight = over_straight(run);
  const std::vector<double> reference = over_reference(run);
  const std::vector<double> bound = over_bound(run);
  const Comparison against = compare(run, first);
  const auto time = [&](double share) {
    return run.one_process ? "-" : fmt::format("{:.4f}", geom::percentile(ms, share));
  };
  return fmt::format(kRow, run.method, run.trials.size(), count(run, Verdict::found),
                     count(run, Verdict::unreachable), count(run, Verdict::failed) + run.extra,
                     count(run, Verdict::invalid), fmt::format("{:.4f}", mean(ms)), time(0.5),
                     time(0.99), cell_mean(straight), cell(straight, 0.99), cell_mean(reference),
                     cell(reference, 0.99), fmt::format("{:.3g}", against.time),
                     against.length ? fmt::format("{:.4f}", *against.length) : "-",
                     cell_mean(bound), cell(bound, 0.99));
}

}  // namespace

Comparison compare(const Run& run, const Run& first) {
  const std::size_t both = std::min(run.trials.size(), first.trials.size());
  Comparison out;
  RunningMean ours;
  RunningMean theirs;
  RunningMean length;
  for (std::size_t i = 0; i < both; ++i) {
    const Trial& a = run.trials[i];
    const Trial& b = first.trials[i];
    ours.add(a.seconds);
    theirs.add(b.seconds);
    if (a.verdict == Verdict::found && b.verdict == Verdict::found && b.length > 0) {
      length.add(a.length / b.length);
    }
  }
  out.time = theirs.mean() > 0 ? ours.mean() / theirs.mean() : 0;
  out.queries = length.count();
  if (length.count()) out.length = length.mean();
  return out;
}

Json counts(const Run& run) {
  Json out = {{"method", run.method},
              {"trials", run.trials.size()},
              {"found", count(run, Verdict::found)},
              {"unreachable", count(run, Verdict::unreachable)},
              {"failed", count(run, Verdict::failed) + run.extra},
              {"invalid", count(run, Verdict::invalid)}};
  if (run.one_process) {
    out["missing"] = run.missing;
    out["extra"] = run.extra;
  }
  return out;
}

Json report(const Run& run, const Run& first) {
  Json out = counts(run);
  if (run.converged) out["converged"] = *run.converged;
  if (run.build_seconds) out["build_s"] = *run.build_seconds;
  out["time_ms"] = time_of(run);
  if (const auto values = over_straight(run); !values.empty()) {
    out["length_over_straight"] = ratios(values);
  }
  if (const auto values = over_reference(run); !values.empty()) {
    out["length_over_reference"] = ratios(values);
  }
  if (const auto values = over_bound(run); !values.empty()) {
    out["length_over_bound"] = ratios(values);
    out["length_over_bound"]["closed"] = closed_bounds(run);
  }
  if (const auto nodes = expanded(run); !nodes.empty()) {
    out["expanded"] = {{"mean", mean(nodes)},
                       {"p50", geom::percentile(nodes, 0.5)},
                       {"p99", geom::percentile(nodes, 0.99)},
                       {"max", geom::percentile(nodes, 1)}};
  }
  if (run.peak_rss) out["peak_rss_bytes"] = *run.peak_rss;
  const Comparison against = compare(run, first);
  out["against_first"] = {{"time", against.time}, {"paths", against.queries}};
  if (against.length) out["against_first"]["length"] = *against.length;
  return out;
}

std::string table(std::span<const Run> runs) {
  std::string out = fmt::format(kRow, "method", "trials", "found", "unreach", "failed", "invalid",
                                "mean ms", "p50 ms", "p99 ms", "len/line", "p99", "len/best", "p99",
                                "time/1st", "len/1st", "len/bound", "p99");
  for (const Run& run : runs) out += row(run, runs.front());
  for (const Run& run : runs) {
    if (run.build_seconds) {
      out += fmt::format("{}: built in {:.4f} s before the first query\n", run.method,
                         *run.build_seconds);
    }
  }
  return out;
}

}  // namespace plan::bench
