#include "plan/lattice/lattice_file.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

#include "block_store.h"
#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace plan {
namespace {

constexpr int kVersion = 2;

}  // namespace

LatticeMeta read_lattice_meta(const geom::JsonFields& fields) {
  if (fields.text("format", "") != "skyway-lattice") {
    fields.refuse({.expected = "a lattice (format \"skyway-lattice\")",
                   .found = fmt::format("format \"{}\"", fields.text("format", ""))});
  }
  if (fields.number("version") != kVersion) {
    fields.refuse({.expected = fmt::format("lattice version {}", kVersion),
                   .found = fmt::to_string(fields.number("version").value_or(0))});
  }
  LatticeMeta meta;
  meta.made_for = geom::read_provenance(fields);
  meta.grid.spec.spacing = fields.number("spacing").value_or(0);
  if (!(meta.grid.spec.spacing > 0)) fields.refuse({.key = "spacing", .expected = "> 0"});
  meta.grid.spec.origin = fields.point("origin");
  const double connectivity = fields.number("connectivity").value_or(0);
  if (connectivity != 6 && connectivity != 18 && connectivity != 26) {
    fields.refuse(
        {.key = "connectivity", .expected = "6, 18 or 26", .found = fmt::to_string(connectivity)});
  }
  meta.grid.spec.connectivity = static_cast<Connectivity>(static_cast<int>(connectivity));
  Vec3 first;  // not a point: with a small spacing the indices are larger than any coordinate
  const auto listed = fields.object().value("first", nlohmann::json());
  if (!listed.is_array() || listed.size() != 3)
    fields.refuse({.key = "first", .expected = "three whole numbers"});
  for (int k = 0; k < 3; ++k) first[k] = fields.number(listed[k], "first");
  const Vec3 dims = fields.point("dims");
  for (int k = 0; k < 3; ++k) {
    if (first[k] != std::floor(first[k]) || dims[k] != std::floor(dims[k]) ||
        std::abs(first[k]) > 0x1p52) {
      fields.refuse({.key = "first and dims", .expected = "whole numbers"});
    }
    meta.grid.first[k] = static_cast<std::int64_t>(first[k]);
    meta.grid.dims[k] = static_cast<std::int64_t>(dims[k]);
  }
  if (dims.minCoeff() < 1 || dims.x() * dims.y() * dims.z() > 0x1p40) {
    fields.refuse({.key = "dims", .expected = ">= 1 and make at most 2^40 nodes"});
  }
  const auto count = [&](const char* key) {
    const double value = fields.number(key).value_or(-1);
    if (!(value >= 0 && value <= 0x1p50))
      fields.refuse({.key = std::string(key), .expected = "a count"});
    return static_cast<std::size_t>(value);
  };
  meta.counts = {count("nodes"), count("edges")};
  return meta;
}

std::string lattice_meta(const LatticeMeta& lattice) {
  const auto& [grid, counts, made_for] = lattice;
  geom::JsonLine meta;
  meta.add("format", "skyway-lattice").add("version", kVersion);
  add(meta, made_for);
  meta.add("spacing", grid.spec.spacing).add("origin", grid.spec.origin);
  meta.add("connectivity", static_cast<int>(grid.spec.connectivity));
  meta.add("first", grid.first).add("dims", grid.dims);
  meta.add("nodes", counts.nodes).add("edges", counts.edges);
  return meta.object();
}

std::string lattice_meta(const Lattice& lattice) {
  return lattice_meta({lattice.grid(), stored_counts(lattice), lattice.made_for()});
}

std::vector<geom::NamedArray> lattice_arrays(const Lattice& lattice) {
  const auto* store = dynamic_cast<const BlockStore*>(&lattice.source());
  if (!store) throw std::logic_error("only a lattice that was built can be written");
  const StoredBlocks& blocks = store->blocks();
  return block_arrays(lattice.grid(), blocks.record, {blocks.records});
}

void write_lattice(std::ostream& out, const Lattice& lattice) {
  geom::write_array_archive(out, lattice_meta(lattice) + '\n', lattice_arrays(lattice));
}

void write_lattice(std::ostream& out, std::span<const LatticePart> parts) {
  const LatticeGrid& grid = parts.front().grid;
  JoinedTiles joined = join_tiles(grid, tiles_of(parts));
  const auto arrays = block_arrays(grid, joined.record, std::move(joined.records));
  const std::string meta = lattice_meta({grid, joined.counts, parts.front().made_for});
  geom::write_array_archive(out, meta + '\n', arrays);
}

bool is_lattice(const geom::ArrayArchive& archive) {
  const geom::JsonFields fields(archive.meta(), archive.name(), 0);
  return fields.text("format", "") == "skyway-lattice";
}

Lattice read_lattice(const geom::ArrayArchive& archive) {
  return read_lattice(archive, archive.meta());
}

Lattice read_lattice(const geom::ArrayArchive& archive, std::string_view meta_json) {
  const LatticeMeta meta = read_lattice_meta(geom::JsonFields(meta_json, archive.name(), 0));
  StoredBlocks blocks = read_blocks(archive, meta.grid, meta.counts);
  return Lattice(meta.grid, meta.made_for,
                 std::make_shared<const BlockStore>(meta.grid, std::move(blocks), archive.name()));
}

LatticeCounts stored_counts(const Lattice& lattice) {
  const auto* store = dynamic_cast<const BlockStore*>(&lattice.source());
  return store ? store->blocks().counts : lattice.counts();
}

void verify_lattice(const Lattice& lattice) {
  const auto* store = dynamic_cast<const BlockStore*>(&lattice.source());
  if (!store) return;
  store->check();
  const LatticeCounts said = store->blocks().counts;
  const LatticeCounts counts = lattice.counts();
  if (counts.nodes != said.nodes || counts.edges != said.edges) {
    throw geom::InputError(
        store->name(), {.expected = fmt::format("{} nodes and {} edges", said.nodes, said.edges),
                        .found = fmt::format("{} and {}", counts.nodes, counts.edges)});
  }
}

}  // namespace plan
