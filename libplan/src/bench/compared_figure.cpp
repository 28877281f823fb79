#include "plan/bench/compared_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/figure/palette.h"
#include "geom/figure/svg.h"
#include "geom/figure/ticks.h"

namespace plan::bench {
namespace {

using geom::figure::colour;
using geom::figure::kInk;
using geom::figure::Svg;
using geom::figure::ticks;
using Spread = MethodFigures::Spread;

constexpr double kLeft = 190;
constexpr double kWidth = 300;  // of each of the two axes
constexpr double kBetween = 46;
constexpr double kRow = 26;
constexpr double kTop = 92;
constexpr double kMost = 1e12;  // of any figure in a report

double figure_of(const geom::JsonFields& fields, const nlohmann::json& object, const char* key) {
  if (!object.is_object() || !object.contains(key)) {
    fields.refuse({.expected = fmt::format("the key \"{}\" in {}", key, object.dump())});
  }
  const double value = fields.number(object[key], key);
  if (value < 0 || value > kMost) {
    fields.refuse({.key = std::string(key),
                   .expected = fmt::format("within 0 to {:g}", kMost),
                   .found = fmt::to_string(value)});
  }
  return value;
}

std::optional<Spread> spread(const geom::JsonFields& fields, const nlohmann::json& method,
                             const char* key) {
  if (!method.contains(key)) return std::nullopt;
  const nlohmann::json& object = method[key];
  const double mean = figure_of(fields, object, "mean");
  if (!object.contains("p50")) return Spread{mean, mean, mean};
  return Spread{figure_of(fields, object, "p50"), mean, figure_of(fields, object, "p99")};
}

// An axis from `low` to `high`, perhaps logarithmic.
struct Axis {
  double left = 0;
  double low = 0;
  double high = 1;
  bool logarithmic = false;

  double at(double value) const {
    if (!logarithmic) return left + (value - low) / (high - low) * kWidth;
    return left + std::log(value / low) / std::log(high / low) * kWidth;
  }
  std::vector<double> marks() const {
    if (!logarithmic) return ticks(low, high, 5);
    std::vector<double> out;
    for (double v = low; v <= high * 1.0001; v *= 10) out.push_back(v);
    return out;
  }
};

template <class Get>
std::vector<Spread> all(std::span<const ShownReport> reports, const Get& get) {
  std::vector<Spread> out;
  for (const ShownReport& report : reports) {
    for (const MethodFigures& m : report.methods) {
      if (const auto& s = get(m)) out.push_back(*s);
    }
  }
  return out;
}

Axis time_axis(std::span<const ShownReport> reports) {
  double low = 1e300;
  double high = 0;
  for (const Spread& s : all(reports, [](const auto& m) { return m.time; })) {
    low = std::min({low, s.median, s.mean});
    high = std::max({high, s.p99, s.mean});
  }
  low = std::clamp(low, 1e-6, 1e9);
  high = std::clamp(high, low, 1e12);
  const double first = std::pow(10, std::floor(std::log10(low)));
  return {kLeft, first, std::max(10 * first, std::pow(10, std::ceil(std::log10(high)))), true};
}

using Length = std::optional<Spread> MethodFigures::*;

// Over the best known, where every method that found anything has that.
Length shown_length(std::span<const ShownReport> reports) {
  for (const ShownReport& report : reports) {
    for (const MethodFigures& m : report.methods) {
      if (m.found > 0 && !m.length_over_best) return &MethodFigures::length_over_straight;
    }
  }
  return &MethodFigures::length_over_best;
}

Axis length_axis(std::span<const ShownReport> reports, Length of) {
  double low = 1;
  double high = 1.001;
  for (const Spread& s : all(reports, [of](const auto& m) { return m.*of; })) {
    low = std::min({low, s.median, s.mean});
    high = std::max({high, s.p99, s.mean});
  }
  const double room = 0.05 * (high - low);
  return {kLeft + kWidth + kBetween, low - room, high + room, false};
}

// A bar from the median to the 99th percentile, a disc at the median and a stroke at the mean.
void draw_spread(Svg& svg, const Axis& axis, double y, const Spread& s, std::string_view colour) {
  const auto x = [&](double v) { return axis.at(axis.logarithmic ? std::max(v, axis.low) : v); };
  svg.polyline({{x(s.median), y}, {x(s.p99), y}},
               fmt::format("stroke=\"{}\" stroke-width=\"2.5\"", colour));
  svg.polyline({{x(s.p99), y - 5}, {x(s.p99), y + 5}},
               fmt::format("stroke=\"{}\" stroke-width=\"2\"", colour));
  svg.circle({x(s.median), y}, 4.5, fmt::format("fill=\"{}\"", colour));
  svg.polyline({{x(s.mean), y - 7}, {x(s.mean), y + 7}},
               fmt::format("stroke=\"{}\" stroke-width=\"1.5\"", kInk));
}

void draw_axis(Svg& svg, const Axis& axis, double bottom, std::string_view label) {
  for (const double v : axis.marks()) {
    const double x = axis.at(v);
    svg.polyline({{x, kTop - 14}, {x, bottom}}, "stroke=\"#e6e6e6\" stroke-width=\"1\"");
    svg.polyline({{x, bottom}, {x, bottom + 5}}, "stroke=\"#444\" stroke-width=\"1\"");
    svg.text({x, bottom + 18}, fmt::format("{:g}", v), {.anchor = "middle"});
  }
  svg.polyline({{axis.left, bottom}, {axis.left + kWidth, bottom}},
               "stroke=\"#444\" stroke-width=\"1\"");
  svg.text({axis.left + kWidth / 2, bottom + 38}, label, {.size = 13, .anchor = "middle"});
}

void draw_key(Svg& svg) {
  svg.text({kLeft, 56}, "disc: median, stroke: mean, end: 99th percentile");
}

}  // namespace

ShownReport parse_report(const geom::JsonFields& report, std::string_view name) {
  report.require_type("benchmark");
  ShownReport out{std::string(name), {}};
  const nlohmann::json& methods = report.value("methods");
  if (!methods.is_array() || methods.empty()) report.refuse({.expected = "a list of methods"});
  for (const nlohmann::json& m : methods) {
    if (!m.is_object() || !m.contains("method") || !m["method"].is_string()) {
      report.refuse({.expected = "the name of each method"});
    }
    MethodFigures figures{m["method"].get<std::string>()};
    figures.trials = static_cast<std::size_t>(figure_of(report, m, "trials"));
    figures.found = static_cast<std::size_t>(figure_of(report, m, "found"));
    figures.time = spread(report, m, "time_ms");
    figures.length_over_best = spread(report, m, "length_over_reference");
    figures.length_over_straight = spread(report, m, "length_over_straight");
    out.methods.push_back(std::move(figures));
  }
  return out;
}

std::string compared_figure(std::span<const ShownReport> reports) {
  double rows = 0;
  for (const ShownReport& report : reports) rows += 1 + static_cast<double>(report.methods.size());
  const double bottom = kTop + rows * kRow;
  Svg svg(kLeft + 2 * kWidth + kBetween + 110, bottom + 56);
  svg.text({20, 30}, "Planners compared", {.size = 16});
  draw_key(svg);
  const Axis time = time_axis(reports);
  const Length of = shown_length(reports);
  const Axis length = length_axis(reports, of);
  draw_axis(svg, time, bottom, "time a query, ms");
  draw_axis(svg, length, bottom,
            of == &MethodFigures::length_over_best ? "path length over the best known"
                                                   : "path length over the straight line");
  const double found_at = length.left + kWidth + 80;
  svg.text({found_at, kTop - 20}, "found", {.anchor = "end"});
  double y = kTop + 8;
  for (const ShownReport& report : reports) {
    svg.text({20, y + 4}, report.name, {.size = 13, .colour = "#555555"});
    y += kRow;
    for (std::size_t i = 0; i < report.methods.size(); ++i, y += kRow) {
      const MethodFigures& m = report.methods[i];
      svg.text({kLeft - 12, y + 4}, m.method, {.size = 13, .anchor = "end"});
      if (m.time) draw_spread(svg, time, y, *m.time, colour(i));
      if (m.*of) draw_spread(svg, length, y, *(m.*of), colour(i));
      svg.text({found_at, y + 4}, fmt::format("{} of {}", m.found, m.trials), {.anchor = "end"});
    }
  }
  return svg.str();
}

}  // namespace plan::bench
