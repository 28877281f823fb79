#include "geom/map/map_part.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/map/join.h"
#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;

Json to_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json to_json(const MapDraft& draft) {
  const MakeMapOptions& map = draft.options;
  Json out = {{"axes", name(draft.frame.axes)},     {"crs", draft.frame.crs},
              {"history", draft.history},           {"scale", map.scale},
              {"bloat_percent", map.bloat_percent}, {"inflate", map.inflate},
              {"pad", map.pad.value_or(0)},         {"seal", map.seal.value_or(0)},
              {"tile_size", map.tile_size}};
  if (const auto& at = draft.frame.origin) {
    out["origin"] = {at->latitude, at->longitude, at->height};
  }
  if (draft.table.labels.size() > 1) out["labels"] = draft.table.labels;
  if (map.bounds) out["bounds"] = {to_json(map.bounds->min), to_json(map.bounds->max)};
  if (map.floor) out["floor"] = *map.floor;
  if (map.headroom) out["headroom"] = *map.headroom;
  if (map.ceiling) out["ceiling"] = *map.ceiling;
  return out;
}

double number_of(const JsonFields& fields, const char* key) {
  const auto value = fields.number(key);
  if (!value) fields.refuse({.says = fmt::format("{} is missing", key)});
  return *value;
}

MapDraft read_draft(const JsonFields& fields) {
  MapDraft out;
  const auto axes = value_of(kAxesWords, fields.text("axes"));
  if (!axes) fields.refuse({.key = "axes", .expected = "\"enu\" or \"neu\""});
  out.frame = {*axes, std::nullopt, fields.text("crs")};
  if (fields.has("origin")) {
    const Vec3 at = fields.point("origin");
    out.frame.origin = GeodeticOrigin{at.x(), at.y(), at.z()};
  }
  out.history = fields.text("history");
  MakeMapOptions& map = out.options;
  map.scale = number_of(fields, "scale");
  map.bloat_percent = number_of(fields, "bloat_percent");
  map.inflate = number_of(fields, "inflate");
  map.pad = number_of(fields, "pad");
  map.seal = number_of(fields, "seal");
  map.tile_size = number_of(fields, "tile_size");
  map.floor = fields.number("floor");
  map.ceiling = fields.number("ceiling");
  map.headroom = fields.number("headroom");
  const bool sizes = map.scale > 0 && map.bloat_percent >= 0 && map.inflate >= 0 && *map.pad >= 0 &&
                     *map.seal >= 0 && map.headroom.value_or(0) >= 0 && map.tile_size >= 1;
  if (!sizes) {
    fields.refuse(
        {.expected =
             "scale > 0, tile_size >= 1, and bloat_percent, inflate, pad, headroom and seal >= 0",
         .found = "others",
         .advice = "the file is damaged"});
  }
  parse_json(out.history, "the map's history");
  if (fields.has("bounds")) {
    const auto corners = fields.points("bounds");
    if (corners.size() != 2 || !(corners[0].array() <= corners[1].array()).all()) {
      fields.refuse({.key = "bounds", .expected = "two points, the lower corner first"});
    }
    map.bounds = Aabb{corners[0], corners[1]};
  }
  return out;
}

// Those of all shards, "" first.
std::vector<std::string> read_labels(const JsonFields& fields) {
  if (!fields.has("labels")) return {""};
  std::vector<std::string> labels;
  for (const Json& one : fields.value("labels")) {
    if (!one.is_string()) fields.refuse({.key = "labels", .expected = "a list of words"});
    labels.push_back(one.get<std::string>());
  }
  if (labels.empty() || !labels.front().empty()) {
    fields.refuse({.key = "labels", .expected = "an empty word first"});
  }
  return labels;
}

BoxTable read_boxes(const ShardFile& shard, const std::vector<std::string>& labels) {
  const ArrayArchive& archive = shard.archive;
  const auto corners = archive.array<double>("boxes", 6);
  const auto ids = archive.array<std::uint64_t>("ids");
  const auto label = archive.array<std::uint32_t>("label");
  BoxTable table;
  table.labels = labels;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (corners.size() != 6 * ids.size() || label.size() != ids.size() ||
        label[i] >= labels.size()) {
      throw InputError(archive.name(), {.expected = "an id and a label for each box",
                                        .advice = "the file is damaged"});
    }
    const double* const c = &corners[6 * i];
    const Aabb box{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}};
    const bool finite = box.min.cwiseAbs().maxCoeff() <= kLargestCoordinate &&
                        box.max.cwiseAbs().maxCoeff() <= kLargestCoordinate;
    if (!finite || !(box.min.array() <= box.max.array()).all()) {
      throw InputError(
          archive.name(),
          {.expected = fmt::format("boxes with min <= max, within 1e8 m; box {} is not", i),
           .advice = "the file is damaged"});
    }
    table.boxes.push_back(box);
  }
  table.ids.assign(ids.begin(), ids.end());
  table.label.assign(label.begin(), label.end());
  return table;
}

void add_columns(const ShardFile& shard, ColumnGrid& grid) {
  const auto rows = shard.archive.array<std::int32_t>("spans", 4);
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    constexpr std::int32_t kMost = 1 << 30;  // well inside what sums may reach
    if (std::abs(std::int64_t{rows[i]}) > kMost || std::abs(std::int64_t{rows[i + 1]}) > kMost ||
        rows[i + 2] >= rows[i + 3]) {
      throw InputError(shard.archive.name(),
                       {.expected = fmt::format(
                            "spans with bottom < top, within 2^30 cells; span {} is not", i / 4),
                        .advice = "the file is damaged"});
    }
    grid.add_span(rows[i], rows[i + 1], rows[i + 2], rows[i + 3]);
  }
}

ColumnSpec read_spec(const JsonFields& fields) {
  const double unknown = number_of(fields, "unknown_blocked");
  const ColumnSpec spec{number_of(fields, "cell"), number_of(fields, "step"),
                        number_of(fields, "gap"), unknown == 1};
  const bool sizes = spec.cell > 0 && spec.step > 0 && spec.gap >= 0;
  if (!sizes || (unknown != 0 && unknown != 1))
    fields.refuse({.expected = "cell > 0, step > 0, gap >= 0 and unknown_blocked 0 or 1",
                   .found = "others",
                   .advice = "the file is damaged"});
  return spec;
}

}  // namespace

PartArrays arrays_of(const MapDraft& draft) {
  const auto corners = std::make_shared<std::vector<double>>();
  for (const Aabb& box : draft.table.boxes) {
    corners->insert(corners->end(), box.min.begin(), box.min.end());
    corners->insert(corners->end(), box.max.begin(), box.max.end());
  }
  return {to_json(draft).dump(),
          {named_array<double>("boxes", *corners, 6),
           named_array<std::uint64_t>("ids", draft.table.ids),
           named_array<std::uint32_t>("label", draft.table.label)},
          corners};
}

PartArrays arrays_of(const MapDraft& draft, const ColumnGrid& columns, const ColumnSpec& spec) {
  Json content = to_json(draft);
  content.update({{"cell", spec.cell},
                  {"step", spec.step},
                  {"gap", spec.gap},
                  {"unknown_blocked", spec.unknown_blocked ? 1 : 0}});
  const auto rows = std::make_shared<const std::vector<std::int32_t>>(columns.spans());
  return {content.dump(), {named_array<std::int32_t>("spans", *rows, 4)}, rows};
}

bool is_map_part(const ShardFile& shard) {
  return shard.kind == "boxes" || shard.kind == "columns";
}

MadeMap join_map(std::span<const ShardFile> shards) {
  const std::string& name = shards.front().archive.name();
  const JsonFields fields(shards.front().content, name, 0);
  MapDraft draft = read_draft(fields);
  draft.source = name;
  for (const ShardFile& shard : shards) {
    if (shard.content == shards.front().content) continue;
    throw InputError(shard.archive.name(),
                     {.expected = fmt::format("the same options of the map as in {}", name),
                      .found = "others",
                      .advice = "these are shards of different runs"});
  }
  BoxTable& table = draft.table;
  if (shards.front().kind == "boxes") {
    const std::vector<std::string> labels = read_labels(fields);
    for (const ShardFile& shard : shards) append(table, read_boxes(shard, labels));
  } else {
    ColumnGrid grid(read_spec(fields));
    for (const ShardFile& shard : shards) add_columns(shard, grid);
    table = grid.boxes(name);
  }
  if (table.boxes.empty())
    throw InputError(name, {.expected = "at least one box in all shards", .found = "none"});
  return make_map(std::move(draft));
}

}  // namespace geom
