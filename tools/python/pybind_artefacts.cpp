// Box maps, lattices and roadmaps as NumPy arrays over the mapped files.

#include <array>

#include "cli/file/files.h"
#include "geom/map/box_map_file.h"
#include "geom/map/map_draft.h"
#include "plan/lattice/lattice_file.h"
#include "plan/roadmap/roadmap_file.h"
#include "pybind_arrays.h"
#include "pybind_keywords.h"
#include "pybind_module.h"

namespace binding {
namespace {

using plan::Lattice;
using plan::LatticeGrid;
using plan::Roadmap;

py::tuple tuple_of(const geom::Aabb& box) {
  return py::make_tuple(binding::tuple_of(box.min), binding::tuple_of(box.max));
}

py::array boxes(const py::object& self) {
  const auto all = self.cast<const geom::BoxMap&>().boxes();
  static_assert(sizeof(geom::Aabb) == 6 * sizeof(double));
  return view(reinterpret_cast<const double*>(all.data()),
              {static_cast<py::ssize_t>(all.size()), 6}, self);
}

// Boxes (n, 6), with ids and labels where they are given, one a box.
geom::BoxTable table_of(const py::object& boxes,
                        const std::optional<std::vector<std::uint64_t>>& ids,
                        const std::optional<std::vector<std::string>>& labels) {
  const std::span<const double> values = rows(boxes, 6, "boxes");
  require_coordinates(values, 6, "boxes");
  geom::BoxTable out;
  for (std::size_t i = 0; i < values.size() / 6; ++i) {
    const double* const at = values.data() + 6 * i;
    out.add({geom::Vec3(at), geom::Vec3(at + 3)}, ids ? (*ids)[i] : i,
            labels ? out.label_of((*labels)[i]) : 0);
  }
  return out;
}

// The box around them. There is one at least.
geom::Aabb around(const std::vector<geom::Aabb>& boxes) {
  geom::Aabb out = boxes.front();
  for (const geom::Aabb& box : boxes) out = {out.min.cwiseMin(box.min), out.max.cwiseMax(box.max)};
  return out;
}

geom::BoxMap make_box_map(const py::object& boxes,
                          const std::optional<std::vector<std::uint64_t>>& ids,
                          const std::optional<std::vector<std::string>>& labels,
                          const py::dict& keywords) {
  const Keywords given(keywords);
  geom::MapDraft draft{.source = "BoxMap", .history = R"([{"tool":"python"}])"};
  draft.table = table_of(boxes, ids, labels);
  draft.options = given.map();
  draft.frame.axes = *geom::value_of(geom::kAxesWords, given.word("frame", {"enu", "neu"}));
  draft.frame.origin = given.origin("origin");
  const auto& bounds = draft.options.bounds;
  if (draft.table.boxes.empty() && bounds) {
    return geom::BoxMap({draft.frame, *bounds, "option", draft.options.tile_size, draft.history},
                        draft.table);
  }
  if (draft.frame.origin && !draft.table.boxes.empty()) {
    const geom::Aabb box = around(draft.table.boxes);
    require_metres(draft.frame, std::array{box.min, box.max}, "boxes");
  }
  return geom::make_map(std::move(draft)).map;
}

void bind_map(py::module_& module) {
  using geom::BoxMap;
  py::class_<BoxMap>(module, "BoxMap")
      .def("__len__", &BoxMap::size)
      .def_property_readonly("hash", &BoxMap::hash)
      .def_property_readonly("boxes", [](const py::object& self) { return boxes(self); })
      .def_property_readonly("ids",
                             [](const py::object& self) {
                               const auto ids = self.cast<const BoxMap&>().ids();
                               return view(ids.data(), {static_cast<py::ssize_t>(ids.size())},
                                           self);
                             })
      .def_property_readonly("label",
                             [](const py::object& self) {
                               const auto label = self.cast<const BoxMap&>().label();
                               return view(label.data(), {static_cast<py::ssize_t>(label.size())},
                                           self);
                             })
      .def_property_readonly("labels", &BoxMap::labels)
      .def_property_readonly(
          "frame", [](const BoxMap& map) { return std::string(geom::name(map.spec().frame.axes)); })
      .def_property_readonly("origin",
                             [](const BoxMap& map) -> py::object {
                               const auto& origin = map.spec().frame.origin;
                               if (!origin) return py::none();
                               return py::make_tuple(origin->latitude, origin->longitude,
                                                     origin->height);
                             })
      .def_property_readonly("crs", [](const BoxMap& map) { return map.spec().frame.crs; })
      .def_property_readonly("bounds",
                             [](const BoxMap& map) { return tuple_of(map.spec().bounds); })
      .def_property_readonly("tile_size", [](const BoxMap& map) { return map.spec().tile_size; })
      .def_property_readonly("history",
                             [](const BoxMap& map) { return from_json(map.spec().history); });
  module.def("make_box_map", &make_box_map);
  module.def("require_unchanged", &geom::require_unchanged);
  module.def(
      "read_box_map",
      [](const std::string& path) { return cli::open_map(path, geom::Verified::extents); },
      py::arg("path"), py::call_guard<Released>());
  module.def(
      "write_box_map",
      [](const std::string& path, const BoxMap& map) {
        cli::OutputFile out(path, cli::OutputKind::artefact);
        geom::write_box_map(out.stream(), map);
        geom::require_unchanged(map);
        out.commit();
      },
      py::arg("path"), py::arg("map"), py::call_guard<Released>());
}

// The masks of all nodes, x fastest: what docs/formats.md packs, and bit 31 for the node itself.
py::array masks(const Lattice& lattice) {
  const plan::Index3& dims = lattice.dims();
  const LatticeGrid& grid = lattice.grid();
  std::vector<std::uint32_t> out(lattice.size());
  {
    const Released released;
    Lattice::Block block;
    for (std::size_t b = 0; b < grid.block_count(); ++b) {
      lattice.read(b, block);
      const plan::Index3 low = grid.block_low(b);
      for (std::int64_t i = 0; i < static_cast<std::int64_t>(LatticeGrid::kBlock); ++i) {
        const plan::Index3 at{low[0] + i % 8, low[1] + i / 8 % 8, low[2] + i / 64};
        if (!grid.contains(at)) continue;
        out[at[0] + dims[0] * (at[1] + dims[1] * at[2])] = block[i];
      }
    }
  }
  return owning(std::move(out), {dims[2], dims[1], dims[0]});
}

py::array stored(const py::object& self, std::size_t which) {
  const geom::NamedArray array = plan::lattice_arrays(self.cast<const Lattice&>())[which];
  const Shape shape(array.shape.begin(), array.shape.end());
  if (array.dtype == "|u1") {
    return view(reinterpret_cast<const std::uint8_t*>(array.pieces.front().data()), shape, self);
  }
  return view(reinterpret_cast<const std::uint32_t*>(array.pieces.front().data()), shape, self);
}

void bind_lattice(py::module_& module) {
  py::class_<Lattice> lattice(module, "Lattice");
  def_provenance(lattice, [](const Lattice& self) { return self.made_for(); });
  lattice.def("__len__", &Lattice::size)
      .def_property_readonly("spacing", [](const Lattice& l) { return l.spec().spacing; })
      .def_property_readonly("origin",
                             [](const Lattice& l) { return binding::tuple_of(l.spec().origin); })
      .def_property_readonly(
          "connectivity", [](const Lattice& l) { return static_cast<int>(l.spec().connectivity); })
      .def_property_readonly("first", &Lattice::first)
      .def_property_readonly("dims", &Lattice::dims)
      .def_property_readonly("nodes", [](const Lattice& l) { return plan::stored_counts(l).nodes; })
      .def_property_readonly("edges", [](const Lattice& l) { return plan::stored_counts(l).edges; })
      .def_property_readonly("block_record", [](const py::object& self) { return stored(self, 0); })
      .def_property_readonly("records", [](const py::object& self) { return stored(self, 1); })
      .def("masks", &masks);
  module.def(
      "read_lattice",
      [](const std::string& path) { return plan::read_lattice(cli::open_archive(path)); },
      py::arg("path"));
}

// A member of a roadmap, one row an entry or `columns` entries a row.
template <class T>
void def_array(py::class_<Roadmap>& roadmap, const char* name, std::span<const T> Roadmap::*member,
               py::ssize_t columns = 0) {
  roadmap.def_property_readonly(name, [member, columns](const py::object& self) {
    const auto values = self.cast<const Roadmap&>().*member;
    const auto size = static_cast<py::ssize_t>(values.size());
    Shape shape = columns ? Shape{size / columns, columns} : Shape{size};
    return view(values.data(), std::move(shape), self);
  });
}

void bind_roadmap(py::module_& module) {
  py::class_<Roadmap> roadmap(module, "Roadmap");
  def_provenance(roadmap, [](const Roadmap& self) { return self.made_for; });
  roadmap.def("__len__", &Roadmap::bends)
      .def_property_readonly("part", [](const Roadmap& r) { return r.spec.part; })
      .def_property_readonly("reach", [](const Roadmap& r) { return r.spec.reach; });
  def_array(roadmap, "tile_index", &Roadmap::tile_index, 2);
  def_array(roadmap, "tile_extent", &Roadmap::tile_extent, 6);
  def_array(roadmap, "tile_first", &Roadmap::tile_first);
  def_array(roadmap, "tile_edges", &Roadmap::tile_edges);
  def_array(roadmap, "bend_position", &Roadmap::bend_position, 3);
  def_array(roadmap, "bend_axis", &Roadmap::bend_axis);
  def_array(roadmap, "bend_outward", &Roadmap::bend_outward, 2);
  def_array(roadmap, "edge_first", &Roadmap::edge_first);
  def_array(roadmap, "edge_split", &Roadmap::edge_split);
  def_array(roadmap, "edge_to", &Roadmap::edge_to);
  module.def(
      "read_roadmap",
      [](const std::string& path) { return plan::read_roadmap(cli::open_archive(path)); },
      py::arg("path"));
}

}  // namespace

void bind_artefacts(py::module_& module) {
  bind_map(module);
  bind_lattice(module);
  bind_roadmap(module);
}

}  // namespace binding
