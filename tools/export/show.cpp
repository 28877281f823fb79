#include "show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <nlohmann/json.hpp>

#include "geom/base/rounding.h"
#include "geom/text/counted.h"
#include "output_names.h"
#include "show_folder.h"
#include "traj/curve/to_enu.h"
#include "traj/mission/read_mission.h"
#include "traj/record/pair_record.h"
#include "traj/together/check_together.h"

namespace exporting {
namespace {

constexpr std::size_t kMostTold = 5;  // refused pairs, on stderr

// A flight as its file will be flown.
struct Act {
  const traj::ExportFlight* flight;
  std::string file;
  std::optional<traj::WrittenMission> made;
  traj::Trajectory enu;
  traj::Trajectory flown;  // in the map's axes
  geom::Vec3 stray;        // what the drone's rounding adds to its half sizes with the margin
  geom::Vec3 room;         // both
};

geom::Vec3 stray_of(const traj::FlownCurve& flown) {
  geom::Vec3 most = geom::Vec3::Zero();
  for (const traj::Stray& stray : flown.stray) most = most.cwiseMax(stray.position);
  return most;
}

geom::Vec3 sum_above(const geom::Vec3& a, const geom::Vec3& b) {
  return (a + b).unaryExpr([](double v) { return geom::next_up(v); });
}

void read_back(const geom::CollisionScene& scene, const traj::MissionFormat& format, Act& act) {
  const auto read = traj::read_mission(act.made->text, act.file, format, act.made->reading,
                                       scene.map().spec().frame);
  const auto& flown = std::get<traj::FlownCurve>(read.front().flown.way);
  act.stray = stray_of(flown);
  act.room = sum_above(scene.half(), act.stray);
  act.flown = flown.trajectory;
}

// Zones grown by what both files' rounding adds; rooms have it already.
traj::Spacing with_stray(traj::Spacing spacing, const geom::Vec3& stray) {
  const double across = geom::next_up(std::hypot(stray.x(), stray.y()));
  for (auto* zone : {&spacing.zone, &spacing.downwash}) {
    if (!*zone) continue;
    const geom::Vec3 more = (*zone)->round ? geom::Vec3(across, across, stray.z()) : stray;
    (*zone)->reach = sum_above((*zone)->reach, 2 * more);
  }
  return spacing;
}

class Show {
 public:
  Show(const cli::Common& common, const Options& options, Exporter& exporter)
      : common_(common), options_(options), exporter_(exporter) {}

  // How many were refused.
  std::size_t make(std::span<const Flight> flights) {
    OutputNames names("%s.csv", "--show");
    for (const Flight& flight : flights) {
      geom::require_epoch_agrees(flight.way.time.epoch, flights.front().way.time.epoch,
                                 options_.source(), 0);
      acts_.push_back(
          {&flight.way, names.of(flight.way.id, options_.source()), {}, {}, {}, {}, {}});
    }
    std::size_t refused = 0;
    for (std::size_t i = 0; i < flights.size(); ++i) {
      Act& act = acts_[i];
      act.made = exporter_.make(flights[i]);
      refused += !act.made;
      if (!act.made) continue;
      act.enu = traj::to_enu(exporter_.frame_of(flights[i]).axes, act.flight->trajectory);
      if (!options_.unchecked) read_back(exporter_.scene_for(flights[i]), options_.format(), act);
    }
    return refused;
  }

  // Every pair, as the files say; stderr says which are too near.
  bool apart() {
    std::vector<traj::TimedFlight> timed;
    geom::Vec3 stray = geom::Vec3::Zero();
    traj::TogetherTask task;
    for (const Act& act : acts_) {
      timed.push_back({&act.flown, act.flight->time.starts(), act.room});
      stray = stray.cwiseMax(act.stray);
      task.ids.push_back(act.flight->id);
    }
    task.rule.spacing = with_stray(options_.spacing, stray);
    task.rule.parked = options_.parked;
    const traj::TogetherResult result =
        traj::check_together(timed, task.rule, common_.execution("pairs"));
    pairs_ = result.pairs;
    tell(result, task);
    return result.ok();
  }

  void save() const {
    ShowFolder folder(options_.show);
    for (const Act& act : acts_) folder.add(act.file, act.made->text);
    folder.add("show.yaml", yaml());
    folder.commit();
  }

  nlohmann::ordered_json statistics(std::size_t refused) const {
    return {{"format", options_.word},
            {"records", acts_.size()},
            {"refused", refused},
            {"pairs", pairs_}};
  }

 private:
  static void tell(const traj::TogetherResult& result, const traj::TogetherTask& task) {
    for (std::size_t i = 0; i < std::min(result.refused.size(), kMostTold); ++i) {
      cli::complain("skyway-export",
                    "refused: flown as the files say, " + traj::in_words(result.refused[i], task));
    }
    if (result.refused.size() > kMostTold) {
      cli::complain("skyway-export",
                    fmt::format("… and {} more", result.refused.size() - kMostTold));
    }
  }

  static std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

  // YAML 1.1 takes a number with an exponent and no point for a text.
  static std::string number(double value) {
    std::string text = fmt::format("{}", value);
    const std::size_t exponent = text.find('e');
    if (exponent != std::string::npos && text.find('.') == std::string::npos) {
      text.insert(exponent, ".0");
    }
    return text;
  }

  static std::string point(const geom::Vec3& p) {
    return fmt::format("[{}, {}, {}]", number(p.x()), number(p.y()), number(p.z()));
  }

  std::string spacing_words() const {
    const auto& spacing = options_.spacing;
    if (!spacing.zone) {
      const double spare = options_.vehicle.spare;
      return spare > 0 ? fmt::format("the vehicles' boxes with their margins less {} m", spare)
                       : "the vehicles' boxes with their margins";
    }
    const geom::Vec3& reach = spacing.zone->reach;
    return spacing.zone->round ? fmt::format("{} m across or {} m in height", reach.x(), reach.z())
                               : fmt::format("{} m along x, {} m along y or {} m in height",
                                             reach.x(), reach.y(), reach.z());
  }

  std::string head() const {
    std::string out = "# When each file of this folder begins, in seconds after one instant.\n";
    if (options_.unchecked) {
      out += "# UNCHECKED: not compared with any map, nor with one another.\n";
    } else {
      out += fmt::format("# Proved clear of the map, and apart by {}, while they begin so.\n",
                         spacing_words());
      if (options_.parked == traj::Parked::gone) {
        out += "# Only in flight: one that stands before or after was not looked at.\n";
      }
    }
    out += fmt::format("checked: {}\n", !options_.unchecked);
    const auto& epoch = acts_.front().flight->time.epoch;
    if (epoch) out += fmt::format("epoch: {}\n", quoted(*epoch));
    return out;
  }

  std::string yaml() const {
    std::vector<const Act*> order;
    for (const Act& act : acts_) order.push_back(&act);
    std::stable_sort(order.begin(), order.end(), [](const Act* a, const Act* b) {
      return a->flight->time.starts() < b->flight->time.starts();
    });
    std::string out = head() + "flights:\n";
    for (const Act* act : order) {
      const auto& segments = act->enu.segments;
      out += fmt::format("  - id: {}\n    file: {}\n    start: {}\n    duration: {}\n",
                         quoted(act->flight->id), quoted(act->file),
                         number(act->flight->time.starts()), number(traj::duration(act->enu)));
      out +=
          fmt::format("    initial_position: {}\n    final_position: {}\n",
                      point(segments.front().point.front()), point(segments.back().point.back()));
    }
    return out;
  }

  const cli::Common& common_;
  const Options& options_;
  Exporter& exporter_;
  std::deque<Act> acts_;
  std::size_t pairs_ = 0;
};

}  // namespace

cli::Exit export_show(const cli::Common& common, const Options& options, Exporter& exporter,
                      std::span<const Flight> flights) {
  require_free(options.show);
  Show show(common, options, exporter);
  const std::size_t refused = show.make(flights);
  const bool apart = refused == 0 && (options.unchecked || show.apart());
  common.write_stats(show.statistics(refused));
  if (refused > 0) {
    cli::complain("skyway-export", fmt::format("{} of {} were refused: no folder was made", refused,
                                               geom::counted(flights.size(), "flight")));
  } else if (!apart) {
    cli::complain("skyway-export",
                  "flights are too near each other: no folder was made; give them "
                  "other departures (skyway-fleet)");
  }
  if (!apart) return cli::Exit::no;
  show.save();
  return cli::Exit::yes;
}

}  // namespace exporting
