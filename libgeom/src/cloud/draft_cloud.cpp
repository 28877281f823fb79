#include "geom/cloud/draft_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/unchanged_file.h"
#include "cloud_source.h"
#include "column_filler.h"
#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/cloud/clusters.h"
#include "geom/cloud/ground_filter.h"
#include "geom/cloud/pcl_filters.h"
#include "map/history_step.h"

namespace geom {
namespace {

// How many points each step dropped, in order, and how the ground was told.
struct Steps {
  std::vector<Fact> facts;
  std::string ground_by;

  void add(const char* what, std::size_t count) { facts.emplace_back(what, count); }
};

// `points` calls its argument for each point that the ground is told by.
template <class Points>
GroundFilter told_ground(const CloudDraftOptions& options, const Points& points, Steps& steps) {
  GroundFilter ground(options.ground, options.ground_by);
  points([&](const CloudPoint& p) { ground.add(p); });
  ground.finish();
  steps.ground_by = ground.by();
  if (options.ground_told) options.ground_told(steps.ground_by);
  return ground;
}

// Reads on, and fills the columns at the same time. Points that came before what is wrong with the
// file are looked at first, so that the first fault is told.
void fill(ColumnFiller& filler, CloudSource& source) {
  try {
    source.for_each_chunk([&](std::span<const CloudPoint> points) { filler.add(points); });
  } catch (...) {
    filler.finish();
    throw;
  }
  filler.finish();
}

ColumnGrid streamed(CloudSource& source, const CloudDraftOptions& options, const Execution& run,
                    Steps& steps) {
  const auto points = [&](const auto& add) {
    if (options.ground_by != "class") source.for_each(add);
  };
  const std::optional<GroundFilter> ground =
      options.drop_ground ? std::optional(told_ground(options, points, steps)) : std::nullopt;
  ColumnFiller filler(options, ground ? &*ground : nullptr, run);
  fill(filler, source);
  for (Fact& fact : source.facts()) steps.facts.push_back(std::move(fact));
  if (ground) steps.add("dropped_as_ground", filler.dropped());
  steps.add("kept", filler.kept());
  return filler.take_columns();
}

CloudPoints without_ground(const CloudPoints& points, const CloudDraftOptions& options,
                           Steps& steps) {
  const GroundFilter ground = told_ground(
      options, [&](const auto& add) { std::for_each(points.begin(), points.end(), add); }, steps);
  CloudPoints out;
  for (const CloudPoint& p : points) {
    if (!ground.is_ground(p)) out.push_back(p);
  }
  return out;
}

// A box an object, and none for objects of too few points.
BoxTable object_boxes(const CloudPoints& points, const CloudDraftOptions& options, Steps& steps) {
  BoxTable table;
  std::size_t dropped = 0;
  std::vector<Vec3> places;
  for (const CloudPoint& p : points) places.push_back(p.position);
  for (const auto& cluster : clusters(places, options.tolerance)) {
    if (cluster.size() < options.min_points) {
      dropped += cluster.size();
      continue;
    }
    Aabb box{points[cluster.front()].position, points[cluster.front()].position};
    for (const std::size_t i : cluster) box = merged(box, {points[i].position, points[i].position});
    table.add(box, table.boxes.size());
  }
  if (options.min_points > 1) steps.add("dropped_in_small_objects", dropped);
  steps.add("kept", points.size() - dropped);
  steps.add("objects", table.boxes.size());
  return table;
}

BoxTable filtered(CloudSource& source, const CloudDraftOptions& options, const std::string& name,
                  const Execution& run, Steps& steps) {
  CloudPoints points;
  source.for_each([&](const CloudPoint& p) { points.push_back(p); });
  steps.facts = source.facts();
  const auto apply = [&](const char* what, CloudPoints left) {
    steps.add(what, points.size() - left.size());
    points = std::move(left);
  };
  if (const auto& rule = options.outliers) {
    apply("dropped_as_outliers", without_outliers(points, rule->neighbours, rule->deviations));
  }
  if (options.voxel > 0) apply("dropped_by_voxel", one_per_voxel(points, options.voxel, name));
  if (options.drop_ground) apply("dropped_as_ground", without_ground(points, options, steps));
  if (options.objects) return object_boxes(points, options, steps);
  ColumnGrid columns(options.columns);
  std::vector<Vec3> places;
  for (const CloudPoint& p : points) places.push_back(p.position);
  columns.add(places, 0, run);
  steps.add("kept", points.size());
  return columns.boxes(name, run);
}

void add_ground(HistoryStep& step, const CloudDraftOptions& options, const std::string& by) {
  if (!options.drop_ground) return;
  step["ground_by"] = by;
  if (by != "shape") return;
  step["ground_cell"] = options.ground.cell;
  step["ground_slope"] = options.ground.slope;
  step["ground_height"] = options.ground.height;
  step["ground_step"] = options.ground.step;
  step["ground_widest"] = options.ground.widest;
}

void add_place(HistoryStep& step, const CloudPlaceOptions& options, const CloudPlace& place) {
  if (!options.crs.empty()) step["crs"] = options.crs;
  if (!place.projected_from().empty()) step["projected_from"] = place.projected_from();
  if (place.metres().x() != 1) step["units_m"] = place.metres().x();
  if (place.metres().z() != 1) step["vertical_units_m"] = place.metres().z();
  if (const auto& origin = place.origin()) {
    step["origin"] = {origin->latitude, origin->longitude, origin->height};
  }
}

HistoryStep step_of(const CloudSource& source, const CloudDraftOptions& options,
                    const std::string& ground_by) {
  HistoryStep step = {{"tool", "skyway-cloud"}};
  step.update(source.input());
  step.update({{"format", options.format->format->word},
               {"mode", options.objects ? "objects" : "columns"},
               {"cell", options.columns.cell},
               {"step", options.columns.step},
               {"gap", options.columns.gap},
               {"ground", options.drop_ground ? "drop" : "keep"},
               {"unknown", options.columns.unknown_blocked ? "blocked" : "free"}});
  if (options.resolution > 0) step["resolution"] = options.resolution;
  if (const auto& rule = options.outliers) {
    step["outliers"] = fmt::format("{},{}", rule->neighbours, rule->deviations);
  }
  if (options.voxel > 0) step["voxel"] = options.voxel;
  for (std::size_t cls = 0; cls < options.classes.size(); ++cls) {
    if (options.classes[cls]) step["classes"].push_back(cls);
  }
  if (options.drop_noise) step["noise"] = "drop";
  add_ground(step, options, ground_by);
  if (options.objects) {
    step["tolerance"] = options.tolerance;
    step["min_points"] = options.min_points;
  }
  add_place(step, options.place, source.place());
  add_options(step, options.map);
  return step;
}

// "points: 12; kept: 10".
std::string line_of(const std::vector<Fact>& facts) {
  std::string line;
  for (const auto& [what, value] : facts) {
    line += fmt::format("{}{}: {}", line.empty() ? "" : "; ", what, std::get<std::size_t>(value));
  }
  return line;
}

// What is known once all points are read: says it, or refuses.
MapDraft settled(const CloudSource& source, const CloudDraftOptions& options, Steps steps,
                 const std::string& name, const Notes& notes) {
  HistoryStep step = step_of(source, options, steps.ground_by);
  settle_skipped(source.skipped(), options.allow_skipped, name, notes, step);
  const std::string report = source.place().report();
  if (!report.empty()) notes.remark(name + ": " + report);
  if (options.format->is_surveyed && source.says_nothing() && !source.place().settled_by_user()) {
    notes.warning(name +
                  ": the file does not say what its units are: taken as metres (--units says "
                  "otherwise)");
  }
  MapDraft draft;
  draft.source = name;
  draft.frame = source.place().frame();
  draft.options = options.map;
  draft.history = history_of(step);
  draft.facts = std::move(steps.facts);
  return draft;
}

CloudDraftOptions settled(CloudDraftOptions options, const CloudFile& file) {
  if (options.resolution > 0 && !options.each_point_alone()) {
    throw UsageError(
        "--resolution leaves points out, so it does not go with what looks at all of them: "
        "--outliers, --voxel, --mode objects, --unknown blocked, --scale, --bloat-percent, and "
        "--ground-points drop unless by class");
  }
  if (file.first.head().empty()) throw InputError(file.name, {.says = "the file is empty"});
  if (!options.format) options.format = row_recognised(file.first.head(), cloud_formats());
  return options;
}

}  // namespace

bool CloudDraftOptions::each_point_alone() const {
  const bool whole_ground = drop_ground && ground_by != "class";
  return !in_memory() && !whole_ground && !columns.unknown_blocked && map.scale == 1 &&
         map.bloat_percent == 0;
}

MapDraft draft_cloud(const CloudFile& file, const CloudDraftOptions& asked, const Notes& notes,
                     const Execution& run) {
  const CloudDraftOptions options = settled(asked, file);
  const UnchangedFile same(file.name);  // parts of it, and all of it again, are read by its name
  CloudSource source(file, options, run);
  Steps steps;
  const Execution quiet{run.threads, {}};
  BoxTable table = options.in_memory()
                       ? filtered(source, options, file.name, quiet, steps)
                       : streamed(source, options, quiet, steps).boxes(file.name, quiet);
  same.require();
  const std::string line = line_of(steps.facts);
  if (table.boxes.empty()) {
    throw InputError(file.name, {.expected = "at least one point to make boxes of",
                                 .found = fmt::format("none ({})", line)});
  }
  notes.remark(file.name + ": " + line);
  MapDraft draft = settled(source, options, std::move(steps), file.name, notes);
  draft.table = std::move(table);
  return draft;
}

MapDraft draft_cloud(const std::string& path, const CloudDraftOptions& options, const Notes& notes,
                     const Execution& run) {
  std::optional<RandomFile> random;
  if (std::filesystem::is_regular_file(path)) random.emplace(path);
  const auto in = open_file(path);
  HashedStream first(*in);
  return draft_cloud({path, first, open_file, random ? &*random : nullptr}, options, notes, run);
}

}  // namespace geom
