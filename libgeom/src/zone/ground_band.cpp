#include "geom/zone/ground_band.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/rounding.h"

namespace geom {
namespace {

constexpr std::size_t kMostBoxes = 2'000'000;

class Banding {
 public:
  Banding(const GroundBand& band, const GroundModel& ground, const BoxMapSpec& spec,
          const std::string& source)
      : band_(band), ground_(ground), bounds_(spec.bounds), source_(source) {
    if (band.low) below_ = out_.label_of(fmt::format("less than {} m above ground", *band.low));
    if (band.high) above_ = out_.label_of(fmt::format("more than {} m above ground", *band.high));
    if (band.close_unknown) unknown_ = out_.label_of("ground not known");
  }

  BoxTable run() {
    close({bounds_.min.head<2>(), bounds_.max.head<2>()});
    return std::move(out_);
  }

 private:
  // Cuts the region until the ground in each part is as level as the step.
  void close(const Rectangle& region) {
    const GroundRange ground = ground_.range(region);
    const bool whole = ground.level(band_.step, ground_.spec().error) || !ground.any_known;
    if (const auto parts = whole ? std::nullopt : ground_.cut(region)) {
      close(parts->first);
      close(parts->second);
      return;
    }
    if (!ground.all_known) {
      refuse_unknown(region);
      add(region, bounds_.min.z(), bounds_.max.z(), unknown_);
      return;
    }
    if (band_.low) add(region, bounds_.min.z(), add_up(ground.high, *band_.low), below_);
    if (band_.high) add(region, add_down(ground.low, *band_.high), bounds_.max.z(), above_);
  }

  void refuse_unknown(const Rectangle& region) const {
    if (band_.close_unknown) return;
    throw InputError(
        source_,
        {.expected = "a height model that knows the ground everywhere within the bounds",
         .found = fmt::format("a hole, or its end, at x {:.6g} to {:.6g}, y {:.6g} to {:.6g}",
                              region.min.x(), region.max.x(), region.min.y(), region.max.y()),
         .advice = "crop the map to where the ground is known, or close the rest "
                   "(--close-unknown)"});
  }

  void add(const Rectangle& region, double bottom, double top, std::uint32_t label) {
    if (bottom > bounds_.max.z() || top < bounds_.min.z()) return;
    if (out_.boxes.size() >= kMostBoxes) {
      throw InputError(source_, {.expected = fmt::format("ground that {} boxes follow", kMostBoxes),
                                 .found = "more",
                                 .advice = "give a larger --step, or crop the map"});
    }
    out_.add({{region.min.x(), region.min.y(), std::min(bottom, top)},
              {region.max.x(), region.max.y(), std::max(bottom, top)}},
             out_.boxes.size(), label);
  }

  const GroundBand& band_;
  const GroundModel& ground_;
  const Aabb& bounds_;
  const std::string& source_;
  BoxTable out_;
  std::uint32_t below_ = 0;
  std::uint32_t above_ = 0;
  std::uint32_t unknown_ = 0;
};

}  // namespace

BoxTable ground_band_boxes(const GroundBand& band, const GroundModel& ground,
                           const BoxMapSpec& spec, const std::string& source) {
  require_same_frame(ground, spec.frame, source);
  return Banding(band, ground, spec, source).run();
}

void require_same_zero(const GroundModel& ground, const BoxMap& map, const std::string& source) {
  require_same_frame(ground, map.spec().frame, source);
  const Aabb& bounds = map.spec().bounds;
  const GroundRange range = ground.range({bounds.min.head<2>(), bounds.max.head<2>()});
  if (!range.any_known) return;
  double highest = bounds.min.z();
  for (const Aabb& box : map.boxes()) highest = std::max(highest, box.max.z());
  const bool beside = range.low > bounds.max.z() || range.high < bounds.min.z();
  if (!beside && (map.size() == 0 || highest >= range.low)) return;
  throw InputError(
      source,
      {.expected = fmt::format("ground within the bounds, z {:.6g} to {:.6g}, and not above "
                               "all that stands there, z {:.6g}",
                               bounds.min.z(), bounds.max.z(), highest),
       .found = fmt::format("ground at z {:.6g} to {:.6g}", range.low, range.high),
       .advice = "do both count from the same zero? (docs/guide/heights.md)"});
}

}  // namespace geom
