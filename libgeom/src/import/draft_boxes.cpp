#include "geom/import/draft_boxes.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/import/sdf_model_files.h"
#include "geom/text/counted.h"
#include "map/history_step.h"

namespace geom {
namespace {

ImportedBoxes imported(HashedStream& file, const std::string& source, const BoxFormat& format,
                       const BoxDraftOptions& options, SdfModelFiles& models,
                       const Execution& run) {
  ImportOptions read{options.unknown_blocked, {}, run, options.bytes};
  read.sdf.slack = options.slack;
  read.sdf.visuals = options.visuals;
  read.sdf.without = {options.without.begin(), options.without.end()};
  read.sdf.read_collada = options.read_collada;
  models.serve(read.sdf);
  ImportedBoxes boxes = format.read(file.stream(), source, read);
  for (const std::string& model : options.without) {
    if (boxes.left_out.contains(model)) continue;
    throw InputError(source, {.expected = "a model of the name that --without gives",
                              .found = fmt::format("none: \"{}\"", model)});
  }
  if (options.axes) boxes.frame.axes = *options.axes;
  return boxes;
}

void tell(const ImportedBoxes& boxes, bool unknown_blocked, const std::string& source,
          const Notes& notes) {
  for (const std::string& key : boxes.names) {
    notes.warning(source + ": an unknown key is ignored: " + key);
  }
  if (boxes.unknown > 0 && !unknown_blocked) {
    notes.warning(
        fmt::format("{}: {} within the bounds never seen; this counts as free (--unknown blocked "
                    "makes it obstacles)",
                    source, counted(boxes.unknown, "cell was", "cells were")));
  }
  if (boxes.reversed > 0) {
    notes.warning(
        fmt::format("{}: {} the upper corner first; taken as the box between both corners", source,
                    counted(boxes.reversed, "box has", "boxes have")));
  }
  if (boxes.flat > 0) {
    notes.remark(
        fmt::format("{}: {} kept", source, counted(boxes.flat, "flat box is", "flat boxes are")));
  }
  if (boxes.movable > 0) {
    notes.remark(fmt::format("{}: {} not static, and taken where the file puts {}", source,
                             counted(boxes.movable, "model is", "models are"),
                             boxes.movable == 1 ? "it" : "them"));
  }
}

// Of what was imported, the map that the options ask for.
MakeMapOptions map_options(const BoxDraftOptions& options, const ImportedBoxes& boxes) {
  MakeMapOptions map = options.map;
  map.scale *= options.unit;
  map.source_bounds = boxes.bounds;
  if (!map.floor) map.floor = boxes.floor;
  if (!map.seal) map.seal = boxes.seal;
  return map;
}

HistoryStep step_of(const std::string& hash, const BoxFormat& format,
                    const BoxDraftOptions& options, const MakeMapOptions& map) {
  HistoryStep step = {{"tool", "skyway-import"}, {"input", hash}, {"format", format.format->word}};
  add_options(step, map);
  if (format.has_unknown) step["unknown"] = options.unknown_blocked ? "blocked" : "free";
  if (&format == &kGazeboWorld) {
    step["slack"] = options.slack;
    if (!options.visuals) step["collisions_only"] = true;
    if (!options.without.empty()) step["without"] = options.without;
  }
  return step;
}

std::vector<Fact> facts_of(const ImportedBoxes& boxes, const BoxFormat& format) {
  std::vector<Fact> facts = {{"format", std::string(format.format->word)},
                             {"flat", boxes.flat},
                             {"largest_change_m", boxes.largest_change}};
  if (!boxes.skipped.empty()) facts.emplace_back("skipped", boxes.skipped.count());
  if (&format == &kGazeboWorld) facts.emplace_back("movable", boxes.movable);
  return facts;
}

}  // namespace

MapDraft draft_boxes(HashedStream& file, const std::string& source, const BoxDraftOptions& options,
                     const Notes& notes, const Execution& run) {
  const BoxFormat& format = options.format ? *options.format : box_format_of(file.head(), source);
  SdfModelFiles models(options.model_path, options.open);
  ImportedBoxes boxes = imported(file, source, format, options, models, run);
  tell(boxes, options.unknown_blocked, source, notes);
  if (boxes.bounds && options.map.pad) {
    throw UsageError(
        "--pad is only for files without bounds of their own (--floor, --ceiling and --bounds "
        "change them): it would change nothing here, so leave it out");
  }
  MapDraft draft;
  draft.options = map_options(options, boxes);
  HistoryStep step = step_of(file.hash(), format, options, draft.options);
  if (!models.hashes().empty()) step["includes"] = models.hashes();
  settle_skipped(boxes.skipped, options.allow_skipped, source, notes, step);
  draft.source = source;
  draft.frame = boxes.frame;
  draft.history = history_of(step);
  draft.facts = facts_of(boxes, format);
  draft.table = std::move(boxes.table);
  return draft;
}

MapDraft draft_boxes(const std::string& path, const BoxDraftOptions& options, const Notes& notes,
                     const Execution& run) {
  const auto in = options.open(path);
  HashedStream file(*in);
  return draft_boxes(file, path, options, notes, run);
}

}  // namespace geom
