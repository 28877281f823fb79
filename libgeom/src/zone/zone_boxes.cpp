#include "geom/zone/zone_boxes.h"

#include <fmt/format.h>

#include <algorithm>

#include "clip_ring.h"
#include "geom/base/error.h"
#include "geom/base/rounding.h"
#include "geom/map/geographic_frame.h"
#include "zone_outline.h"

namespace geom {
namespace {

using zone::PlacedOutline;

constexpr std::size_t kMostBoxes = 2'000'000;
constexpr double kRounding = 1e-6;  // m

Rectangle grown(const Rectangle& r, double by) { return {r.min.array() - by, r.max.array() + by}; }

// The heights between which a volume is over a region.
struct Heights {
  double bottom = 0;
  double top = 0;
};

bool from_ground(const std::optional<HeightLimit>& limit) {
  return limit && limit->from == HeightReference::ground;
}

class Closing {
 public:
  Closing(const ZoneFile& file, const std::string& source, const ZoneRoom& room)
      : file_(file), source_(source), room_(room), area_(zone::area_of(room.spec)) {}

  ZoneBoxes run() {
    for (std::size_t i = 0; i < file_.zones.size(); ++i) add(i);
    return std::move(out_);
  }

 private:
  void add(std::size_t index) {
    const Zone& zone = file_.zones[index];
    const std::string item = fmt::format("zone {}", in_quotes(zone.identifier));
    NearZone near{.index = index, .boxes = 0, .times = {}};
    bool meets = false;
    const std::size_t before = out_.table.boxes.size();
    for (const ZoneVolume& volume : zone.volumes) {
      const SunArea area = zone::area_of(volume.outline, room_.spec.frame.origin->longitude);
      if (zone::apart(area, area_)) continue;
      PlacedOutline outline = zone::placed(volume, room_.spec.frame, item, source_);
      const Rectangle room = around(outline.bulge);
      outline.polygon = zone::clipped(outline.polygon, room);
      if (outline.polygon.outer.empty()) continue;
      meets = true;
      const std::vector<TimeSpan> times = zone_times(zone.periods, room_.clock, area);
      near.times.insert(near.times.end(), times.begin(), times.end());
      if (!room_.types.contains(zone.type)) continue;
      label_ = out_.table.label_of(label_of(zone));
      Volume one{volume, outline.bulge, times, near, index};
      close(one, room, outline.polygon);
    }
    if (!meets) return;
    near.boxes = out_.table.boxes.size() - before;
    settle(near.times);
    out_.near.push_back(std::move(near));
  }

  struct Volume {
    const ZoneVolume& limits;
    double bulge;
    const std::vector<TimeSpan>& times;
    NearZone& near;
    std::size_t index;
  };

  // Each time once, in order.
  static void settle(std::vector<TimeSpan>& times) {
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
  }

  // The bounds in plan, with all that cut corners may move by.
  Rectangle around(double bulge) const {
    const Aabb& bounds = room_.spec.bounds;
    return grown({bounds.min.head<2>(), bounds.max.head<2>()}, bulge + room_.slack + 1);
  }

  // Cuts the region until the ground in each part is as level as the step.
  void close(const Volume& volume, const Rectangle& region, const Polygon& polygon) {
    const Polygon part = zone::clipped(polygon, region);
    if (part.outer.empty()) return;
    const bool sloping = from_ground(volume.limits.lower) || from_ground(volume.limits.upper);
    if (!room_.ground || !sloping) {
      add_boxes(volume, part, heights(volume, {}));
      return;
    }
    const auto seen = within_bounds(grown(region, volume.bulge));
    if (!seen) return;
    const GroundRange ground = room_.ground->range(*seen);
    const bool whole = ground.level(room_.step, room_.ground->spec().error) || !ground.any_known;
    const auto parts = whole ? std::nullopt : room_.ground->cut(region);
    if (!parts) {
      add_boxes(volume, part, heights(volume, ground));
      return;
    }
    close(volume, parts->first, part);
    close(volume, parts->second, part);
  }

  // The part of the region within the bounds. The ground elsewhere does not count.
  std::optional<Rectangle> within_bounds(const Rectangle& region) const {
    const Aabb& bounds = room_.spec.bounds;
    const Rectangle out{region.min.cwiseMax(bounds.min.head<2>()),
                        region.max.cwiseMin(bounds.max.head<2>())};
    if ((out.min.array() > out.max.array()).any()) return std::nullopt;
    return out;
  }

  Heights heights(const Volume& volume, const GroundRange& ground) const {
    const Aabb& bounds = room_.spec.bounds;
    const auto low = volume.limits.lower ? z_of(*volume.limits.lower, false, ground, volume)
                                         : std::optional<double>();
    const auto high = volume.limits.upper ? z_of(*volume.limits.upper, true, ground, volume)
                                          : std::optional<double>();
    return {low.value_or(bounds.min.z()), high.value_or(bounds.max.z())};
  }

  // The map's z of a limit, rounded outward; nothing where it is not known. What begins at the
  // ground is closed below it, too.
  std::optional<double> z_of(const HeightLimit& limit, bool upper, const GroundRange& ground,
                             const Volume& volume) const {
    std::optional<ZeroOffset> offset;
    if (limit.from == HeightReference::sea) offset = room_.sea;
    if (limit.from == HeightReference::ellipsoid) offset = room_.ellipsoid;
    if (limit.from == HeightReference::ground) {
      if (!upper && limit.metres <= 0) return std::nullopt;
      if (ground.all_known) offset = ZeroOffset{ground.low, ground.high};
      if (room_.ground && !ground.all_known) volume.near.open_for_hole = true;
    }
    if (!offset) {
      if (limit.from != HeightReference::ground || !room_.ground) volume.near.open_for_zero = true;
      return std::nullopt;
    }
    return upper ? add_up(add_up(limit.metres, offset->most), kRounding)
                 : add_down(add_down(limit.metres, offset->least), -kRounding);
  }

  void add_boxes(const Volume& volume, const Polygon& polygon, const Heights& heights) {
    const Aabb& bounds = room_.spec.bounds;
    if (heights.bottom > heights.top || heights.bottom > bounds.max.z() ||
        heights.top < bounds.min.z()) {
      return;
    }
    for (const Rectangle& r : cover(polygon, room_.slack)) {
      const Rectangle wide = grown(r, volume.bulge);
      const Aabb box{{next_down(wide.min.x()), next_down(wide.min.y()), heights.bottom},
                     {next_up(wide.max.x()), next_up(wide.max.y()), heights.top}};
      if (!overlap(box, bounds)) continue;
      for (const TimeSpan& time : volume.times) {
        require_few();
        out_.table.add(box, volume.index, label_);
        if (!time.always()) out_.table.set_time(out_.table.boxes.size() - 1, time);
      }
    }
  }

  void require_few() const {
    if (out_.table.boxes.size() < kMostBoxes) return;
    throw InputError(
        source_,
        {.expected = fmt::format("zones that {} boxes within the map can cover", kMostBoxes),
         .found = "more",
         .advice = "give a larger --slack or --step, fewer --days, or crop the map"});
  }

  const ZoneFile& file_;
  const std::string& source_;
  const ZoneRoom& room_;
  SunArea area_;
  std::uint32_t label_ = 0;
  ZoneBoxes out_;
};

}  // namespace

SunArea area_of(const BoxMapSpec& spec) { return zone::area_of(spec); }

std::string label_of(const Zone& zone) {
  return fmt::format("zone {} {}{}{}", zone.identifier, name(zone.type),
                     zone.name.empty() ? "" : ": ", zone.name);
}

ZoneBoxes zone_boxes(const ZoneFile& file, const std::string& source, const ZoneRoom& room) {
  if (!counts_from_origin(room.spec.frame)) {
    throw InputError(source, {.says = "the map has no origin on Earth, so zones of airspace have "
                                      "no place on it",
                              .advice = "give the origin when you make the map (--origin)"});
  }
  if (room.ground) require_same_frame(*room.ground, room.spec.frame, "the ground");
  return Closing(file, source, room).run();
}

}  // namespace geom
