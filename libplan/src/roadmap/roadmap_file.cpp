#include "plan/roadmap/roadmap_file.h"

#include <fmt/format.h>

#include <ostream>
#include <tuple>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "roadmap_arrays.h"
#include "tile_reader.h"

namespace plan {
namespace {

constexpr int kVersion = 3;

}  // namespace

geom::JsonLine roadmap_meta(const Roadmap& roadmap) {
  const RoadmapSpec& spec = roadmap.spec;
  geom::JsonLine meta;
  meta.add("format", "skyway-roadmap").add("version", kVersion);
  add(meta, roadmap.made_for);
  meta.add("part", spec.part).add("reach", spec.reach);
  if (spec.region) meta.add("region", std::tuple(spec.region->min, spec.region->max));
  return meta;
}

void write_roadmap(std::ostream& out, std::span<const Roadmap> parts) {
  for (const Roadmap& part : parts) {
    if (roadmap_meta(part).object() == roadmap_meta(parts.front()).object()) continue;
    throw geom::InputError(part.source, {.expected = "a part of the same roadmap as the first",
                                         .found = "one of another"});
  }
  const TileArrays tiles(parts);
  geom::JsonLine meta = roadmap_meta(parts.front());
  meta.add("bends", tiles.bends()).add("edges", tiles.edges() / 2);
  std::vector<geom::NamedArray> arrays;
  tiles.append_to(arrays);
  geom::write_array_archive(out, meta.line(), arrays);
}

void write_roadmap(std::ostream& out, const Roadmap& roadmap) {
  write_roadmap(out, std::span(&roadmap, 1));
}

bool is_roadmap(const geom::ArrayArchive& archive) {
  const geom::JsonFields fields(archive.meta(), archive.name(), 0);
  return fields.text("format", "") == "skyway-roadmap";
}

RoadmapSpec read_roadmap_spec(const geom::JsonFields& fields) {
  if (fields.text("format", "") != "skyway-roadmap") {
    fields.refuse({.expected = "a roadmap (format \"skyway-roadmap\")",
                   .found = fmt::format("format \"{}\"", fields.text("format", ""))});
  }
  const double version = fields.number("version").value_or(0);
  if (version != kVersion) {
    fields.refuse({.expected = fmt::format("roadmap version {}", kVersion),
                   .found = fmt::to_string(version),
                   .advice = "make the roadmap again"});
  }
  RoadmapSpec spec{fields.number("part").value_or(0), fields.number("reach").value_or(0), {}};
  if (fields.has("region")) {
    const std::vector<Vec3> corners = fields.points("region");
    if (corners.size() != 2 || !(corners[0].array() <= corners[1].array()).all()) {
      fields.refuse({.key = "region", .expected = "two points, the lower corner first"});
    }
    spec.region = geom::Aabb{corners[0], corners[1]};
  }
  return spec;
}

Roadmap read_roadmap(const geom::ArrayArchive& archive) {
  const geom::JsonFields fields(archive.meta(), archive.name(), 0);
  const RoadmapSpec spec = read_roadmap_spec(fields);
  Roadmap out = open_tiles(archive);
  out.spec = spec;
  out.made_for = geom::read_provenance(fields);
  return out;
}

void verify_roadmap(const Roadmap& roadmap) {
  const TileArrays tiles({&roadmap, 1});
  const TileReader reader(roadmap);
  for (std::size_t t = 0; t < roadmap.tiles(); ++t) {
    reader.extent(t);
    const TileReader::Range bends = reader.bends(t);
    for (std::size_t i = bends.begin; i < bends.end; ++i) {
      reader.bend(i);
      reader.split_of(t, i);
      for (const std::uint32_t edge : reader.edges_of(t, i)) reader.target(t, edge);
    }
  }
}

}  // namespace plan
