#include "cli/drawings.h"

#include <fmt/format.h>

#include <optional>
#include <sstream>

#include "cli/files.h"
#include "geom/error.h"
#include "geom/io/json_fields.h"

namespace cli {
namespace {

void require_of(const geom::BoxMap* map, const geom::Provenance& record, const std::string& source,
                std::size_t line) {
  if (!map) return;
  if (record.map && *record.map != map->hash()) {
    throw geom::InputError(
        source, line,
        fmt::format("made for another map: expected {}, found {}", map->hash(), *record.map));
  }
  const geom::Axes axes = map->spec().frame.axes;
  if (record.frame && *record.frame != axes) {
    throw geom::InputError(source, line,
                           fmt::format("expected frame {}, as the map has, found {}",
                                       geom::name(axes), geom::name(*record.frame)));
  }
}

class RecordReader {
 public:
  RecordReader(const std::string& source, const geom::BoxMap* map, Drawings& to,
               Corridors corridors)
      : source_(source), map_(map), to_(to), corridors_(corridors) {}

  void read(const std::string& text, std::size_t line) {
    if (tree_ && !tree_->complete()) {
      tree_->add(text, source_, line);
    } else {
      finish_tree(line);
      read_record(text, line);
    }
  }

  void finish_tree(std::size_t line) {
    if (!tree_) return;
    to_.trees.push_back(std::move(*tree_).finish(source_, line));
    tree_.reset();
    require_of(map_, to_.trees.back().provenance, source_, line);
  }

 private:
  template <class Record>
  void keep(Record record, const char* wanted, std::vector<Record>& list, std::size_t line) {
    require_of(map_, record.provenance, source_, line);
    if (record.status == wanted) {
      list.push_back(std::move(record));
    } else {
      ++to_.failed;
    }
  }

  void read_record(const std::string& text, std::size_t line) {
    const geom::JsonFields fields(text, source_, line);
    const std::string type = fields.text("type");
    if (type == "path") {
      keep(geom::parse_path_record(text, source_, line), "found", to_.paths, line);
    } else if (type == "trajectory") {
      keep(traj::parse_trajectory_record(text, source_, line), "solved", to_.trajectories, line);
    } else if (type == "tree") {
      tree_.emplace(text, source_, line);
    } else if (type == "corridor" && corridors_ == Corridors::taken) {
      to_.corridors.push_back(traj::parse_corridor_record(text, source_, line));
      require_of(map_, to_.corridors.back().provenance, source_, line);
    } else {
      fields.refuse(fmt::format("expected a record of type path, trajectory{}, found \"{}\"",
                                corridors_ == Corridors::taken ? ", tree or corridor" : " or tree",
                                type));
    }
  }

  const std::string& source_;
  const geom::BoxMap* map_;
  Drawings& to_;
  Corridors corridors_;
  std::optional<plan::SearchTreeReader> tree_;
};

}  // namespace

void read_drawings(const std::string& input, const geom::BoxMap* map, Drawings& drawings,
                   Corridors corridors) {
  InputFile file(input);
  if (file.stream().peek() != '{') {
    const bool empty = file.stream().eof();
    if (empty) {
      throw geom::InputError(file.name(), "expected records or a flight log, found nothing");
    }
    auto flights = traj::read_flight_log(file.stream(), file.name());
    std::move(flights.begin(), flights.end(), std::back_inserter(drawings.flights));
    return;
  }
  RecordReader reader(file.name(), map, drawings, corridors);
  std::size_t last = 0;
  file.for_each_line([&](const std::string& text, std::size_t line) {
    reader.read(text, line);
    last = line;
  });
  reader.finish_tree(last);
}

}  // namespace cli
