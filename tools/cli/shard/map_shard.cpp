#include "map_shard.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/map/join.h"
#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"

namespace cli {
namespace {

using Json = nlohmann::json;

Json to_json(const geom::Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json to_json(const MapMaking& making) {
  const geom::MakeMapOptions& map = making.options;
  Json out = {{"axes", geom::name(making.frame.axes)},
              {"crs", making.frame.crs},
              {"history", making.history},
              {"scale", map.scale},
              {"bloat_percent", map.bloat_percent},
              {"inflate", map.inflate},
              {"pad", map.pad},
              {"seal", map.seal.value_or(0)},
              {"tile_size", map.tile_size}};
  if (const auto& at = making.frame.origin) {
    out["origin"] = {at->latitude, at->longitude, at->height};
  }
  if (map.bounds) out["bounds"] = {to_json(map.bounds->min), to_json(map.bounds->max)};
  if (map.floor) out["floor"] = *map.floor;
  if (map.ceiling) out["ceiling"] = *map.ceiling;
  return out;
}

double number_of(const geom::JsonFields& fields, const char* key) {
  const auto value = fields.number(key);
  if (!value) fields.refuse({.says = fmt::format("{} is missing", key)});
  return *value;
}

MapMaking read_making(const geom::JsonFields& fields) {
  MapMaking out;
  const auto axes = geom::axes_from_name(fields.text("axes"));
  if (!axes) fields.refuse({.key = "axes", .expected = "\"enu\" or \"neu\""});
  out.frame = {*axes, std::nullopt, fields.text("crs")};
  if (fields.has("origin")) {
    const geom::Vec3 at = fields.point("origin");
    out.frame.origin = geom::GeodeticOrigin{at.x(), at.y(), at.z()};
  }
  out.history = fields.text("history");
  geom::MakeMapOptions& map = out.options;
  map.scale = number_of(fields, "scale");
  map.bloat_percent = number_of(fields, "bloat_percent");
  map.inflate = number_of(fields, "inflate");
  map.pad = number_of(fields, "pad");
  map.seal = number_of(fields, "seal");
  map.tile_size = number_of(fields, "tile_size");
  map.floor = fields.number("floor");
  map.ceiling = fields.number("ceiling");
  const bool sizes = map.scale > 0 && map.bloat_percent >= 0 && map.inflate >= 0 && map.pad >= 0 &&
                     *map.seal >= 0 && map.tile_size >= 1;
  if (!sizes) {
    fields.refuse(
        {.expected = "scale > 0, tile_size >= 1, and bloat_percent, inflate, pad and seal >= 0",
         .found = "others",
         .advice = "the file is damaged"});
  }
  geom::parse_json(out.history, "the map's history");
  if (fields.has("bounds")) {
    const auto corners = fields.points("bounds");
    if (corners.size() != 2 || !(corners[0].array() <= corners[1].array()).all()) {
      fields.refuse({.key = "bounds", .expected = "two points, the lower corner first"});
    }
    map.bounds = geom::Aabb{corners[0], corners[1]};
  }
  return out;
}

geom::BoxTable read_boxes(const ShardFile& shard) {
  const geom::ArrayArchive& archive = shard.archive;
  const auto corners = archive.array<double>("boxes", 6);
  const auto ids = archive.array<std::uint64_t>("ids");
  geom::BoxTable table;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (corners.size() != 6 * ids.size()) {
      throw geom::InputError(archive.name(),
                             {.expected = "as many ids as boxes", .advice = "the file is damaged"});
    }
    const double* const c = &corners[6 * i];
    const geom::Aabb box{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}};
    const bool finite = box.min.cwiseAbs().maxCoeff() <= geom::kLargestCoordinate &&
                        box.max.cwiseAbs().maxCoeff() <= geom::kLargestCoordinate;
    if (!finite || !(box.min.array() <= box.max.array()).all()) {
      throw geom::InputError(
          archive.name(),
          {.expected = fmt::format("boxes with min <= max, within 1e8 m; box {} is not", i),
           .advice = "the file is damaged"});
    }
    table.boxes.push_back(box);
  }
  table.ids.assign(ids.begin(), ids.end());
  table.label.resize(ids.size(), 0);
  return table;
}

void add_columns(const ShardFile& shard, geom::ColumnGrid& grid) {
  const auto rows = shard.archive.array<std::int32_t>("spans", 4);
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    constexpr std::int32_t kMost = 1 << 30;  // well inside what sums may reach
    if (std::abs(std::int64_t{rows[i]}) > kMost || std::abs(std::int64_t{rows[i + 1]}) > kMost ||
        rows[i + 2] >= rows[i + 3]) {
      throw geom::InputError(
          shard.archive.name(),
          {.expected =
               fmt::format("spans with bottom < top, within 2^30 cells; span {} is not", i / 4),
           .advice = "the file is damaged"});
    }
    grid.add_span(rows[i], rows[i + 1], rows[i + 2], rows[i + 3]);
  }
}

geom::ColumnSpec read_spec(const geom::JsonFields& fields) {
  const double unknown = number_of(fields, "unknown_blocked");
  const geom::ColumnSpec spec{number_of(fields, "cell"), number_of(fields, "step"),
                              number_of(fields, "gap"), unknown == 1};
  const bool sizes = spec.cell > 0 && spec.step > 0 && spec.gap >= 0;
  if (!sizes || (unknown != 0 && unknown != 1))
    fields.refuse({.expected = "cell > 0, step > 0, gap >= 0 and unknown_blocked 0 or 1",
                   .found = "others",
                   .advice = "the file is damaged"});
  return spec;
}

}  // namespace

void write_shard(const Sharding& sharding, const std::string& file, const geom::BoxTable& table,
                 const MapMaking& making) {
  std::vector<double> corners;
  for (const geom::Aabb& box : table.boxes) {
    corners.insert(corners.end(), box.min.begin(), box.min.end());
    corners.insert(corners.end(), box.max.begin(), box.max.end());
  }
  const geom::NamedArray arrays[] = {geom::named_array<double>("boxes", corners, 6),
                                     geom::named_array<std::uint64_t>("ids", table.ids)};
  sharding.write(file, "output", "boxes", to_json(making).dump(), arrays, Exit::yes);
}

void write_shard(const Sharding& sharding, const std::string& file, const geom::ColumnGrid& columns,
                 const geom::ColumnSpec& spec, const MapMaking& making) {
  Json content = to_json(making);
  content.update({{"cell", spec.cell},
                  {"step", spec.step},
                  {"gap", spec.gap},
                  {"unknown_blocked", spec.unknown_blocked ? 1 : 0}});
  const std::vector<std::int32_t> rows = columns.spans();
  const geom::NamedArray arrays[] = {geom::named_array<std::int32_t>("spans", rows, 4)};
  sharding.write(file, "output", "columns", content.dump(), arrays, Exit::yes);
}

bool is_map_shard(const ShardFile& shard) {
  return shard.kind == "boxes" || shard.kind == "columns";
}

geom::MadeMap join_map(std::span<const ShardFile> shards) {
  const std::string& name = shards.front().archive.name();
  const geom::JsonFields fields(shards.front().content.dump(), name, 0);
  MapMaking making = read_making(fields);
  for (const ShardFile& shard : shards) {
    if (shard.content == shards.front().content) continue;
    throw geom::InputError(shard.archive.name(),
                           {.expected = fmt::format("the same options of the map as in {}", name),
                            .found = "others",
                            .advice = "these are shards of different runs"});
  }
  geom::BoxTable table;
  if (shards.front().kind == "boxes") {
    for (const ShardFile& shard : shards) geom::append(table, read_boxes(shard));
  } else {
    geom::ColumnGrid grid(read_spec(fields));
    for (const ShardFile& shard : shards) add_columns(shard, grid);
    table = grid.boxes(name);
  }
  if (table.boxes.empty())
    throw geom::InputError(name, {.expected = "at least one box in all shards", .found = "none"});
  return geom::make_map(std::move(table), making.frame, making.history, name, making.options);
}

}  // namespace cli
