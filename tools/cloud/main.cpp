// skyway-cloud: point clouds become box maps.

#include <fmt/format.h>

#include "cli/option/map_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/run.h"
#include "cli/shard/map_shard.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/cloud/clusters.h"
#include "geom/cloud/ground_filter.h"
#include "geom/cloud/pcl_filters.h"
#include "options.h"
#include "point_source.h"

namespace {

using cloud::Options;
using Points = geom::CloudPoints;
using cloud::PointSource;
using geom::CloudPoint;
using Report = nlohmann::ordered_json;  // how many points each step dropped, in order

// What is made of the points, and how their ground was told.
struct Made {
  Report report;
  std::string ground_by;
};

// Points by square places of 16 cells: a shard has a part of the columns, not of each.
bool takes(const geom::Shard& shard, const geom::Vec3& p, double cell) {
  const auto place = [&](double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / (16 * cell))));
  };
  return shard.takes(place(p.x()) + 31 * place(p.y()));
}

geom::ColumnGrid stream(PointSource& points, const Options& options, const geom::Shard& shard,
                        Made& made) {
  geom::GroundFilter ground(options.ground_spec, options.ground_by);
  if (options.drops_ground()) {
    if (options.ground_by != "class") points.for_each([&](const CloudPoint& p) { ground.add(p); });
    ground.finish();
    made.ground_by = ground.by();
    options.require_used_ground(made.ground_by);
  }
  geom::ColumnGrid columns(options.columns);
  std::size_t kept = 0;
  std::size_t dropped = 0;
  points.for_each([&](const CloudPoint& p) {
    if (shard.count > 1 && !takes(shard, p.position, options.columns.cell)) return;
    if (options.drops_ground() && ground.is_ground(p)) {
      ++dropped;
      return;
    }
    ++kept;
    columns.add(p.position, options.resolution);
  });
  points.report(made.report);
  if (options.drops_ground()) made.report["dropped_as_ground"] = dropped;
  made.report["kept"] = kept;
  return columns;
}

Points without_ground(const Points& points, const Options& options, Made& made) {
  geom::GroundFilter ground(options.ground_spec, options.ground_by);
  for (const CloudPoint& p : points) ground.add(p);
  ground.finish();
  made.ground_by = ground.by();
  options.require_used_ground(made.ground_by);
  Points out;
  for (const CloudPoint& p : points) {
    if (!ground.is_ground(p)) out.push_back(p);
  }
  return out;
}

// A box an object, and none for objects of too few points.
geom::BoxTable object_boxes(const Points& points, const Options& options, Report& report) {
  geom::BoxTable table;
  std::size_t dropped = 0;
  std::vector<geom::Vec3> places;
  for (const CloudPoint& p : points) places.push_back(p.position);
  for (const auto& cluster : geom::clusters(places, options.tolerance)) {
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

geom::BoxTable filter(PointSource& source, const Options& options, const std::string& name,
                      Made& made) {
  Report& report = made.report;
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
          geom::without_outliers(points, static_cast<int>(k), (*numbers)[1]));
  }
  if (options.voxel > 0)
    apply("dropped_by_voxel", geom::one_per_voxel(points, options.voxel, name));
  if (options.drops_ground()) {
    apply("dropped_as_ground", without_ground(points, options, made));
  }
  if (options.mode == "objects") return object_boxes(points, options, report);
  geom::ColumnGrid columns(options.columns);
  for (const CloudPoint& p : points) columns.add(p.position);
  report["kept"] = points.size();
  return columns.boxes(name);
}

// What was found of units and of what is no point: says it, or refuses; the history of the map.
std::string settled_history(const PointSource& points, const Options& options, const Made& made,
                            const geom::MakeMapOptions& map, const std::string& name,
                            const cli::Common& common) {
  Report step = cloud::step_of(options, points.input(), made.ground_by, map);
  options.skipped.settle(points.skipped(), name, common, step);
  const std::string report = options.placement.report();
  if (!report.empty()) cli::tell(common, "skyway-cloud", name + ": " + report);
  if (options.format->is_surveyed && points.says_nothing() &&
      !options.placement.settled_by_user()) {
    common.warn(name +
                ": the file does not say what its units are: taken as metres (--units says "
                "otherwise)");
  }
  return Report::array({step}).dump();
}

void refuse_what_needs_more(const std::string& input, const Options& options,
                            const cli::Sharding& sharding) {
  if (input == "-" && options.drops_ground() && options.ground_by != "class" &&
      !options.in_memory()) {
    throw cli::UsageError("--ground drop reads the file twice: it cannot be stdin");
  }
  if (sharding.asked() && options.in_memory()) {
    throw cli::UsageError(
        "--outliers, --voxel and --mode objects look at all points together: no --shard");
  }
}

std::string line_of(const Report& report) {
  std::string line;
  for (const auto& [what, count] : report.items()) {
    line += fmt::format("{}{}: {}", line.empty() ? "" : "; ", what, count.dump());
  }
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a point cloud to a box map.", "skyway-cloud"};
  cli::Common common(app, true);
  Options options;
  std::string input;
  std::string output = "-";
  app.add_option("file", input, "PCD, PLY, LAS, LAZ or XYZ; - for stdin")->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  options.add_to(app);
  cli::Sharding sharding;
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.settle();
    refuse_what_needs_more(input, options, sharding);
    const std::string name = input == "-" ? "stdin" : input;
    sharding.begin(app, {{"file", input}}, {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    PointSource points(input, options, common.execution("points"));
    Made made;
    if (sharding.asked()) {
      const geom::ColumnGrid columns = stream(points, options, sharding.shard(), made);
      const geom::MakeMapOptions map = options.map.make();
      const std::string history = settled_history(points, options, made, map, name, common);
      cli::write_shard(sharding, output, columns, options.columns,
                       {options.placement.frame(), history, map});
      common.write_stats(std::move(made.report));
      return cli::Exit::yes;
    }
    geom::BoxTable table = options.in_memory() ? filter(points, options, name, made)
                                               : stream(points, options, {}, made).boxes(name);
    const std::string line = line_of(made.report);
    if (table.boxes.empty()) {
      throw geom::InputError(name, {.expected = "at least one point to make boxes of",
                                    .found = fmt::format("none ({})", line)});
    }
    cli::tell(common, "skyway-cloud", name + ": " + line);
    const geom::MakeMapOptions map = options.map.make();
    const std::string history = settled_history(points, options, made, map, name, common);
    const geom::MadeMap map_made =
        geom::make_map(std::move(table), options.placement.frame(), history, name, map);
    cli::write_map(common, output, map_made, name, made.report);
    return cli::Exit::yes;
  });
}
