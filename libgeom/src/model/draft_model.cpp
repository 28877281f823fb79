#include "geom/model/draft_model.h"

#include <fmt/format.h>

#include <iterator>

#include "geom/base/error.h"
#include "geom/model/model_polygons.h"
#include "geom/text/counted.h"
#include "map/history_step.h"

namespace geom {
namespace {

// What the model's coordinates are in the map.
struct Place {
  Frame frame;
  double unit = 1;  // metres
  double off = 0;   // metres that the map's triangles may be beside the model's flat ones
};

Place earth_place(Model& model, const ModelDraftOptions& options, const std::string& source) {
  const PlacedModel placed = place_on_map(model, options.origin, source);
  return {placed.frame, 1, placed.bend + 2 * model.blur};
}

// What nothing says of the model's axes and unit.
void tell_assumed(const ModelSource& source, const ModelDraftOptions& options,
                  const std::string& name, const Notes& notes) {
  std::string assumed;
  if (!options.up && !source.model.up) assumed = "z is up (--up y says otherwise)";
  if (!options.unit && !source.model.unit) {
    assumed += std::string(assumed.empty() ? "" : ", and ") +
               "its numbers are metres (--units says otherwise)";
  }
  if (!assumed.empty()) {
    notes.remark(name + ": the file does not say so, and it is taken that " + assumed);
  }
  const double told = source.model.unit.value_or(1);
  if (!options.unit && told != 1) {
    notes.remark(
        fmt::format("{}: converted to metres from units of {} m, as the file says", name, told));
  }
  if (source.tiles) {
    notes.remark(name + ": the tiles are not on Earth: x is taken as east, y as north");
  }
}

// Local coordinates, by what the file and the options say.
Place local_place(Model& model, const ModelDraftOptions& options) {
  Place place;
  place.frame.origin = options.origin;
  place.unit = options.unit.value_or(model.unit.value_or(1));
  place.off = model.blur * place.unit * options.map.scale;
  if (options.up.value_or(model.up.value_or(UpAxis::z)) == UpAxis::y) {
    for (Vec3& v : model.mesh.vertices) v = z_up_of_y_up(v);
  }
  return place;
}

// Boxes in the units of the model.
TriangleCover covered(const Model& model, const ModelDraftOptions& options, const Place& place,
                      const std::string& source, const Execution& run) {
  const double scale = options.map.scale * place.unit;
  TriangleCoverOptions cover;
  cover.fill = options.solid ? SolidFill::inside : SolidFill::none;
  // A vertex may be off by so much along each axis, and boxes grow by as much: so far over a
  // corner.
  const double grown = 2 * 1.7321 * place.off;
  cover.slack = (options.slack - grown) / scale;
  if (grown > options.slack / 2) {
    throw InputError(source,
                     {.says = fmt::format("its triangles are known to {:.3g} m only, once they are "
                                          "projected on a map and rounded",
                                          place.off),
                      .advice = fmt::format("give a slack of at least {:.3g} m", 2.01 * grown)});
  }
  TriangleCover made;
  try {
    made = cover_model(model, cover, run);
  } catch (const InputError& error) {
    throw InputError(source, error.as_item());
  }
  if (place.off > 0) {
    const Vec3 by = Vec3::Constant(place.off / scale);
    for (Aabb& box : made.boxes) box = grow(box, by);
  }
  return made;
}

BoxTable table_of(TriangleCover made, const std::vector<std::string>& parts) {
  BoxTable table;
  std::vector<std::uint32_t> label;
  for (const std::string& part : parts) label.push_back(table.label_of(part));
  table.boxes = std::move(made.boxes);
  for (const std::uint32_t part : made.part) {
    table.ids.push_back(part + 1u);
    table.label.push_back(label.at(part));
  }
  return table;
}

std::vector<Fact> facts_of(const ModelSource& source, const TriangleCover& made, bool solid) {
  const Model& model = source.model;
  std::vector<Fact> facts = {{"format", std::string(source.format->format->word)},
                             {"files", source.files},
                             {"triangles", model.mesh.triangles.size()},
                             {"parts", model.parts.size()}};
  if (source.tiles) {
    facts.emplace_back("tiles_read", *source.tiles);
    facts.emplace_back("coarser_contents", source.coarser);
  }
  if (model.bent > 0) facts.emplace_back("bent_polygons", model.bent);
  if (solid) {
    facts.emplace_back("closed_surfaces", made.closed);
    facts.emplace_back("open_surfaces", made.open);
  }
  if (!model.skipped.empty()) facts.emplace_back("skipped", model.skipped.count());
  return facts;
}

std::string in_words(const ModelSource& source, const TriangleCover& made, bool solid) {
  std::string line = counted(source.model.mesh.triangles.size(), "triangle", "triangles");
  if (source.tiles) {
    line += " of " + counted(*source.tiles, "tile", "tiles");
    if (source.coarser > 0) line += fmt::format(", {} coarser ones left out", source.coarser);
  }
  line += ", " + counted(made.boxes.size(), "box", "boxes");
  if (source.model.bent > 0) {
    line += fmt::format("; {} bent, and solid between the ways to cut {} into triangles",
                        counted(source.model.bent, "polygon is", "polygons are"),
                        source.model.bent == 1 ? "it" : "them");
  }
  if (solid) {
    line += fmt::format("; filled: {}", counted(made.closed, "surface", "surfaces"));
    if (made.open > 0) line += fmt::format("; not closed, a shell only: {}", made.open);
  }
  return line;
}

HistoryStep step_of(const ModelSource& source, const ModelDraftOptions& options, double unit) {
  HistoryStep step = {{"tool", "skyway-mesh"},
                      {"input", source.hash},
                      {"format", source.format->format->word},
                      {"slack", options.slack},
                      {"solid", options.solid}};
  if (unit != 1) step["units_m"] = unit;
  if (options.up) step["up"] = *options.up == UpAxis::y ? "y" : "z";
  if (const auto& at = options.origin) step["origin"] = {at->latitude, at->longitude, at->height};
  add_options(step, options.map);
  return step;
}

void require_triangles(const Model& model, const std::string& source) {
  if (!model.mesh.triangles.empty()) return;
  throw InputError(source,
                   {.expected = "triangles", .found = "none", .advice = model.skipped.text()});
}

}  // namespace

MapDraft draft_model(ModelSource model, const std::string& source, const ModelDraftOptions& options,
                     const Notes& notes, const Execution& run) {
  require_triangles(model.model, source);
  const Place place = model.on_earth ? earth_place(model.model, options, source)
                                     : local_place(model.model, options);
  if (!model.on_earth) tell_assumed(model, options, source, notes);
  HistoryStep step = step_of(model, options, place.unit);
  settle_skipped(model.model.skipped, options.allow_skipped, source, notes, step);
  MapDraft draft;
  draft.source = source;
  draft.frame = place.frame;
  draft.options = options.map;
  draft.options.scale *= place.unit;
  TriangleCover made = covered(model.model, options, place, source, run);
  draft.facts = facts_of(model, made, options.solid);
  notes.remark(source + ": " + in_words(model, made, options.solid));
  draft.history = history_of(step);
  draft.table = table_of(std::move(made), model.model.parts);
  return draft;
}

MapDraft draft_model(const std::string& path, const ModelDraftOptions& options, const Notes& notes,
                     const Execution& run, const OpenFile& open) {
  const auto bytes = [&](const std::string& file) {
    const auto in = open(file);
    return std::string(std::istreambuf_iterator<char>(*in), {});
  };
  return draft_model(read_model(path, nullptr, bytes), path, options, notes, run);
}

}  // namespace geom
