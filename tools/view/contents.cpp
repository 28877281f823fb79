#include "view/contents.h"

#include <fmt/format.h>

#include <sstream>
#include <string_view>
#include <utility>

#include "cli/files.h"
#include "geom/error.h"
#include "geom/io/box_map_file.h"
#include "plan/io/lattice_file.h"

namespace view {
namespace {

void add_archive(const geom::ArrayArchive& archive, Contents& out) {
  const std::string& name = archive.name();
  if (geom::is_box_map(archive)) {
    if (out.map) {
      throw geom::InputError(name, fmt::format("expected one map, found another beside {}: join "
                                               "them with skyway-map join",
                                               out.map->source));
    }
    out.map = {geom::read_box_map(archive), name, 0};
  } else if (plan::is_lattice(archive)) {
    out.lattices.push_back({plan::read_lattice(archive), name, 0});
  } else {
    throw geom::InputError(name, "expected a box map or a lattice, found another archive");
  }
}

// Sorts the lines of one stream into the contents.
class Records {
 public:
  Records(const std::string& source, Contents& out) : source_(source), out_(out) {}

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
      out_.paths.push_back({geom::parse_path_record(text, source_, line), source_, line});
    } else if (type == "trajectory") {
      out_.trajectories.push_back(
          {traj::parse_trajectory_record(text, source_, line), source_, line});
    } else if (type == "corridor") {
      out_.corridors.push_back({traj::parse_corridor_record(text, source_, line), source_, line});
    } else if (type == "report" || type == "flight") {
      out_.reports.push_back({traj::parse_report_record(text, source_, line), source_, line});
    } else {
      fields.refuse(fmt::format(
          "expected a path, a trajectory, a tree, a corridor or a report, found a {}", type));
    }
  }

  const std::string& source_;
  Contents& out_;
  std::optional<plan::SearchTreeReader> tree_;
  std::size_t tree_line_ = 0;
};

void add_records(const std::string& text, const std::string& source, Contents& out) {
  Records records(source, out);
  std::istringstream in(text);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") != std::string::npos) records.add(line, number);
  }
  records.finish_tree(number);
}

void add_text(const std::string& text, const std::string& source, Contents& out) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) {
    throw geom::InputError(source, "expected records or a flight log, found an empty file");
  }
  if (text[first] == '{') return add_records(text, source, out);
  std::istringstream in(text);
  for (traj::FlightLog& log : traj::read_flight_log(in, source)) {
    out.flights.push_back({std::move(log), source, 0});
  }
}

void add_file(const std::string& path, Contents& out) {
  cli::InputFile file(path);
  if (file.stream().peek() != 'P') return add_text(file.read_all(), file.name(), out);
  if (path != "-") return add_archive(cli::open_archive(path), out);
  const std::string bytes = file.read_all();
  add_archive(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "stdin"), out);
}

// Compares what records say of their map with the map, or with the first that says anything.
class SameMap {
 public:
  explicit SameMap(const std::optional<Read<geom::BoxMap>>& map) {
    if (!map) return;
    hash_ = map->record.hash();
    axes_ = map->record.spec().frame.axes;
  }

  void require(const geom::Provenance& made_for, const std::string& source, std::size_t line) {
    if (!hash_) hash_ = made_for.map;
    if (made_for.map && *made_for.map != *hash_) {
      throw geom::InputError(
          source, line,
          fmt::format("made for another map: expected {}, found {}", *hash_, *made_for.map));
    }
    if (axes_ && made_for.frame && *made_for.frame != *axes_) {
      throw geom::InputError(source, line,
                             fmt::format("expected frame {}, as the map has, found {}",
                                         geom::name(*axes_), geom::name(*made_for.frame)));
    }
  }

 private:
  std::optional<std::string> hash_;
  std::optional<geom::Axes> axes_;
};

void require_same_map(const Contents& contents) {
  SameMap same(contents.map);
  for (const auto& [lattice, source, line] : contents.lattices) {
    same.require(lattice.made_for(), source, line);
  }
  const auto all = [&](const auto& list) {
    for (const auto& [record, source, line] : list) same.require(record.provenance, source, line);
  };
  all(contents.trees);
  all(contents.paths);
  all(contents.trajectories);
  all(contents.corridors);
  all(contents.reports);
}

}  // namespace

Contents read_contents(const std::vector<std::string>& files) {
  Contents out;
  for (const std::string& path : files) add_file(path, out);
  require_same_map(out);
  return out;
}

geom::Axes axes_of(const Contents& contents, const geom::Provenance& provenance) {
  if (provenance.frame) return *provenance.frame;
  return contents.map ? contents.map->record.spec().frame.axes : geom::Axes::enu;
}

}  // namespace view
