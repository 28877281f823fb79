#include "traj/figure/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "geom/base/percentile.h"
#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "geom/text/rounded.h"
#include "shapes.h"

namespace traj::figure {
namespace {

constexpr double kLeft = 84;
constexpr double kWidth = 760;
constexpr double kRight = 26;
constexpr double kTop = 64;
constexpr double kHeight = 150;
constexpr double kGap = 92;  // with the axis of one panel and the note of the next
constexpr int kBins = 40;

struct Drawing {
  Svg svg;
  double top = kTop;

  // The next panel, for data from `low` to `high`, with its note.
  Frame panel(Point low, Point high, std::string_view note) {
    const Frame frame{kLeft, top, kWidth, kHeight, low, high};
    svg.grid(frame);
    svg.text({kLeft, top - 10}, note);
    top += kHeight + kGap;
    return frame;
  }
};

struct Labels {
  std::string_view note;
  std::string_view x;
  std::string_view y;
};

void draw_bars(Drawing& drawing, const Histogram& bars, std::string_view fill,
               const Labels& labels) {
  const double most = std::max(1.0, static_cast<double>(bars.most()));
  const Frame frame = drawing.panel({bars.low, 0}, {bars.high(), 1.08 * most}, labels.note);
  for (std::size_t i = 0; i < bars.counts.size(); ++i) {
    if (bars.counts[i] == 0) continue;
    const double x = bars.low + bars.width * static_cast<double>(i);
    const Point low = frame.at({x, 0});
    const Point high = frame.at({x + bars.width, static_cast<double>(bars.counts[i])});
    drawing.svg.rectangle({low.x + 0.5, high.y}, std::max(1.0, high.x - low.x - 1),
                          std::max(1.0, low.y - high.y), fmt::format("fill=\"{}\"", fill));
  }
  drawing.svg.axes(frame, labels.x, labels.y);
}

void draw_delays(Drawing& drawing, std::span<const FleetFlight> flights) {
  std::vector<double> delays;
  for (const FleetFlight& flight : flights) {
    if (flight.delay) delays.push_back(*flight.delay);
  }
  std::sort(delays.begin(), delays.end());
  std::string note = "no delays: the records do not say when flights were to begin (earliest)";
  if (!delays.empty()) {
    const double mean =
        std::accumulate(delays.begin(), delays.end(), 0.0) / static_cast<double>(delays.size());
    const auto late = std::count_if(delays.begin(), delays.end(), [](double d) { return d > 0; });
    note = fmt::format(
        "{} of {} late; delay {:.3g} s in the mean, 95 % within {:.3g} s, {:.3g} s "
        "at most",
        late, geom::counted(delays.size(), "flight"), mean, geom::percentile(delays, 0.95),
        delays.back());
  }
  draw_bars(drawing, histogram(delays, kBins), colour(0), {note, "delay, s", "flights"});
}

void draw_distances(Drawing& drawing, std::span<const FleetFlight> flights,
                    const Approaches& approaches) {
  std::vector<double> distances;
  for (const Approach& approach : approaches.list) distances.push_back(approach.distance);
  std::string note = fmt::format("no pair within {:g} m while both fly", approaches.within);
  if (!distances.empty()) {
    const Approach& least = approaches.list.front();
    note = fmt::format(
        "{} within {:g} m while both fly; least {:.4g} m: {} and {} at {:.6g} s (not a proof)",
        geom::counted(distances.size(), "pair"), approaches.within,
        geom::rounded_down(least.distance), geom::excerpt(flights[least.flights.first].id),
        geom::excerpt(flights[least.flights.second].id), least.time);
  }
  draw_bars(drawing, histogram(distances, kBins), colour(1),
            {note, "least distance of a pair, m", "pairs"});
}

void draw_density(Drawing& drawing, std::span<const FleetFlight> flights) {
  const std::vector<InTheAir> steps = in_the_air(flights);
  const auto most =
      std::max_element(steps.begin(), steps.end(),
                       [](const InTheAir& a, const InTheAir& b) { return a.flights < b.flights; });
  const double begin = steps.front().time;
  const double end = std::max(steps.back().time, begin + 1e-3);
  const Frame frame = drawing.panel(
      {begin, 0}, {end, 1.08 * std::max(1.0, static_cast<double>(most->flights))},
      fmt::format("{} in the air at once at most, at {:.6g} s", most->flights, most->time));
  std::vector<Point> curve;
  double before = 0;
  for (const InTheAir& step : steps) {
    curve.push_back(frame.at({step.time, before}));
    before = static_cast<double>(step.flights);
    curve.push_back(frame.at({step.time, before}));
  }
  drawing.svg.polyline(curve, fmt::format("stroke=\"{}\" stroke-width=\"1.5\"", colour(2)));
  drawing.svg.axes(frame, "time, s", "flights in the air");
}

}  // namespace

std::vector<InTheAir> in_the_air(std::span<const FleetFlight> flights) {
  std::map<double, long> changes;
  for (const FleetFlight& flight : flights) {
    ++changes[flight.start];
    --changes[flight.start + flight.duration];
  }
  std::vector<InTheAir> out;
  long now = 0;
  for (const auto& [time, change] : changes) {
    now += change;
    out.push_back({time, static_cast<std::size_t>(now)});
  }
  return out;
}

std::string fleet(std::span<const FleetFlight> flights, const Approaches& approaches) {
  Drawing drawing{Svg(kLeft + kWidth + kRight, kTop + 3 * kHeight + 2 * kGap + 56)};
  drawing.svg.text({kLeft, 26}, geom::counted(flights.size(), "flight"), {.size = 16});
  draw_delays(drawing, flights);
  draw_distances(drawing, flights, approaches);
  draw_density(drawing, flights);
  return drawing.svg.str();
}

}  // namespace traj::figure
