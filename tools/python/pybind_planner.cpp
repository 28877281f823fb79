// Planning, one query or a batch.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "cli/option/scenes.h"
#include "geom/base/parallel.h"
#include "plan/planner/path_record.h"
#include "plan/planner/plan.h"
#include "pybind_arrays.h"
#include "pybind_module.h"

namespace binding {
namespace {

using geom::Vec3;

plan::Method method_from(const std::string& word) {
  if (const auto method = geom::value_of(plan::kMethodWords, word)) return *method;
  std::vector<std::string_view> words;
  for (const auto& one : plan::kMethodWords) words.push_back(one.word);
  throw py::value_error(
      fmt::format("method: expected one of {}, found \"{}\"", fmt::join(words, ", "), word));
}

plan::Quality quality_from(const std::string& word) {
  if (const auto quality = geom::value_of(plan::kQualityWords, word)) return *quality;
  throw py::value_error("quality: expected fast, normal or best, found \"" + word + "\"");
}

double within(double value, double most, const char* what) {
  if (value >= 0 && value <= most) return value;
  throw py::value_error(fmt::format("{}: must be within 0 to {} m, found {}", what, most, value));
}

// As --resample; 0: not.
double resample_step(double value) {
  if (value == 0 || (value >= 1e-3 && value <= 1e6)) return value;
  throw py::value_error(
      fmt::format("resample: must be 0, or within 0.001 to 1e6 m, found {}", value));
}

// A planner, and what it was made for.
struct Planner {
  Planner(const Scene& of, const plan::Lattice* lattice, const plan::Roadmap* roadmap)
      : scene(of.scene), planner(scene, lattice, roadmap) {
    if (lattice) geom::require_same(lattice->made_for(), scene, "lattice", "lattice");
    if (roadmap) geom::require_same(roadmap->made_for, scene, roadmap->source, "roadmap");
  }

  const geom::CollisionScene& scene;
  plan::Planner planner;
};

struct Words {
  std::string method;
  std::string quality;
  bool raw;
  double resample;
  double snap_ends;
  std::uint64_t seed;

  plan::PlanOptions options() const {
    plan::PlanOptions out;
    out.method = method_from(method);
    out.quality = quality_from(quality);
    out.raw = raw;
    out.resample = resample_step(resample);
    out.snap_ends = within(snap_ends, 1e4, "snap_ends");
    out.sampling.seed = seed;
    return out;
  }
};

geom::PathRecord plan_one(Planner& self, const py::object& from, const py::object& to,
                          const std::string& id, const std::string& method,
                          const std::string& quality, bool raw, double resample, double snap_ends,
                          std::uint64_t seed) {
  const plan::PlanOptions options =
      Words{method, quality, raw, resample, snap_ends, seed}.options();
  const Vec3 start = vec3(from, "start");
  const Vec3 goal = vec3(to, "goal");
  require_metres(self.scene.map().spec().frame, std::array{start, goal}, "start and goal");
  const Released released;
  return plan::path_record(self.scene, id, self.planner.plan(start, goal, options));
}

std::vector<geom::PathRecord> plan_batch(Planner& self, const py::object& queries,
                                         const std::optional<std::vector<std::string>>& ids,
                                         const std::string& method, const std::string& quality,
                                         bool raw, double resample, double snap_ends,
                                         std::uint64_t seed, unsigned threads) {
  const plan::PlanOptions options =
      Words{method, quality, raw, resample, snap_ends, seed}.options();
  const std::span<const double> ends = rows(queries, 6, "queries");
  const std::size_t count = ends.size() / 6;
  if (ids && ids->size() != count) {
    throw py::value_error(fmt::format("ids: expected {}, found {}", count, ids->size()));
  }
  const Released released;
  require_coordinates(ends, 6, "queries");
  std::vector<geom::PathRecord> out(count);
  geom::parallel_for(count, on_threads(threads), [&](std::size_t i) {
    const Vec3 from(ends.data() + 6 * i);
    const Vec3 to(ends.data() + 6 * i + 3);
    require_metres(self.scene.map().spec().frame, std::array{from, to},
                   fmt::format("query {}", i + 1));
    out[i] = plan::path_record(self.scene, ids ? (*ids)[i] : fmt::format("q{}", i + 1),
                               self.planner.plan(from, to, options));
  });
  return out;
}

}  // namespace

void bind_planner(py::module_& module) {
  py::class_<Planner>(module, "Planner")
      .def(py::init<const Scene&, const plan::Lattice*, const plan::Roadmap*>(), py::arg("scene"),
           py::arg("lattice") = nullptr, py::arg("roadmap") = nullptr, py::keep_alive<1, 2>(),
           py::keep_alive<1, 3>(), py::keep_alive<1, 4>())
      .def("plan", &plan_one, py::arg("start"), py::arg("goal"), py::kw_only(),
           py::arg("id") = "q1", py::arg("method") = "auto", py::arg("quality") = "normal",
           py::arg("raw") = false, py::arg("resample") = 0.0, py::arg("snap_ends") = 0.0,
           py::arg("seed") = 0)
      .def("plan_batch", &plan_batch, py::arg("queries"), py::kw_only(),
           py::arg("ids") = py::none(), py::arg("method") = "auto", py::arg("quality") = "normal",
           py::arg("raw") = false, py::arg("resample") = 0.0, py::arg("snap_ends") = 0.0,
           py::arg("seed") = 0, py::arg("threads") = 0);
}

}  // namespace binding
