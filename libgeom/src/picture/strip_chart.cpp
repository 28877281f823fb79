#include "strip_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "canvas.h"
#include "geom/figure/ticks.h"

namespace geom::picture {
namespace {

constexpr Colour kPaper{250, 250, 250};
constexpr Colour kInk{40, 40, 40};
constexpr Colour kGrid{222, 222, 222};
constexpr Colour kCurve{0, 114, 178};  // Okabe and Ito's blue
constexpr Colour kCursor{213, 94, 0};  // and vermilion
constexpr int kLetter = 2;

}  // namespace

StripChart::StripChart(const Chart& chart, int width, int height)
    : chart_(chart),
      base_{.width = width, .height = height, .colour = {}, .depth = {}, .id = {}},
      left_(64),
      right_(width - 20),
      top_(34),
      bottom_(height - 34) {
  fill(base_, kPaper);
  std::vector<double> values;
  for (double x = left_; x <= right_; ++x) {
    const double share = (x - left_) / (right_ - left_);
    values.push_back(chart_.value(chart_.begin + share * (chart_.end - chart_.begin)));
  }
  most_ = std::max(1e-9, *std::max_element(values.begin(), values.end())) * 1.08;
  const auto y_of = [&](double v) { return bottom_ - v / most_ * (bottom_ - top_); };
  for (const double v : figure::ticks(0, most_, 4)) {
    draw_rectangle(base_, {{left_, y_of(v)}, right_ - left_, 1}, kGrid);
    const std::string words = fmt::format("{:g}", v);
    draw_text(base_, {left_ - 6 - text_width(words, kLetter), y_of(v) - 7}, words, {kLetter, kInk});
  }
  for (const double t : figure::ticks(chart_.begin, chart_.end, width / 90)) {
    const std::string words = fmt::format("{:g}", t);
    draw_rectangle(base_, {{x_of(t), bottom_}, 1, 5}, kInk);
    draw_text(base_, {x_of(t) - 0.5 * text_width(words, kLetter), bottom_ + 9}, words,
              {kLetter, kInk});
  }
  draw_rectangle(base_, {{left_, bottom_}, right_ - left_, 1}, kInk);
  std::vector<Spot> curve;
  for (std::size_t i = 0; i < values.size(); ++i) {
    curve.push_back({left_ + static_cast<double>(i), y_of(values[i])});
  }
  draw_line(base_, curve, 2, kCurve);
  draw_text(base_, {left_, 10}, chart_.label, {kLetter, kInk});
}

double StripChart::x_of(double time) const {
  const double span = std::max(chart_.end - chart_.begin, 1e-9);
  return left_ + (time - chart_.begin) / span * (right_ - left_);
}

Picture StripChart::at(double time) const {
  Picture out = base_;
  const double x = x_of(std::clamp(time, chart_.begin, chart_.end));
  const double value = chart_.value(time);
  const double y = bottom_ - value / most_ * (bottom_ - top_);
  const std::array<Spot, 2> line{{{x, top_}, {x, bottom_}}};
  draw_line(out, line, 1.5, kCursor);
  draw_disc(out, {x, y}, 4, kCursor);
  const std::string words = fmt::format("{:.3g}", value);
  draw_text(out, {right_ - text_width(words, kLetter), 10}, words, {kLetter, kCursor});
  return out;
}

}  // namespace geom::picture
