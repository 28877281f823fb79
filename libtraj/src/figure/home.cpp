#include "traj/figure/home.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "geom/text/rounded.h"
#include "home_band.h"
#include "record/return_verdict.h"
#include "shapes.h"

namespace traj::figure {
namespace {

constexpr double kLeft = 190;
constexpr double kWidth = 680;
constexpr double kRight = 26;
constexpr double kTop = 84;
constexpr double kHeight = 190;
constexpr double kMargins = 120;
constexpr double kGap = 50;
constexpr double kRow = 26;
constexpr double kAxis = 76;  // below the bands: its words, and the note of the next panel
constexpr double kLine = 19;
constexpr std::size_t kMostReasons = 14;

std::string met_words(const ReturnGapSummary& gap) {
  if (gap.reason == "collision") {
    return gap.box ? fmt::format("it meets obstacle {}", *gap.box) : "it meets an obstacle";
  }
  if (gap.reason == "bounds") return "it leaves the map's bounds";
  if (gap.reason == "fence") {
    return gap.fence ? fmt::format("it leaves fence {}", *gap.fence) : "it leaves a fence";
  }
  if (gap.reason == "landing") return "there is no level ground as high as home";
  return "it may go to another place";
}

// "14.2 to 17.6 s, item 4 (leg): on its way home it meets obstacle 1135 (px4:1.17)"
std::string gap_words(const ReturnGapSummary& gap) {
  std::string out = fmt::format("{:.1f} to {:.1f} s", gap.from, gap.until);
  if (gap.item) {
    out += fmt::format(", item {}{}", *gap.item, gap.part.empty() ? "" : " (" + gap.part + ")");
  }
  out += fmt::format(": {} {}", phase_in_words(gap.phase), met_words(gap));
  return gap.autopilot.empty() ? out : out + fmt::format(" ({})", geom::excerpt(gap.autopilot));
}

std::string_view action_words(std::string_view action) {
  if (action == "land") return "landing";
  return action == "hold" ? "holding" : "return";
}

// "rtl, 60 m above home"
std::string band_words(const ReturnSummary& returns) {
  if (returns.action != "rtl") return returns.action;
  return fmt::format("{}, {:.4g} m above home", returns.action, returns.height);
}

// What other return heights would do.
std::string height_words(const ReturnSummary& returns) {
  if (returns.action != "rtl") return "";
  if (returns.least_height) {
    return fmt::format("at {:.4g} m above home it is proved from every instant",
                       geom::rounded_up(*returns.least_height));
  }
  if (returns.gains_by_height()) {
    return fmt::format("at {:.4g} m above home it is proved for {}, and at no height for more",
                       *returns.best_height, percent(*returns.best_share));
  }
  return "no return height makes all of it safe";
}

// Draws one flight from top to bottom.
class Sheet {
 public:
  explicit Sheet(const HomeFlight& flight)
      : flight_(flight),
        duration_(flight.duration()),
        planned_(planned_times(flight.ways)),
        svg_(kLeft + kWidth + kRight, total_height()) {}

  std::string drawn() {
    svg_.text({20, 26}, title(), {.size = 16});
    if (!flight_.returns.empty()) svg_.text({20, 48}, subtitle(), {.colour = kLimit});
    draw_band_key(svg_, {kLeft, 66}, !flight_.returns.empty(), !flight_.ways.empty());
    if (!flight_.height.empty()) draw_height();
    draw_bands();
    if (!flight_.ways.empty()) draw_margins();
    draw_reasons();
    return svg_.str();
  }

 private:
  std::size_t reasons() const {
    std::size_t count = 0;
    for (const ReturnSummary& one : flight_.returns) count += one.gaps.size();
    if (!flight_.ways.empty()) count += without(planned_, duration_).size();
    return count;
  }
  double bands_height() const {
    const auto rows = flight_.returns.size() + (flight_.ways.empty() ? 0 : 1);
    return kRow * static_cast<double>(rows) + kAxis;
  }
  double total_height() const {
    double out = kTop + bands_height();
    if (!flight_.height.empty()) out += kHeight + kGap;
    if (!flight_.ways.empty()) out += 2 * (kMargins + kGap) + 22;
    const auto lines = std::min(reasons(), kMostReasons + 1);
    return out + 10 + kLine * static_cast<double>(lines);
  }

  std::string title() const {
    std::string out = geom::excerpt(flight_.id) + ": ";
    if (!flight_.returns.empty()) {
      const ReturnSummary& first = flight_.returns.front();
      out += fmt::format("the autopilot's {} is proved for {} of {:.1f} s",
                         action_words(first.action), percent(first.share), first.duration);
      if (flight_.ways.empty()) return out;
      out += "; ";
    }
    return out + fmt::format("a planned way home for {}",
                             percent(share_without(without(planned_, duration_), duration_)));
  }

  std::string subtitle() const {
    const ReturnSummary& first = flight_.returns.front();
    std::string out = geom::excerpt(first.autopilot);
    if (first.longest > 0) out += fmt::format("; a return may take {:.0f} s", first.longest);
    const std::string least = height_words(first);
    if (!least.empty()) out += "; " + least;
    return out + "; what battery a return takes is not looked at";
  }

  Frame frame(double height, double low, double high) const {
    return {kLeft, top_, kWidth, height, {0, low}, {std::max(duration_, 1e-3), high}};
  }

  void curve(const Frame& in, const std::vector<Point>& points, std::string_view colour) {
    std::vector<Point> out;
    for (const Point& p : points) out.push_back(in.at(p));
    svg_.polyline(
        out, fmt::format("stroke=\"{}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"", colour));
  }

  // Heights of returns, with what to say of them.
  std::vector<std::pair<double, std::string>> levels() const {
    std::vector<std::pair<double, std::string>> out;
    for (const ReturnSummary& one : flight_.returns) {
      if (one.action != "rtl" || !one.home) continue;
      const auto add = [&](std::string_view what, const std::optional<double>& height) {
        if (!height) return;
        out.emplace_back(one.home->z() + *height, fmt::format("{} {:.4g} m", what, *height));
      };
      add("return height", one.height);
      const auto& least = one.least_height;
      if (least && least != one.height) add("least return height", geom::rounded_up(*least));
      if (one.gains_by_height()) add("best return height", one.best_height);
    }
    return out;
  }

  void draw_height() {
    double low = 0;
    double high = 1;
    for (const Point& p : flight_.height) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
    for (const auto& [height, words] : levels()) high = std::max(high, height);
    const Frame in = frame(kHeight, low, high + 0.12 * (high - low));
    svg_.grid(in);
    if (flight_.returns.size() == 1) shade(in);
    for (const auto& [height, words] : levels()) draw_level(in, height, words);
    curve(in, flight_.height, kInk);
    svg_.axes(in, "", "height, m");
    top_ += kHeight + kGap;
  }

  void shade(const Frame& in) {
    for (const auto& [from, until] : spans_of(flight_.returns.front())) {
      const double left = in.at({from, 0}).x;
      const double width = std::max(in.at({until, 0}).x - left, 1.5);
      svg_.rectangle({left, in.top}, width, in.height,
                     fmt::format("fill=\"{}\" fill-opacity=\"0.14\"", kWarning));
    }
  }

  void draw_level(const Frame& in, double height, const std::string& words) {
    const Point at = in.at({0, height});
    svg_.polyline(
        {at, {at.x + in.width, at.y}},
        fmt::format("stroke=\"{}\" stroke-width=\"1.2\" stroke-dasharray=\"7 4\"", kLimit));
    svg_.text_on_white({at.x + 8, at.y - 5}, words, {});
  }

  // A row for each report, and one for planned ways; below them the axis.
  void draw_bands() {
    const double rows = bands_height() - kAxis;
    const Frame in = frame(rows, 0, 1);
    svg_.grid(in);
    const double begin = top_;
    const auto row = [&](std::string_view words, HomeBand band) {
      svg_.text({kLeft - 12, top_ + kRow / 2 + 4}, words, {.anchor = "end"});
      band.top = top_ + 5;
      band.height = kRow - 10;
      draw_band(svg_, in, band);
      top_ += kRow;
    };
    int first = 1;
    for (const ReturnSummary& one : flight_.returns) {
      row(band_words(one),
          {.fill = kReturnFill, .gaps = spans_of(one), .duration = one.duration, .first = first});
      first += static_cast<int>(one.gaps.size());
    }
    if (!flight_.ways.empty()) {
      row("planned ways home", {.fill = kWayFill,
                                .gaps = without(planned_, duration_),
                                .duration = duration_,
                                .first = first});
    }
    top_ = begin + rows;
    svg_.x_axis(in, "time, s");
    top_ += kAxis;
  }

  // How long a way takes, and how long there is still one.
  void draw_margins() {
    std::vector<std::vector<Point>> takes;
    std::vector<std::vector<Point>> left;
    for (const ContingencyRecord& way : flight_.ways) {
      if (!way.duration) continue;
      const bool joins = !takes.empty() && takes.back().back().x == way.from;
      if (!joins) takes.emplace_back();
      takes.back().push_back({way.from, *way.duration});
      takes.back().push_back({way.until, *way.duration});
    }
    for (const auto& [from, until] : planned_) left.push_back({{from, until - from}, {until, 0}});
    const bool energy = std::any_of(flight_.ways.begin(), flight_.ways.end(),
                                    [](const auto& way) { return way.bounds_energy; });
    draw_seconds(takes, kWayFill, "how long the planned way home takes, at most", "");
    draw_seconds(left, kInk,
                 energy ? "time left until there is no way home, or not the energy for it"
                        : "time left until there is no way home (energy is not known)",
                 "time, s");
    top_ += 22;
  }

  // A panel of curves in seconds.
  void draw_seconds(const std::vector<std::vector<Point>>& curves, std::string_view colour,
                    std::string_view note, std::string_view x_label) {
    double most = 1;
    for (const auto& points : curves) {
      for (const Point& p : points) most = std::max(most, p.y);
    }
    const Frame in = frame(kMargins, 0, 1.1 * most);
    svg_.grid(in);
    svg_.text({kLeft, top_ - 8}, note);
    for (const auto& points : curves) curve(in, points, colour);
    svg_.axes(in, x_label, "s");
    top_ += kMargins + kGap;
  }

  void draw_reasons() {
    std::size_t shown = 0;
    int number = 0;
    const auto say = [&](const std::string& words) {
      ++number;
      if (shown == kMostReasons) return;
      ++shown;
      svg_.text({40, top_}, fmt::to_string(number), {.anchor = "end", .colour = kWarning});
      svg_.text({50, top_}, words);
      top_ += kLine;
    };
    for (const ReturnSummary& one : flight_.returns) {
      for (const ReturnGapSummary& gap : one.gaps) say(gap_words(gap));
    }
    if (!flight_.ways.empty()) {
      for (const auto& [from, until] : without(planned_, duration_)) say(unplanned(from, until));
    }
    const std::size_t more = reasons() - shown;
    if (more > 0) svg_.text({50, top_}, fmt::format("and {} more", more));
  }

  // Why there is no planned way at these times.
  std::string unplanned(double from, double until) const {
    std::string why = "no planned way home";
    for (const ContingencyRecord& way : flight_.ways) {
      if (way.until <= from || way.from >= until) continue;
      why = way.found() ? "not enough energy for the planned way home to " + geom::excerpt(way.site)
            : way.message.empty() ? why
                                  : geom::excerpt(way.message);
      break;
    }
    return fmt::format("{:.1f} to {:.1f} s: {}", from, until, why);
  }

  const HomeFlight& flight_;
  double duration_;
  TimeSpans planned_;
  Svg svg_;
  double top_ = kTop;
};

}  // namespace

std::string home(const HomeFlight& flight) { return Sheet(flight).drawn(); }

}  // namespace traj::figure
