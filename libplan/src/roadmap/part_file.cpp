#include "plan/roadmap/part_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "roadmap_arrays.h"

namespace plan {
namespace {

std::size_t count_of(const geom::JsonFields& fields, const char* key) {
  const double value = fields.number(key).value_or(-1);
  if (!(value >= 0 && value <= 0xffffffff)) fields.refuse(fmt::format("{} must be a count", key));
  return static_cast<std::size_t>(value);
}

EdgeLists read_edges(const geom::ArrayArchive& archive, std::size_t bends) {
  EdgeLists edges{archive.array<std::uint64_t>("edge_first"),
                  archive.array<std::uint32_t>("edge_to"), archive.keep_alive()};
  const auto first = edges.first;
  if (first.size() != bends + 1 || first[0] != 0 || first[bends] != edges.to.size()) {
    throw geom::InputError(archive.name(), "the arrays of bends and edges do not fit each other");
  }
  for (std::size_t i = 0; i < bends; ++i) {
    if (first[i] > first[i + 1]) {
      throw geom::InputError(
          archive.name(),
          fmt::format("bend {} has a range of edges that is impossible: the file is damaged", i));
    }
  }
  return edges;
}

std::vector<std::uint32_t> copy(std::span<const std::uint32_t> values) {
  return {values.begin(), values.end()};
}

}  // namespace

PartArrays arrays_of(const RoadmapPart& part) {
  const auto bends = std::make_shared<const BendArrays>(part.bends);
  PartArrays out;
  geom::JsonLine meta = roadmap_meta(part.spec, part.made_for);
  meta.add("boxes", part.boxes);
  bends->append_to(out.arrays);
  out.arrays.push_back(geom::named_array<std::uint32_t>("box_bends", part.bends_of));
  out.arrays.push_back(geom::named_array<std::uint32_t>("near_box", part.near_box));
  out.arrays.push_back(geom::named_array<std::uint32_t>("near_bends", part.near_bends));
  out.arrays.push_back(geom::named_array<std::uint64_t>("edge_first", part.edges.first));
  out.arrays.push_back(geom::named_array<std::uint32_t>("edge_to", part.edges.to));
  if (part.coarse) {
    PartArrays coarse = arrays_of(*part.coarse);
    meta.add_json("lattice", coarse.meta);
    for (auto& array : coarse.arrays) out.arrays.push_back(std::move(array));
  }
  out.meta = meta.object();
  out.keep_alive = bends;
  return out;
}

RoadmapPart read_roadmap_part(const geom::ArrayArchive& archive, std::string_view meta_json,
                              const geom::Shard& shard) {
  const geom::JsonFields fields(meta_json, archive.name(), 0);
  RoadmapPart part;
  part.spec = read_roadmap_spec(fields);
  part.made_for = geom::read_provenance(fields);
  part.shard = shard;
  part.boxes = count_of(fields, "boxes");
  part.bends = read_bends(archive);
  part.bends_of = copy(archive.array<std::uint32_t>("box_bends"));
  part.near_box = copy(archive.array<std::uint32_t>("near_box"));
  part.near_bends = copy(archive.array<std::uint32_t>("near_bends"));
  if (part.near_box.size() != part.near_bends.size()) {
    throw geom::InputError(archive.name(), "near_box and near_bends are not of one length");
  }
  part.edges = read_edges(archive, part.bends.size());
  if (fields.has("lattice")) {
    part.coarse = read_lattice_part(archive, fields.value("lattice").dump(), shard);
  }
  return part;
}

}  // namespace plan
