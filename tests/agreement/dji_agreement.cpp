// dji_agreement N [SEED]: N missions of DJI's, each with one obstacle put into the way of one of
// its parts, 1e-6 to 1 m deep. Where the way is, is worked out here from DJI's documents and
// another projection (GeographicLib's exact one). A third follows the surface, within a band over
// ground of a random height model. None may pass.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/map/ground_model.h"
#include "in_the_way.h"
#include "traj/mission/dji/dji_flight.h"
#include "traj/mission/dji/dji_wpml.h"

namespace {

using geom::Vec3;
using in_the_way::Attack;
using in_the_way::kHalf;
using in_the_way::projected;
using support::Random;

constexpr double kGround = 10;   // m, z of the take-off
constexpr double kOrigin = 390;  // m, height of the map's zero on the ellipsoid
const traj::MissionFrame kFrame{{47, 8, kOrigin}, 0};

std::string element(const std::string& name, const std::string& inside) {
  return "<wpml:" + name + ">" + inside + "</wpml:" + name + ">\n";
}
std::string element(const std::string& name, double value) {
  return element(name, fmt::format("{:.3f}", value));
}

Vec3 at_height(const Vec3& p, double z) { return {p.x(), p.y(), z}; }
double plan_distance(const Vec3& a, const Vec3& b) { return (a - b).head<2>().norm(); }

// Ground that is known within metres, under a vehicle that follows it.
class Surface {
 public:
  Surface(Random& random, const Vec3& home) : random_(random), ground_(ground_of(random, home)) {
    band_.low = random.uniform(15, 40);
    band_.high = band_.low + random.uniform(0, 30);
  }

  traj::TerrainRules rules() const { return {&ground_, geom::Axes::enu, {}, band_}; }

  // Where the vehicle may be above or below the point.
  Vec3 followed(const Vec3& p) {
    const auto cell = [](double at) { return static_cast<std::size_t>((at + kReach) / kCell); };
    const std::size_t at = cell(p.y()) * kCells + cell(p.x());
    const double ground = within(ground_.lows()[at], ground_.highs()[at]);
    return at_height(p, ground + within(band_.low, band_.high));
  }

 private:
  static constexpr double kReach = 260;
  static constexpr double kCell = 13;
  static constexpr std::size_t kCells = 40;

  // Anywhere, or at an end.
  double within(double low, double high) {
    const int where = random_.below(3);
    return where == 0 ? low : where == 1 ? high : random_.uniform(low, high);
  }

  // It rises away from home, which is on it.
  static geom::GroundModel ground_of(Random& random, const Vec3& home) {
    std::vector<double> low;
    std::vector<double> high;
    const double east = random.uniform(0, 1);
    const double north = random.uniform(0, 1);
    for (std::size_t j = 0; j < kCells; ++j) {
      for (std::size_t i = 0; i < kCells; ++i) {
        const auto from = [](std::size_t cell, double at) {
          return std::abs(static_cast<double>(cell) - std::floor((at + kReach) / kCell));
        };
        const double slope = east * from(i, home.x()) + north * from(j, home.y());
        low.push_back(kGround + slope + random.uniform(0, 3));
        high.push_back(low.back() + random.uniform(0, 3));
      }
    }
    return {{.corner = {-kReach, -kReach}, .cell = kCell, .columns = kCells, .rows = kCells},
            std::move(low),
            std::move(high)};
  }

  Random& random_;
  geom::GroundModel ground_;
  traj::SurfaceBand band_;
};

// A mission as text, and a point of its way as this program works that out.
class Case {
 public:
  explicit Case(Random& random) : random_(random), safely_(random.below(2)) {}

  Attack make() {
    security_ = random_.below(2) ? random_.uniform(2, 60) : 2;
    home_ = somewhere();
    home_.z() = kGround;
    takeoff_ = place(home_);
    if (random_.below(3) == 0) surface_.emplace(random_, home_);
    const int waylines = 1 + random_.below(2);
    for (int i = 0; i < waylines; ++i) fly(i);
    if (random_.below(2)) return_home();
    return attacks_[static_cast<std::size_t>(random_.below(static_cast<int>(attacks_.size())))];
  }

  traj::DjiRules rules() const {
    return {.surface = surface_ ? std::optional(surface_->rules()) : std::nullopt};
  }

  std::string text() const {
    const std::string takeoff =
        fmt::format("{:.9f},{:.9f},{:.3f}", takeoff_[0], takeoff_[1], kOrigin + kGround);
    std::string config =
        element("flyToWaylineMode", safely_ ? "safely" : "pointToPoint") +
        element("finishAction", return_ ? "goHome" : "noAction") +
        element("exitOnRCLost", "goContinue") + element("takeOffSecurityHeight", security_) +
        element("takeOffRefPoint", takeoff) + element("globalTransitionalSpeed", "9") +
        element("droneInfo", element("droneEnumValue", "67"));
    if (return_) config += element("globalRTHHeight", *return_);
    return "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
           "xmlns:wpml=\"http://www.dji.com/wpmz/1.0.2\"><Document>" +
           element("missionConfig", config) + folders_ + "</Document></kml>";
  }

 private:
  Vec3 somewhere() {
    return {random_.uniform(-150, 150), random_.uniform(-150, 150),
            random_.uniform(kGround + 5, 90)};
  }

  Vec3 between(const Vec3& a, const Vec3& b) { return a + random_.uniform(0, 1) * (b - a); }

  void may(const char* what, const Vec3& point) { attacks_.push_back({what, point}); }
  void may_leg(const char* what, const Vec3& a, const Vec3& b) { may(what, between(a, b)); }

  // Latitude and longitude as they are written; moves the point to there.
  std::array<double, 2> place(Vec3& p) {
    const double latitude = std::round((47 + p.y() / 111171) * 1e9) / 1e9;
    const double longitude = std::round((8 + p.x() / 76057) * 1e9) / 1e9;
    p = projected(latitude, longitude, std::round(p.z() * 1e3) / 1e3);
    return {latitude, longitude};
  }

  void fly(int number) {
    const bool ellipsoid = random_.below(2);
    const int count = surface_ ? 1 + random_.below(5) : 2 + random_.below(4);
    std::vector<Vec3> points;
    std::string waypoints;
    for (int i = 0; i < count; ++i) {
      Vec3 p = somewhere();
      if (i > 0 && plan_distance(p, points.back()) < 10) p.x() += 20;
      const auto degrees = place(p);
      const int turn = i == 0 || i + 1 == count ? 0 : random_.below(3);
      turns_.push_back(turn);
      dampings_.push_back(turn == 0 ? 0 : std::round(random_.uniform(0.5, 4.5) * 1e3) / 1e3);
      points.push_back(p);
      waypoints += fmt::format("<Placemark><Point><coordinates>{:.9f},{:.9f}</coordinates></Point>",
                               degrees[1], degrees[0]) +
                   element("index", std::to_string(i)) +
                   element("executeHeight", ellipsoid ? p.z() + kOrigin : p.z() - kGround) +
                   turn_text(turn, dampings_.back()) + "</Placemark>\n";
    }
    folders_ += "<Folder>" + element("templateId", std::to_string(number)) +
                element("executeHeightMode", surface_    ? "realTimeFollowSurface"
                                             : ellipsoid ? "WGS84"
                                                         : "relativeToStartPoint") +
                element("waylineId", std::to_string(number)) + element("autoFlightSpeed", "5") +
                waypoints + "</Folder>\n";
    if (surface_) {
      if (number > 0) may("along the surface to the next wayline", along(last_, points.front()));
      for (Vec3& p : points) p = surface_->followed(p);
    }
    number == 0 ? approach(points.front()) : go_on(points.front());
    if (surface_) may("waypoint over the surface", surface_->followed(points.back()));
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 p = between(points[i - 1], points[i]);
      surface_ ? may("leg along the surface", surface_->followed(p)) : may("leg", p);
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) corner(points, i);
    last_ = points.back();
    turns_.clear();
    dampings_.clear();
  }

  Vec3 along(const Vec3& a, const Vec3& b) { return surface_->followed(between(a, b)); }

  static std::string turn_text(int turn, double damping) {
    static const char* const kModes[] = {"toPointAndStopWithDiscontinuityCurvature",
                                         "coordinateTurn", "toPointAndPassWithContinuityCurvature"};
    return element("waypointTurnParam", element("waypointTurnMode", kModes[turn]) +
                                            element("waypointTurnDampingDist", damping)) +
           element("useStraightLine", "1");
  }

  void approach(const Vec3& first) {
    const double secure = kGround + std::round(security_ * 1e3) / 1e3;
    const double z = safely_ ? std::max(secure, first.z()) : secure;
    may_leg("rise", at_height(home_, kGround + kHalf.z() + 0.01), at_height(home_, z));
    if (safely_ || first.z() < secure) {
      may_leg("to the first waypoint", at_height(home_, z), at_height(first, z));
      may_leg("down to the first waypoint", at_height(first, z), first);
    } else {
      may_leg("straight to the first waypoint", at_height(home_, z), first);
    }
  }

  void go_on(const Vec3& first) {
    if (!safely_) return may_leg("straight to the next wayline", last_, first);
    const double z = std::max(last_.z(), first.z());
    may_leg("up to the next wayline", last_, at_height(last_, z));
    may_leg("to the next wayline", at_height(last_, z), at_height(first, z));
    may_leg("down to the next wayline", at_height(first, z), first);
  }

  void corner(const std::vector<Vec3>& points, std::size_t i) {
    const Vec3& p = points[i];
    const double radius = dampings_[i];
    const auto begins = [&](Vec3 other) -> Vec3 {
      if (surface_) other.z() = p.z();
      return p + radius * (other - p).normalized();
    };
    const Vec3 a = begins(points[i - 1]);
    const Vec3 b = begins(points[i + 1]);
    const auto turning = [&](const Vec3& at) { return surface_ ? surface_->followed(at) : at; };
    if (turns_[i] == 1) may("coordinated turn", turning(between(between(a, b), p)));
    if (turns_[i] != 2) return;
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    const double away = random_.uniform(0, radius);
    const double low = std::min({a.z(), b.z(), p.z()});
    const double high = std::max({a.z(), b.z(), p.z()});
    const double z = random_.uniform(2 * low - high, 2 * high - low);
    may("turn through the waypoint",
        turning({p.x() + away * std::cos(angle), p.y() + away * std::sin(angle), z}));
  }

  void return_home() {
    const double away = plan_distance(last_, home_);
    if (away < 20.1) return;
    return_ = std::round(random_.uniform(2, 100) * 1e3) / 1e3;
    const double z = std::max(last_.z(), kGround + *return_);
    may_leg("return", at_height(last_, z), at_height(home_, z));
    may_leg("up to return", last_, at_height(last_, z));
    may_leg("landing", at_height(home_, z), at_height(home_, kGround + kHalf.z() + 0.01));
    if (away > 49.9) return;
    const double level = random_.uniform(last_.z(), z);
    may_leg("return without a rise", at_height(last_, level), at_height(home_, level));
  }

  Random& random_;
  bool safely_;
  std::optional<Surface> surface_;
  double security_ = 2;
  Vec3 home_ = Vec3::Zero();
  std::array<double, 2> takeoff_{};
  std::optional<double> return_;
  std::string folders_;
  Vec3 last_ = Vec3::Zero();
  std::vector<int> turns_;
  std::vector<double> dampings_;
  std::vector<Attack> attacks_;
};

traj::FlownMission flown(const std::string& text, const traj::DjiRules& rules) {
  return traj::FlownMission(
      traj::flown_dji(traj::read_dji_wpml(text, "", "mission"), kFrame, rules, "mission"));
}

}  // namespace

int main(int argc, char** argv) {
  return in_the_way::run(argc, argv, kGround, [](Random& random, int) {
    Case made(random);
    const Attack attack = made.make();
    return in_the_way::Trial{made.text(), attack, flown(made.text(), made.rules())};
  });
}
