#include "home/way_choice.h"

#include <algorithm>

namespace traj {
namespace {

constexpr double kStep = 15;         // m between heights that are tried upwards
constexpr int kMostSteps = 20;       // of these
constexpr int kHalvings = 4;         // towards the lowest height that is clear
constexpr double kGoodEnough = 1.1;  // times the straight distance: nothing shorter is planned

ChosenWay chosen(std::size_t site, geom::Polyline points) {
  const double rest = geom::length(points);
  return {site, std::move(points), rest};
}

}  // namespace

double length_from(const Braking& from, const ChosenWay& way) {
  double furthest = 0;
  for (const Vec3& p : from.corners) furthest = std::max(furthest, (p - way.points.front()).norm());
  return furthest + way.rest;
}

double WayChoice::straight(const Vec3& from, const LandingSite& site) const {
  return (site.above - from).norm() + (site.above.z() - site.ground.z());
}

double WayChoice::straight(const Vec3& from) const {
  double least = std::numeric_limits<double>::infinity();
  for (const LandingSite& site : task_.sites) least = std::min(least, straight(from, site));
  return least;
}

bool WayChoice::each_leg_free(const geom::Polyline& path) const {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!room_.leg(path[i - 1], path[i])) return false;
  }
  return scene_.free(path.front());
}

// Straight up or on the slant to the height z, level to above the site, and down; the climb is left
// out where the place above the site can be joined straight.
std::optional<geom::Polyline> WayChoice::at_height(const Braking& from, const LandingSite& site,
                                                   double z) const {
  const Vec3 middle = from.middle;
  const Vec3 over_site(site.above.x(), site.above.y(), z);
  if (z > site.above.z() && !room_.leg(over_site, site.above)) return std::nullopt;
  geom::Polyline down = {over_site, site.above, site.ground};
  if (z <= site.above.z()) down = {site.above, site.ground};
  if (joins(from, down.front())) return down;
  if (z <= middle.z()) return std::nullopt;
  const Vec3 up(middle.x(), middle.y(), z);
  if (!room_.leg(up, over_site) || !joins(from, up)) return std::nullopt;
  down.insert(down.begin(), up);
  return down;
}

// The lowest of at_height() that halving comes upon.
std::optional<ChosenWay> WayChoice::level_way(const Braking& from, std::size_t site) const {
  const LandingSite& to = task_.sites[site];
  double low = to.above.z();  // is not clear
  auto found = at_height(from, to, low);
  if (found) return chosen(site, *std::move(found));
  const double top = scene_.free_bounds()->max.z();
  double high = std::min(top, std::max(low, from.middle.z()));
  for (int i = 0; i < kMostSteps; ++i) {
    found = at_height(from, to, high);
    if (found || high == top) break;
    low = high;
    high = std::min(top, high + kStep);
  }
  if (!found) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    auto lower = at_height(from, to, middle);
    (lower ? high : low) = middle;
    if (lower) found = std::move(lower);
  }
  return chosen(site, *std::move(found));
}

// By the planner, from the middle of the region; it is joined as late as all places see it.
std::optional<ChosenWay> WayChoice::planned(const Braking& from, std::size_t site) const {
  const LandingSite& to = task_.sites[site];
  auto path = task_.plan ? task_.plan(from.middle, to) : std::nullopt;
  if (!path || path->empty() || path->back() != to.above || !each_leg_free(*path)) {
    return std::nullopt;
  }
  path->push_back(to.ground);
  for (std::size_t first = path->size() - 1; first-- > 0;) {
    if (!joins(from, (*path)[first])) continue;
    return chosen(site, {path->begin() + static_cast<std::ptrdiff_t>(first), path->end()});
  }
  return std::nullopt;
}

std::optional<ChosenWay> WayChoice::choose(const Braking& from) const {
  const Vec3 middle = from.middle;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < task_.sites.size(); ++i) {
    order.emplace_back(straight(middle, task_.sites[i]), i);
  }
  std::sort(order.begin(), order.end());
  std::optional<ChosenWay> best;
  const auto length = [&] { return length_from(from, *best); };
  const auto keep = [&](std::optional<ChosenWay> way) {
    if (way && (!best || length_from(from, *way) < length())) best = std::move(way);
  };
  for (const auto& [distance, site] : order) {
    if (best && length() <= distance) break;
    keep(level_way(from, site));
    if (!best || length() > kGoodEnough * distance) keep(planned(from, site));
  }
  return best;
}

}  // namespace traj
