#include "home_band.h"

#include <fmt/format.h>

#include <algorithm>

#include "shapes.h"

namespace traj::figure {
namespace {

constexpr double kShort = 1e-9;  // s: what is as short is no span

void draw_hollow(Svg& svg, Point corner, double width, double height) {
  svg.rectangle(corner, std::max(width, 2.0), height,
                fmt::format("fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.5\"", kWarning));
}

}  // namespace

TimeSpans without(const TimeSpans& spans, double duration) {
  TimeSpans out;
  double before = 0;
  for (const auto& [from, until] : spans) {
    if (from > before + kShort) out.emplace_back(before, from);
    before = std::max(before, until);
  }
  if (spans.empty() || duration > before + kShort) out.emplace_back(before, duration);
  return out;
}

double share_without(const TimeSpans& spans, double duration) {
  if (!(duration > 0)) return spans.empty() ? 1 : 0;
  double held = 0;
  for (const auto& [from, until] : spans) held += until - from;
  return std::clamp(1 - held / duration, 0.0, 1.0);
}

TimeSpans spans_of(const ReturnSummary& returns) {
  TimeSpans out;
  for (const ReturnGapSummary& gap : returns.gaps) out.emplace_back(gap.from, gap.until);
  return out;
}

std::string percent(double share) {
  return fmt::format("{:.1f} %", share < 1 ? std::min(100 * share, 99.9) : 100);
}

void draw_band(Svg& svg, const Frame& frame, const HomeBand& band) {
  const auto x = [&](double time) { return frame.at({time, 0}).x; };
  for (const auto& [from, until] : without(band.gaps, band.duration)) {
    svg.rectangle({x(from), band.top}, std::max(x(until) - x(from), 1.0), band.height,
                  fmt::format("fill=\"{}\"", band.fill));
  }
  for (std::size_t i = 0; i < band.gaps.size(); ++i) {
    const auto& [from, until] = band.gaps[i];
    draw_hollow(svg, {x(from), band.top + 0.75}, x(until) - x(from), band.height - 1.5);
    const std::string number = fmt::to_string(band.first + static_cast<int>(i));
    if (band.first == 0 || x(until) - x(from) < text_width(number, 11) + 4) continue;
    svg.text({(x(from) + x(until)) / 2, band.top + band.height / 2 + 4}, number,
             {.size = 11, .anchor = "middle", .colour = kWarning});
  }
}

void draw_band_key(Svg& svg, Point at, bool returns, bool ways) {
  const auto entry = [&](std::string_view words, auto&& draw) {
    draw();
    svg.text({at.x + 28, at.y + 4}, words);
    at.x += 28 + text_width(words, 12) + 14;
  };
  const auto filled = [&](std::string_view fill) {
    return [&svg, &at, fill] {
      svg.rectangle({at.x, at.y - 6}, 22, 12, fmt::format("fill=\"{}\"", fill));
    };
  };
  if (returns) entry("return proved", filled(kReturnFill));
  if (ways) entry("planned way home", filled(kWayFill));
  entry(!returns ? "no way home"
        : ways   ? "none"
                 : "no return proved",
        [&] {
          draw_hollow(svg, {at.x, at.y - 5.25}, 22, 10.5);
        });
}

}  // namespace traj::figure
