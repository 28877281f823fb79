#include "show.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/file/new_folder.h"
#include "geom/text/counted.h"
#include "geom/text/output_names.h"
#include "traj/curve/to_enu.h"
#include "traj/mission/show.h"

namespace exporting {
namespace {

constexpr std::size_t kMostTold = 5;  // refused pairs, on stderr

class Show {
 public:
  Show(const cli::Common& common, const Options& options, Exporter& exporter)
      : common_(common), options_(options), exporter_(exporter) {}

  // How many were refused.
  std::size_t make(std::span<const Flight> flights) {
    geom::OutputNames names("%s.csv", "--show");
    std::vector<std::string> files;
    for (const Flight& flight : flights) {
      geom::require_epoch_agrees(flight.way.time.epoch, flights.front().way.time.epoch,
                                 options_.source(), 0);
      files.push_back(names.of(flight.way.id, options_.source()));
    }
    for (std::size_t i = 0; i < flights.size(); ++i) add(flights[i], files[i]);
    return flights.size() - acts_.size();
  }

  // Every pair, as the files say; stderr says which are too near.
  bool apart() {
    const auto [task, result] =
        traj::check_show(acts_, options_.spacing, options_.parked, common_.execution("pairs"));
    pairs_ = result.pairs;
    tell(result, task);
    return result.ok();
  }

  void save() const {
    cli::NewFolder folder(options_.show, "--show");
    for (std::size_t i = 0; i < acts_.size(); ++i) folder.add(acts_[i].file, texts_[i]);
    folder.add("show.yaml", traj::show_yaml(acts_, {.checked = !options_.unchecked,
                                                    .spacing = options_.spacing,
                                                    .spare = options_.vehicle.spare,
                                                    .parked = options_.parked}));
    folder.commit();
  }

  std::size_t pairs() const { return pairs_; }

 private:
  void add(const Flight& flight, const std::string& file) {
    auto made = exporter_.make(flight);
    if (!made) return;
    traj::ShowFlight act{.id = flight.way.id, .file = file, .time = flight.way.time};
    act.planned = traj::to_enu(exporter_.frame_of(flight).axes, flight.way.trajectory);
    if (!options_.unchecked) {
      act = traj::read_back(std::move(act), exporter_.scene_for(flight), options_.format(), *made);
    }
    acts_.push_back(std::move(act));
    texts_.push_back(std::move(made->text));
  }

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

  const cli::Common& common_;
  const Options& options_;
  Exporter& exporter_;
  std::vector<traj::ShowFlight> acts_;
  std::vector<std::string> texts_;  // of their files
  std::size_t pairs_ = 0;
};

}  // namespace

cli::Exit export_show(const cli::Common& common, const Options& options, Exporter& exporter,
                      std::span<const Flight> flights) {
  cli::require_free(options.show, "--show");
  Show show(common, options, exporter);
  const std::size_t refused = show.make(flights);
  const bool apart = refused == 0 && (options.unchecked || show.apart());
  common.write_stats({{"format", options.word},
                      {"records", flights.size()},
                      {"refused", refused},
                      {"pairs", show.pairs()}});
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
