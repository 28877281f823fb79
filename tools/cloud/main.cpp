// skyway-cloud: point clouds become box maps.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/file/files.h"
#include "cli/file/hashed_input.h"
#include "cli/file/map_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/skipped_option.h"
#include "cli/run.h"
#include "cli/shard/map_shard.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/cloud/point_cloud.h"
#include "geom/map/column_grid.h"
#include "pcl_filters.h"
#include "placement.h"

namespace {

using cloud::Points;
using geom::CloudPoint;
using Report = nlohmann::ordered_json;  // how many points each step dropped, in order

struct Options {
  std::string format = "auto";
  std::string mode = "columns";
  std::string ground = "keep";
  std::string unknown = "free";
  std::string outliers;  // "K,DEVIATIONS"
  double voxel = 0;
  double tolerance = 1;
  std::size_t min_points = 1;
  std::vector<int> classes;
  geom::ColumnSpec columns;
  geom::GroundSpec ground_spec;
  cloud::Placement placement;
  cli::SkippedOption skipped;
  cli::MapOptions map;

  bool in_memory() const { return !outliers.empty() || voxel > 0 || mode == "objects"; }
};

std::string detect(std::string_view head, const std::string& name) {
  if (head.starts_with("LASF")) return "las";
  if (head.starts_with("ply")) return "ply";
  const std::size_t pcd = head.substr(0, 2000).find("FIELDS");
  if (pcd != std::string_view::npos && head.find("DATA") != std::string_view::npos) return "pcd";
  if (head.empty()) throw geom::InputError(name, "the file is empty");
  return "xyz";
}

geom::CloudCounts read(std::istream& in, const std::string& name, const Options& options,
                       const geom::PointSink& sink, const geom::ReferenceSink& reference) {
  if (options.format == "las") return geom::read_las(in, name, sink, reference);
  reference({});  // the others have no place for it
  if (options.format == "ply") return geom::read_ply(in, name, sink);
  if (options.format == "pcd") return geom::read_pcd(in, name, sink);
  return geom::read_xyz(in, name, sink);
}

// The points of the classes asked for, one by one, in metres.
class Cloud {
 public:
  Cloud(const std::string& path, Options& options) : path_(path), options_(options) {}

  void for_each(const std::function<void(const CloudPoint&)>& f) {
    cli::InputFile file(path_);
    cli::HashedInput hashed(file);
    if (options_.format == "auto") options_.format = detect(hashed.head(), file.name());
    other_class_ = 0;
    const auto points = [&](std::span<const CloudPoint> chunk) {
      for (const CloudPoint& p : chunk) {
        const bool wanted = options_.classes.empty() ||
                            std::find(options_.classes.begin(), options_.classes.end(), p.cls) !=
                                options_.classes.end();
        if (wanted) {
          f({in_metres(p.position, file.name()), p.cls});
        } else {
          ++other_class_;
        }
      }
    };
    counts_ = read(hashed.stream(), file.name(), options_, points,
                   [&](const geom::CoordinateReference& told) {
                     says_nothing_ = told.kind == geom::CoordinateReference::Kind::none;
                     options_.placement.settle(told, file.name());
                   });
    hash_ = hashed.hash();
  }

  const std::string& hash() const { return hash_; }
  const geom::Skipped& skipped() const { return counts_.skipped; }
  bool says_nothing() const { return says_nothing_; }  // of what its coordinates mean

  void report(Report& out) const {
    out["points"] = counts_.read;
    out["dropped_not_finite"] = counts_.not_finite;
    if (!options_.classes.empty()) out["dropped_by_class"] = other_class_;
  }

 private:
  geom::Vec3 in_metres(const geom::Vec3& p, const std::string& name) const {
    const geom::Vec3 metres = options_.placement.in_metres(p);
    if (!(metres.cwiseAbs().maxCoeff() <= geom::kLargestCoordinate)) {
      throw geom::InputError(name, fmt::format("a point must be within 1e8 m of the origin, found "
                                               "[{}, {}, {}] in metres",
                                               metres.x(), metres.y(), metres.z()));
    }
    return metres;
  }

  std::string path_;
  Options& options_;
  geom::CloudCounts counts_;
  bool says_nothing_ = false;
  std::size_t other_class_ = 0;
  std::string hash_;
};

// Points by square places of 16 cells: a shard has a part of the columns, not of each.
bool takes(const geom::Shard& shard, const geom::Vec3& p, double cell) {
  const auto place = [&](double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / (16 * cell))));
  };
  return shard.takes(place(p.x()) + 31 * place(p.y()));
}

geom::ColumnGrid stream(Cloud& points, const Options& options, const geom::Shard& shard,
                        Report& report) {
  geom::GroundGrid ground(options.ground_spec);
  const bool drop_ground = options.ground == "drop";
  if (drop_ground) {
    points.for_each([&](const CloudPoint& p) { ground.add(p.position); });
    ground.finish();
  }
  geom::ColumnGrid columns(options.columns);
  std::size_t kept = 0;
  std::size_t dropped = 0;
  points.for_each([&](const CloudPoint& p) {
    if (shard.count > 1 && !takes(shard, p.position, options.columns.cell)) return;
    if (drop_ground && ground.is_ground(p.position)) {
      ++dropped;
      return;
    }
    ++kept;
    columns.add(p.position);
  });
  points.report(report);
  if (drop_ground) report["dropped_as_ground"] = dropped;
  report["kept"] = kept;
  return columns;
}

Points without_ground(const Points& points, const geom::GroundSpec& spec) {
  geom::GroundGrid ground(spec);
  for (const CloudPoint& p : points) ground.add(p.position);
  ground.finish();
  Points out;
  for (const CloudPoint& p : points) {
    if (!ground.is_ground(p.position)) out.push_back(p);
  }
  return out;
}

// A box an object, and none for objects of too few points.
geom::BoxTable object_boxes(const Points& points, const Options& options, Report& report) {
  geom::BoxTable table;
  std::size_t dropped = 0;
  for (const auto& cluster : cloud::clusters(points, options.tolerance)) {
    if (cluster.size() < options.min_points) {
      dropped += cluster.size();
      continue;
    }
    geom::Aabb box{points[cluster.front()].position, points[cluster.front()].position};
    for (const std::size_t i : cluster) {
      box = geom::merged(box, {points[i].position, points[i].position});
    }
    table.add(box, table.boxes.size());
  }
  if (options.min_points > 1) report["dropped_in_small_objects"] = dropped;
  report["kept"] = points.size() - dropped;
  report["objects"] = table.boxes.size();
  return table;
}

geom::BoxTable filter(Cloud& source, const Options& options, const std::string& name,
                      Report& report) {
  Points points;
  source.for_each([&](const CloudPoint& p) { points.push_back(p); });
  source.report(report);
  const auto apply = [&](const char* what, Points left) {
    report[what] = points.size() - left.size();
    points = std::move(left);
  };
  if (!options.outliers.empty()) {
    const auto numbers = cli::parse_numbers(options.outliers, 2);
    const double k = numbers ? (*numbers)[0] : 0;
    if (!(k >= 1 && k <= 1000) || k != std::floor(k) || !((*numbers)[1] > 0)) {
      throw cli::UsageError("--outliers must be NEIGHBOURS,DEVIATIONS, found \"" +
                            options.outliers + "\"");
    }
    apply("dropped_as_outliers",
          cloud::without_outliers(points, static_cast<int>(k), (*numbers)[1]));
  }
  if (options.voxel > 0)
    apply("dropped_by_voxel", cloud::one_per_voxel(points, options.voxel, name));
  if (options.ground == "drop") {
    apply("dropped_as_ground", without_ground(points, options.ground_spec));
  }
  if (options.mode == "objects") return object_boxes(points, options, report);
  geom::ColumnGrid columns(options.columns);
  for (const CloudPoint& p : points) columns.add(p.position);
  report["kept"] = points.size();
  return columns.boxes(name);
}

Report step_of(const std::string& hash, const Options& options, const geom::MakeMapOptions& map) {
  Report step = {{"tool", "skyway-cloud"},       {"input", hash},
                 {"format", options.format},     {"mode", options.mode},
                 {"cell", options.columns.cell}, {"step", options.columns.step},
                 {"gap", options.columns.gap},   {"ground", options.ground},
                 {"unknown", options.unknown}};
  if (!options.outliers.empty()) step["outliers"] = options.outliers;
  if (options.voxel > 0) step["voxel"] = options.voxel;
  if (!options.classes.empty()) step["classes"] = options.classes;
  if (options.ground == "drop") {
    step["ground_cell"] = options.ground_spec.cell;
    step["ground_slope"] = options.ground_spec.slope;
    step["ground_height"] = options.ground_spec.height;
  }
  if (options.mode == "objects") {
    step["tolerance"] = options.tolerance;
    step["min_points"] = options.min_points;
  }
  options.placement.record(step);
  step.update(cli::history_of(map));
  return step;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--format", options.format, "what the file is (default: auto)")
      ->check(CLI::IsMember({"auto", "pcd", "ply", "las", "xyz"}));
  app.add_option("--mode", options.mode, "boxes per column (default) or per object")
      ->check(CLI::IsMember({"columns", "objects"}));
  app.add_option("--cell", options.columns.cell, "side of a column, metres (default 1)")
      ->check(CLI::Range(0.05, 1000.0));
  app.add_option(
         "--step", options.columns.step,
         "heights of columns are rounded outward to multiples of this, metres (default 0.5)")
      ->check(CLI::Range(0.05, 1000.0));
  app.add_option("--gap", options.columns.gap,
                 "returns of a column that are further apart than this, metres, have free space "
                 "between them (default 2)")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--classes", options.classes, "keep only these LAS classes: 6,9,…")
      ->delimiter(',')
      ->check(CLI::Range(0, 255));
  app.add_option("--outliers", options.outliers,
                 "NEIGHBOURS,DEVIATIONS: drop points far from their neighbours");
  app.add_option("--voxel", options.voxel, "keep one point per cube of this side, metres")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_option("--ground", options.ground, "keep (default) the ground as boxes, or drop it")
      ->check(CLI::IsMember({"keep", "drop"}));
  app.add_option("--ground-cell", options.ground_spec.cell,
                 "cells whose lowest returns make the ground, metres (default 2)")
      ->check(CLI::Range(0.1, 1000.0));
  app.add_option("--ground-slope", options.ground_spec.slope,
                 "metres that ground may rise in a metre (default 0.1)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--ground-height", options.ground_spec.height,
                 "metres above the ground that still count as ground (default 0.3)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--tolerance", options.tolerance,
                 "points this near to each other, metres, are one object (default 1)")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_option("--min-points", options.min_points, "drop objects of fewer points (default 1)")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--unknown", options.unknown,
                 "space that was not scanned: free (default) or blocked")
      ->check(CLI::IsMember({"free", "blocked"}));
  options.placement.add_to(app);
  options.skipped.add_to(app);
  options.map.add_to(app);
}

// What was found of units and of what is no point: says it, or refuses; the history of the map.
std::string settled_history(const Cloud& points, const Options& options,
                            const geom::MakeMapOptions& map, const std::string& name,
                            const cli::Common& common) {
  Report step = step_of(points.hash(), options, map);
  options.skipped.settle(points.skipped(), name, common, step);
  const std::string report = options.placement.report();
  if (!report.empty()) cli::tell(common, "skyway-cloud", name + ": " + report);
  if (options.format == "las" && points.says_nothing() && !options.placement.units_given()) {
    common.warn(name +
                ": the file does not say what its units are: taken as metres (--units says "
                "otherwise)");
  }
  return Report::array({step}).dump();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a point cloud to a box map.", "skyway-cloud"};
  cli::Common common(app);
  Options options;
  std::string input;
  std::string output = "-";
  app.add_option("file", input, "PCD, PLY, LAS, LAZ or XYZ; - for stdin")->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  add_options(app, options);
  cli::Sharding sharding;
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.columns.unknown_blocked = options.unknown == "blocked";
    if (options.columns.unknown_blocked && options.mode == "objects") {
      throw cli::UsageError("--unknown blocked goes with --mode columns");
    }
    const std::string name = input == "-" ? "stdin" : input;
    if (input == "-" && options.ground == "drop" && !options.in_memory()) {
      throw cli::UsageError("--ground drop reads the file twice: it cannot be stdin");
    }
    if (sharding.asked() && options.in_memory()) {
      throw cli::UsageError(
          "--outliers, --voxel and --mode objects look at all points together: no --shard");
    }
    sharding.begin(app, {{"file", input}}, {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    Cloud points(input, options);
    Report report;
    if (sharding.asked()) {
      const geom::ColumnGrid columns = stream(points, options, sharding.shard(), report);
      const geom::MakeMapOptions map = options.map.make();
      cli::write_shard(
          sharding, output, columns, options.columns,
          {options.placement.frame(), settled_history(points, options, map, name, common), map});
      common.write_stats(std::move(report));
      return cli::Exit::yes;
    }
    geom::BoxTable table = options.in_memory() ? filter(points, options, name, report)
                                               : stream(points, options, {}, report).boxes(name);
    std::string line;
    for (const auto& [what, count] : report.items()) {
      line += fmt::format("{}{}: {}", line.empty() ? "" : "; ", what, count.dump());
    }
    if (table.boxes.empty()) {
      throw geom::InputError(
          name, "expected at least one point to make boxes of, found none (" + line + ")");
    }
    cli::tell(common, "skyway-cloud", name + ": " + line);
    const geom::MakeMapOptions map = options.map.make();
    const std::string history = settled_history(points, options, map, name, common);
    const geom::MadeMap made =
        geom::make_map(std::move(table), options.placement.frame(), history, name, map);
    cli::write_map(common, output, made, name, report);
    return cli::Exit::yes;
  });
}
