#include "plan/roadmap/roadmap_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <tuple>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "plan/lattice/lattice_file.h"
#include "roadmap_arrays.h"

namespace plan {
namespace {

constexpr int kVersion = 2;

}  // namespace

BendArrays::BendArrays(const std::vector<Bend>& bends) {
  for (const Bend& bend : bends) {
    position_.insert(position_.end(), bend.position.begin(), bend.position.end());
    axis_.push_back(bend.axis);
    outward_.insert(outward_.end(), bend.outward.begin(), bend.outward.end());
  }
}

void BendArrays::append_to(std::vector<geom::NamedArray>& arrays) const {
  arrays.push_back(geom::named_array<double>("bend_position", position_, 3));
  arrays.push_back(geom::named_array<std::int8_t>("bend_axis", axis_));
  arrays.push_back(geom::named_array<std::int8_t>("bend_outward", outward_, 2));
}

geom::JsonLine roadmap_meta(const RoadmapSpec& spec, const geom::Provenance& made_for) {
  geom::JsonLine meta;
  meta.add("format", "skyway-roadmap").add("version", kVersion);
  add(meta, made_for);
  meta.add("part", spec.part).add("reach", spec.reach);
  if (spec.region) meta.add("region", std::tuple(spec.region->min, spec.region->max));
  return meta;
}

void write_roadmap(std::ostream& out, const Roadmap& roadmap) {
  geom::JsonLine meta = roadmap_meta(roadmap.spec, roadmap.made_for);
  meta.add("bends", roadmap.bends.size()).add("edges", roadmap.to.size() / 2);
  const BendArrays bends(roadmap.bends);
  std::vector<geom::NamedArray> arrays;
  bends.append_to(arrays);
  arrays.push_back(geom::named_array<std::uint64_t>("edge_first", roadmap.first));
  arrays.push_back(geom::named_array<std::uint32_t>("edge_split", roadmap.split));
  arrays.push_back(geom::named_array<std::uint32_t>("edge_to", roadmap.to));
  if (roadmap.coarse) {
    meta.add_json("lattice", lattice_meta(roadmap.coarse->lattice));
    for (auto& array : lattice_arrays(roadmap.coarse->lattice)) arrays.push_back(std::move(array));
    arrays.push_back(geom::named_array<std::uint32_t>("node_label", roadmap.coarse->label));
  }
  geom::write_array_archive(out, meta.line(), arrays);
}

bool is_roadmap(const geom::ArrayArchive& archive) {
  const geom::JsonFields fields(archive.meta(), archive.name(), 0);
  return fields.text("format", "") == "skyway-roadmap";
}

RoadmapSpec read_roadmap_spec(const geom::JsonFields& fields) {
  if (fields.text("format", "") != "skyway-roadmap") {
    fields.refuse(fmt::format("expected a roadmap (format \"skyway-roadmap\"), found format \"{}\"",
                              fields.text("format", "")));
  }
  if (fields.number("version") != kVersion) {
    fields.refuse(fmt::format("expected roadmap version {}, found {}", kVersion,
                              fields.number("version").value_or(0)));
  }
  RoadmapSpec spec{fields.number("part").value_or(0), fields.number("reach").value_or(0), {}};
  if (fields.has("region")) {
    const std::vector<Vec3> corners = fields.points("region");
    if (corners.size() != 2 || !(corners[0].array() <= corners[1].array()).all()) {
      fields.refuse("region must be two points, the lower corner first");
    }
    spec.region = geom::Aabb{corners[0], corners[1]};
  }
  return spec;
}

std::vector<Bend> read_bends(const geom::ArrayArchive& archive) {
  const auto position = archive.array<double>("bend_position", 3);
  const auto axis = archive.array<std::int8_t>("bend_axis");
  const auto outward = archive.array<std::int8_t>("bend_outward", 2);
  const std::size_t n = axis.size();
  if (position.size() != 3 * n || outward.size() != 2 * n || n > 0x7fffffff) {
    throw geom::InputError(archive.name(), "the arrays of bends do not fit each other");
  }
  std::vector<Bend> bends;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p(position[3 * i], position[3 * i + 1], position[3 * i + 2]);
    const bool signs = std::abs(outward[2 * i]) == 1 && std::abs(outward[2 * i + 1]) == 1;
    if (!(p.cwiseAbs().maxCoeff() <= geom::kLargestCoordinate) || axis[i] < 0 || axis[i] > 2 ||
        !signs) {
      throw geom::InputError(
          archive.name(),
          fmt::format(
              "bend {} has a position, axis or sign that is impossible: the file is damaged", i));
    }
    bends.push_back({p, axis[i], {outward[2 * i], outward[2 * i + 1]}});
  }
  return bends;
}

Roadmap read_roadmap(const geom::ArrayArchive& archive) {
  const geom::JsonFields fields(archive.meta(), archive.name(), 0);
  const auto refuse = [&](std::string_view message) {
    throw geom::InputError(archive.name(), message);
  };
  Roadmap out;
  out.spec = read_roadmap_spec(fields);
  out.made_for = geom::read_provenance(fields);
  out.bends = read_bends(archive);
  const auto first = archive.array<std::uint64_t>("edge_first");
  const auto split = archive.array<std::uint32_t>("edge_split");
  const auto to = archive.array<std::uint32_t>("edge_to");
  const std::size_t n = out.bends.size();
  if (first.size() != n + 1 || split.size() != n || first[0] != 0 || first[n] != to.size()) {
    refuse("the arrays of bends and edges do not fit each other");
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (first[i] > first[i + 1] || split[i] > first[i + 1] - first[i]) {
      refuse(
          fmt::format("bend {} has a range of edges that is impossible: the file is damaged", i));
    }
  }
  if (fields.has("lattice")) {
    const auto label = archive.array<std::uint32_t>("node_label");
    out.coarse.emplace(LabelledLattice{read_lattice(archive, fields.value("lattice").dump()),
                                       {label.begin(), label.end()}});
    if (out.coarse->label.size() != out.coarse->lattice.size()) {
      refuse(fmt::format("expected {} labels of nodes, found {}", out.coarse->lattice.size(),
                         label.size()));
    }
  }
  out.first.assign(first.begin(), first.end());
  out.split.assign(split.begin(), split.end());
  out.to = to;
  out.keep_alive = archive.keep_alive();
  out.source = archive.name();
  return out;
}

void verify_roadmap(const Roadmap& roadmap) {
  for (const std::uint32_t bend : roadmap.to) require_bend(roadmap, bend);
  if (roadmap.coarse) verify_lattice(roadmap.coarse->lattice);
}

}  // namespace plan
