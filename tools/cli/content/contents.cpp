#include "contents.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "cli/file/files.h"
#include "cli/file/recognise.h"
#include "geom/base/error.h"
#include "geom/map/box_map_file.h"
#include "geom/record/named_map.h"
#include "geom/text/json_fields.h"
#include "plan/lattice/lattice_file.h"
#include "traj/files/drone_formats.h"
#include "traj/mission/file_records.h"
#include "traj/record/checked_hash.h"

namespace cli {
namespace {

constexpr const char* kNotOfMoving =
    "nothing here says what skyway-check --moving found: leave its lines of moving_conflict and "
    "clear_of_moving out, and see them with --report text";

void add_archive(const geom::ArrayArchive& archive, Contents& out) {
  const std::string& name = archive.name();
  if (geom::is_box_map(archive)) {
    if (out.map) {
      throw geom::InputError(name, {.expected = "one map",
                                    .found = fmt::format("another beside {}", out.map->source),
                                    .advice = "join them with skyway-map join"});
    }
    out.map = {open_map(archive, geom::Verified::extents), name, 0};
  } else if (plan::is_lattice(archive)) {
    out.lattices.push_back({plan::read_lattice(archive), name, 0});
  } else {
    throw geom::InputError(
        name, {.expected = "a box map or a lattice", .found = "an archive of another kind"});
  }
}

// Sorts the lines of one stream into the contents.
class Records {
 public:
  Records(const std::string& source, const ContentKinds& kinds, Contents& out)
      : source_(source), kinds_(kinds), out_(out) {}

  void add(const std::string& text, std::size_t line) {
    if (tree_ && !tree_->complete()) {
      tree_->add(text, source_, line);
    } else {
      finish_tree(line);
      add_record(text, line);
    }
  }

  void finish_tree(std::size_t line) {
    if (!tree_) return;
    out_.trees.push_back({std::move(*tree_).finish(source_, line), source_, tree_line_});
    tree_.reset();
  }

 private:
  void add_record(const std::string& text, std::size_t line) {
    const geom::JsonFields fields(text, source_, line);
    const std::string type = fields.text("type", "query");
    if (type == "tree") {
      tree_.emplace(text, source_, line);
      tree_line_ = line;
    } else if (type == "path") {
      out_.paths.push_back({geom::read_path_record(fields), source_, line});
    } else if (type == "trajectory") {
      out_.trajectories.push_back({traj::read_trajectory_record(fields), source_, line});
    } else if (type == "corridor" && kinds_.corridors) {
      out_.corridors.push_back({traj::parse_corridor_record(text, source_, line), source_, line});
    } else if (type == "pair" && kinds_.reports) {
      out_.pairs.push_back({traj::parse_pair_record(text, source_, line), source_, line});
    } else if (type == "together" && kinds_.reports) {
      out_.together.push_back({traj::parse_together_record(text, source_, line), source_, line});
    } else if ((type == "report" || type == "flight") && kinds_.reports) {
      out_.reports.push_back({traj::parse_report_record(text, source_, line), source_, line});
      if (type == "flight") add_tube(text, line);
    } else if (type == "contingency" && kinds_.contingencies) {
      out_.contingencies.push_back(
          {traj::parse_contingency_record(text, source_, line), source_, line});
    } else {
      const bool moving = type == "moving_conflict" || type == "clear_of_moving";
      fields.refuse({.expected = kinds_.expected,
                     .found = geom::in_quotes(type),
                     .advice = moving ? kNotOfMoving : ""});
    }
  }

  void add_tube(const std::string& text, std::size_t line) {
    if (auto tube = traj::parse_tube(text, source_, line)) {
      out_.tubes.push_back({*std::move(tube), source_, line});
    }
  }

  const std::string& source_;
  const ContentKinds& kinds_;
  Contents& out_;
  std::optional<plan::SearchTreeReader> tree_;
  std::size_t tree_line_ = 0;
};

void add_records(InputFile& file, const ContentKinds& kinds, Contents& out) {
  Records records(file.name(), kinds, out);
  std::size_t last = 0;
  file.for_each_line([&](const std::string& text, std::size_t line) {
    records.add(text, line);
    last = line;
  });
  records.finish_tree(last);
}

void add_flights(InputFile& file, Contents& out) {
  for (traj::FlightLog& log : traj::read_flight_log(file.stream(), file.name())) {
    out.flights.push_back({std::move(log), file.name(), 0});
  }
}

// Paths, as long as there is a path to see; of a trajectory its record.
void add_drone_file(const std::string& path, DroneFileOptions& options, Contents& out) {
  InputFile file(path);
  geom::Provenance provenance;
  geom::Frame frame;
  if (out.map) {
    frame = out.map->record.spec().frame;
    provenance.map = out.map->record.hash();
  }
  provenance.frame = frame.axes;
  options.settle_ground(frame);
  const std::string text = file.read_all();
  for (traj::FileFlight& one : read_drone_file(text, file.name(), options, frame)) {
    if (auto legs = traj::path_record(one, provenance, true)) {
      out.paths.push_back({std::move(*legs), file.name(), 0});
    } else {
      out.trajectories.push_back({traj::trajectory_record(one, provenance), file.name(), 0});
    }
    if (auto regions = traj::regions_record(one, provenance)) {
      out.corridors.push_back({std::move(*regions), file.name(), 0});
    }
    out.drone_flights.push_back(std::move(one));
  }
}

void add_input(const std::string& path, const ContentKinds& kinds, Contents& out) {
  InputFile file(path);
  const int first = file.stream().peek();
  if (first == std::char_traits<char>::eof()) {
    throw geom::InputError(file.name(),
                           {.expected = "records or a flight log", .found = "an empty file"});
  }
  if (first == 'P' && kinds.archives) return add_archive(open_archive(path), out);
  if (first == '{' || std::isspace(first)) return add_records(file, kinds, out);
  add_flights(file, out);
}

// Compares what records say of their map with the map, or with the first that says anything.
class SameMap {
 public:
  explicit SameMap(const geom::BoxMap* map) {
    if (!map) return;
    map_.emplace(*map);
    first_ = {map->hash(), map->spec().frame.axes, {}, {}};
  }

  // What says only where something goes.
  void require(const geom::Provenance& made_for, const std::string& source, std::size_t line) {
    if (map_) return map_->require(made_for, source, line);
    require_exactly(made_for, source, line);
  }
  // What says that something is free or clear, which boxes that were added since may not be.
  void require_exactly(const geom::Provenance& made_for, const std::string& source,
                       std::size_t line) {
    if (!first_.map) first_.map = made_for.map;
    geom::require_map_agrees(made_for, first_, source, line);
  }

 private:
  std::optional<geom::NamedMap> map_;
  geom::Provenance first_;  // its map and, where there is a map, its frame
};

void require_metres(const Contents& contents, const geom::Frame& frame,
                    const MetresOption& metres) {
  for (const auto& [path, source, line] : contents.paths) {
    metres.check_input(frame, path.points, source, line);
  }
  for (const auto& [record, source, line] : contents.trajectories) {
    metres.check_input(frame, record.trajectory, source, line);
  }
  for (const auto& [flight, source, line] : contents.flights) {
    metres.check_input(frame, flight, source, line);
  }
}

// A report is of one of the records of its kind and id, where there are some.
template <class Record>
void require_of_shown(const Contents& contents, const std::vector<Read<Record>>& records) {
  std::multimap<std::string_view, const Record*> shown;
  for (const auto& read : records) shown.emplace(read.record.id, &read.record);
  for (const auto& [report, source, line] : contents.reports) {
    std::optional<geom::Fault> why;
    const auto [first, last] = shown.equal_range(report.id);
    for (auto it = first; it != last && (it == first || why); ++it) {
      why = traj::why_not_of(report, *it->second);
    }
    if (why) throw geom::InputError(source, line, *std::move(why));
  }
}

// Ways home and reports of some are of a trajectory or path of their id, where there are some.
void require_home_of_shown(const Contents& contents) {
  std::map<std::string_view, std::vector<std::string>> flights;
  const auto add = [&](const auto& record) {
    flights[record.id].push_back(traj::checked_hash(record));
  };
  for (const auto& read : contents.trajectories) add(read.record);
  for (const auto& read : contents.paths) add(read.record);
  for (const auto& [way, source, line] : contents.contingencies) {
    traj::require_of_flight(way.id, way.flight_hash, flights[way.id], source, line);
  }
  for (const auto& [report, source, line] : contents.reports) {
    if (report.checked != traj::kCheckedContingency) continue;
    traj::require_of_flight(report.id, report.checked_hash, flights[report.id], source, line);
  }
}

}  // namespace

Contents read_contents(const std::vector<std::string>& inputs, const ContentKinds& kinds) {
  Contents out;
  std::vector<std::string> drone_files;
  for (const std::string& path : inputs) {
    if (kinds.drone_files && traj::files::is_drone_format(recognise_file(path))) {
      drone_files.push_back(path);
    } else {
      add_input(path, kinds, out);
    }
  }
  for (const std::string& path : drone_files) add_drone_file(path, *kinds.drone_files, out);
  return out;
}

void require_same_map(const Contents& contents, const geom::BoxMap* map,
                      const MetresOption& metres) {
  SameMap same(map);
  if (map) require_metres(contents, map->spec().frame, metres);
  for (const auto& [lattice, source, line] : contents.lattices) {
    same.require_exactly(lattice.made_for(), source, line);
  }
  for (const auto& [flight, source, line] : contents.flights) {
    if (!flight.map.empty()) same.require({flight.map, {}, {}, {}}, source, line);
  }
  const auto ways = [&](const auto& list) {
    for (const auto& [record, source, line] : list) same.require(record.provenance, source, line);
  };
  ways(contents.paths);
  ways(contents.trajectories);
  const auto claims = [&](const auto& list) {
    for (const auto& [record, source, line] : list) {
      same.require_exactly(record.provenance, source, line);
    }
  };
  claims(contents.trees);
  claims(contents.corridors);
  claims(contents.reports);
  claims(contents.contingencies);
  for (const auto& [record, source, line] : contents.together) {
    if (record.map) same.require_exactly({*record.map, {}, {}, {}}, source, line);
  }
  require_of_shown(contents, contents.trajectories);
  require_of_shown(contents, contents.paths);
  require_of_shown(contents, contents.flights);
  require_home_of_shown(contents);
}

void warn_of_unsaid_maps(const Common& common, const Contents& contents) {
  std::set<std::string> files;
  for (const auto& [flight, file, line] : contents.flights) {
    if (!flight.map.empty() || !files.insert(file).second) continue;
    common.warn(file + ": the log does not say its map: it is drawn as if it were of this one");
  }
}

std::size_t drop_failed(Contents& contents) {
  return std::erase_if(contents.paths,
                       [](const auto& p) { return p.record.status != geom::PathStatus::found; }) +
         std::erase_if(contents.trajectories, [](const auto& t) {
           return t.record.status != traj::TrajectoryStatus::solved;
         });
}

}  // namespace cli
