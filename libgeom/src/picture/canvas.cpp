#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "font.h"

namespace geom::picture {
namespace {

constexpr double kUnit = 8 / kCapital;  // pixels of a unit of the font, times the scale
constexpr double kPen = 1.25;           // pixels, times the scale

std::size_t index(const Picture& picture, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
         static_cast<std::size_t>(x);
}

Colour& pixel(Picture& picture, int x, int y) { return picture.colour[index(picture, x, y)]; }

void blend(Colour& under, Colour over, double share) {
  const auto part = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(a + (b - a) * share + 0.5);
  };
  under = {part(under.r, over.r), part(under.g, over.g), part(under.b, over.b)};
}

double distance(const Spot& p, const Spot& a, const Spot& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double t =
      squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// How much of a pixel a line covers, 0 to 1.
struct Stroke {
  Spot a;
  Spot b;
  double width;

  // How much of a pixel it covers, 0 to 1.
  float cover(int x, int y) const {
    const Spot p{static_cast<double>(x), static_cast<double>(y)};
    return static_cast<float>(std::clamp(0.5 * width + 0.5 - distance(p, a, b), 0.0, 1.0));
  }
};

// The corners of a rectangle of pixels.
using Corners = std::pair<Spot, Spot>;

Corners around(const Spot& a, const Spot& b, double width) {
  const double reach = 0.5 * width + 0.5;
  return {{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach},
          {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach}};
}

Corners square_around(const Spot& centre, double reach) {
  return {{centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}};
}

// Clamped to the picture first, so that far-off drawings cost nothing and never overflow an int.
int clamped(double value, int most) {
  return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
}

// Blends with what cover(x, y) says, 0 to 1, over the pixels of a rectangle.
template <class Cover>
void paint_over(Picture& picture, const Corners& corners, Colour colour, const Cover& cover) {
  const auto& [low, high] = corners;
  if (!(high.x >= 0 && high.y >= 0 && low.x < picture.width && low.y < picture.height)) return;
  const int right = clamped(std::ceil(high.x), picture.width - 1);
  const int bottom = clamped(std::ceil(high.y), picture.height - 1);
  for (int y = clamped(std::floor(low.y), bottom); y <= bottom; ++y) {
    for (int x = clamped(std::floor(low.x), right); x <= right; ++x) {
      const double share = std::clamp<double>(cover(x, y), 0, 1);
      if (share > 0) blend(pixel(picture, x, y), colour, share);
    }
  }
}

}  // namespace

void fill(Picture& picture, Colour colour) { picture.colour.assign(picture.pixels(), colour); }

void draw_rectangle(Picture& picture, const Plate& plate, const Paint& paint) {
  const Spot corner = plate.corner;
  const Spot high{corner.x + plate.width - 1, corner.y + plate.height - 1};
  paint_over(picture, {corner, high}, paint.colour, [&](int x, int y) {
    return x >= corner.x && x <= high.x && y >= corner.y && y <= high.y ? paint.share : 0.0;
  });
}

void draw_line(Picture& picture, std::span<const Spot> points, double width, const Paint& paint) {
  if (points.size() == 2) {
    const Corners corners = around(points[0], points[1], width);
    paint_over(picture, corners, paint.colour, [&](int x, int y) {
      return paint.share * Stroke{points[0], points[1], width}.cover(x, y);
    });
    return;
  }
  // The nearest of all pieces counts once, so that joints are not drawn twice.
  std::vector<float> mask(picture.pixels());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Corners corners = around(points[i], points[i + 1], width);
    paint_over(picture, corners, paint.colour, [&](int x, int y) {
      float& covered = mask[index(picture, x, y)];
      covered = std::max(covered, Stroke{points[i], points[i + 1], width}.cover(x, y));
      return 0;
    });
  }
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] > 0) blend(picture.colour[i], paint.colour, paint.share * mask[i]);
  }
}

void draw_disc(Picture& picture, Spot centre, double radius, const Paint& paint) {
  const double reach = radius + 0.5;
  paint_over(picture, square_around(centre, reach), paint.colour, [&](int x, int y) {
    return paint.share * std::clamp(reach - std::hypot(x - centre.x, y - centre.y), 0.0, 1.0);
  });
}

void draw_ring(Picture& picture, const Ring& ring, const Paint& paint) {
  const auto& [centre, radius, width] = ring;
  const double reach = radius + 0.5 * width + 0.5;
  paint_over(picture, square_around(centre, reach), paint.colour, [&](int x, int y) {
    const double off = std::abs(std::hypot(x - centre.x, y - centre.y) - radius);
    return paint.share * std::clamp(0.5 * width + 0.5 - off, 0.0, 1.0);
  });
}

double text_width(std::string_view words, int scale) {
  double units = 0;
  const auto letters = letters_of(words);
  for (const Letter* letter : letters) units += letter->width + kBetween;
  return letters.empty() ? 0 : (units - kBetween) * kUnit * scale;
}

void draw_text(Picture& picture, Spot corner, std::string_view words, const Lettering& letters) {
  const double unit = kUnit * letters.scale;
  const double width = kPen * letters.scale;
  double left = corner.x;
  for (const Letter* letter : letters_of(words)) {
    std::vector<Stroke> lines;
    Spot low{left, corner.y + kCapital * unit};
    Spot high = low;
    const auto spot = [&](const PenPoint& p) {
      const Spot at{left + p.x * unit, corner.y + (kCapital - p.y) * unit};
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      return at;
    };
    for (const auto& stroke : letter->strokes) {
      for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
        lines.push_back({spot(stroke[i]), spot(stroke[i + 1]), width});
      }
    }
    paint_over(picture, around(low, high, width), letters.colour, [&](int x, int y) {
      float most = 0;
      for (const Stroke& line : lines) most = std::max(most, line.cover(x, y));
      return most;
    });
    left += (letter->width + kBetween) * unit;
  }
}

void put(const Picture& part, int x, int y, Picture& whole) {
  for (int row = 0; row < part.height; ++row) {
    const auto* from = part.colour.data() +
                       static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(part.width);
    std::copy_n(from, part.width, &pixel(whole, x, y + row));
  }
}

}  // namespace geom::picture
