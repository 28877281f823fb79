#include "geom/import/synth_city.h"

#include <algorithm>
#include <cmath>

#include "geom/base/random.h"

namespace geom {
namespace {

constexpr double kBlockX = 75;  // metres: a block with its streets
constexpr double kBlockY = 90;

struct Area {
  double x0, y0, x1, y1;
};

class City {
 public:
  explicit City(const SynthSpec& spec) : spec_(spec), dice_(spec.seed) {}

  std::vector<CenteredBox> build() {
    const int nx = std::max(1, static_cast<int>(spec_.size_x / kBlockX));
    const int ny = std::max(1, static_cast<int>(spec_.size_y / kBlockY));
    const double dx = spec_.size_x / nx;
    const double dy = spec_.size_y / ny;
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const double x = -spec_.size_x / 2 + i * dx;
        const double y = -spec_.size_y / 2 + j * dy;
        const double street = dice_.chance(0.25) ? 10 : 18;  // some are narrow
        block({x + street / 2, y + street / 2, x + dx - street / 2, y + dy - street / 2});
      }
    }
    overpass(-spec_.size_y / 2 + dy * (ny / 2));
    return std::move(boxes_);
  }

 private:
  void add(double x0, double y0, double z0, double x1, double y1, double z1) {
    const auto millimetres = [](double v) { return std::floor(v * 1000 + 0.5) / 1000; };
    const Vec3 low(millimetres(x0), millimetres(y0), millimetres(z0));
    const Vec3 high(millimetres(x1), millimetres(y1), millimetres(z1));
    const auto tidy = [](double v) { return std::floor(v * 10000 + 0.5) / 10000; };
    CenteredBox box{0.5 * (low + high), 0.5 * (high - low)};
    for (int i = 0; i < 3; ++i) box.center[i] = tidy(box.center[i]);
    for (int i = 0; i < 3; ++i) box.half[i] = tidy(box.half[i]);
    boxes_.push_back(box);
  }

  // How built up a place is: 1 in the middle, 0 at the rim.
  double density(double x, double y) const {
    const double u = 2 * x / spec_.size_x;
    const double v = 2 * y / spec_.size_y;
    return std::clamp(1 - 0.5 * (u * u + v * v), 0.0, 1.0);
  }

  void block(const Area& a) {
    if (dice_.chance(0.07)) {
      park(a);
    } else {
      buildings(a);
    }
    street_side(a);
  }

  void park(const Area& a) {
    for (int i = 0; i < 28; ++i)
      tree(dice_.uniform(a.x0 + 3, a.x1 - 3), dice_.uniform(a.y0 + 3, a.y1 - 3));
  }

  void buildings(const Area& a) {
    const int columns = dice_.whole(2, 3);
    const int rows = dice_.whole(2, 4);
    const double dx = (a.x1 - a.x0 - 6) / columns;
    const double dy = (a.y1 - a.y0 - 6) / rows;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const double x = a.x0 + 3 + i * dx;
        const double y = a.y0 + 3 + j * dy;
        const double gap = dice_.chance(0.4) ? dice_.uniform(3, 7) : 0;  // alley, or wall to wall
        building({x, y, x + dx - gap, y + dy - (gap > 0 ? gap * 0.5 : 0)});
      }
    }
  }

  void building(const Area& a) {
    const double city = density(0.5 * (a.x0 + a.x1), 0.5 * (a.y0 + a.y1));
    const double top = spec_.height * city * city;
    if (dice_.chance(0.18 * city)) {
      tower(a, dice_.uniform(0.45, 1) * top + 12);
    } else {
      mass(a, dice_.uniform(0.08, 0.35) * top + 6);
    }
  }

  // Stacked boxes, each smaller than the one below.
  void tower(Area a, double height) {
    const int tiers = dice_.whole(2, 4);
    double z = 0;
    for (int t = 0; t < tiers; ++t) {
      const double top = t + 1 == tiers ? height : z + (height - z) * dice_.uniform(0.4, 0.7);
      add(a.x0, a.y0, z, a.x1, a.y1, top);
      z = top;
      const double inset = dice_.uniform(1, 3);
      a = {a.x0 + inset, a.y0 + inset, a.x1 - inset, a.y1 - inset};
      if (a.x1 - a.x0 < 5 || a.y1 - a.y0 < 5) break;
    }
    const double cx = 0.5 * (a.x0 + a.x1);
    const double cy = 0.5 * (a.y0 + a.y1);
    if (dice_.chance(0.4)) add(cx - 0.2, cy - 0.2, z, cx + 0.2, cy + 0.2, z + dice_.uniform(5, 15));
  }

  // A few adjoining boxes of different heights, and something on the roof.
  void mass(const Area& a, double height) {
    const int parts = dice_.whole(1, 3);
    const double dx = (a.x1 - a.x0) / parts;
    for (int i = 0; i < parts; ++i) {
      const double top = height * dice_.uniform(0.75, 1.2);
      const double x = a.x0 + i * dx;
      add(x, a.y0, 0, x + dx, a.y1, top);
      if (dice_.chance(0.35)) {
        const double y = dice_.uniform(a.y0, a.y1 - 4);
        add(x + dx * 0.3, y, top, x + dx * 0.3 + 3, y + 3, top + 2.5);
      }
    }
  }

  void tree(double x, double y) {
    const double height = dice_.uniform(5, 12);
    const double crown = dice_.uniform(1.2, 2.5);
    add(x - 0.2, y - 0.2, 0, x + 0.2, y + 0.2, height * 0.4);
    add(x - crown, y - crown, height * 0.4, x + crown, y + crown, height);
  }

  void street_side(const Area& a) {
    for (double x = a.x0 + 6; x < a.x1 - 4; x += dice_.uniform(9, 16)) {
      furniture(x, a.y0 - 1.2);
    }
    for (double y = a.y0 + 6; y < a.y1 - 4; y += dice_.uniform(9, 16)) {
      furniture(a.x0 - 1.2, y);
    }
  }

  void furniture(double x, double y) {
    const double kind = dice_.uniform(0, 1);
    if (kind < 0.6) {
      tree(x, y);
    } else if (kind < 0.85) {
      add(x - 0.1, y - 0.1, 0, x + 0.1, y + 0.1, 8);  // lamp post
    } else {
      add(x - 1.2, y - 3.5, 0, x + 1.2, y + 3.5, 3.2);  // parked truck
    }
  }

  // A deck on pillars along one street, from rim to middle.
  void overpass(double y) {
    const double end = spec_.size_x * 0.1;
    for (double x = -spec_.size_x / 2; x < end; x += 30) {
      add(x, y - 4, 8, std::min(x + 30, end), y + 4, 9.2);
      add(x + 14, y - 0.8, 0, x + 16, y + 0.8, 8);
    }
  }

  SynthSpec spec_;
  SplitMix64 dice_;
  std::vector<CenteredBox> boxes_;
};

}  // namespace

std::vector<CenteredBox> synth_city(const SynthSpec& spec) { return City(spec).build(); }

}  // namespace geom
