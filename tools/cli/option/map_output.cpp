#include "map_output.h"

#include <fmt/format.h>

#include "cli/answer/exit.h"
#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/numbers_option.h"
#include "geom/map/box_map_file.h"
#include "geom/text/counted.h"

namespace cli {

void add_map_options(CLI::App& app, geom::MakeMapOptions& map, const std::string& seal_default) {
  app.add_option(
         "--seal", map.seal,
         "extend obstacles that hang less than this above the floor down to it, metres (default: " +
             seal_default + ")")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--floor", map.floor, "lower z of the bounds (default: 0 for FCND tables)");
  app.add_option("--ceiling", map.ceiling, "upper z of the bounds");
  app.add_option("--pad", map.pad,
                 "metres that the bounds reach beyond the obstacles, sideways and upward")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--scale", map.scale, "metres per unit of the source (default 1)")
      ->check(CLI::Range(1e-9, 1e9));
  app.add_option("--bloat-percent", map.bloat_percent,
                 "grow each box about its centre by this share of its size")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_option("--inflate", map.inflate, "grow each box by this on every side, metres")
      ->check(CLI::Range(0.0, 1e4));
  add_box(app, "--bounds", map.bounds,
          "the bounds along the map's axes, in place of --floor, --ceiling and --pad")
      ->excludes("--floor", "--ceiling", "--pad");
  app.add_option("--tile", map.tile_size, "tile size, metres (default 100)")
      ->check(CLI::Range(1.0, 1e6));
}

void add_allow_skipped(CLI::App& app, bool& allowed) {
  app.add_flag("--allow-skipped", allowed,
               "leave out what is or may be an obstacle and cannot be built; the map's history "
               "says how many");
}

nlohmann::ordered_json to_json(const std::vector<geom::Fact>& facts) {
  nlohmann::ordered_json out = nlohmann::ordered_json::object();
  for (const auto& [what, value] : facts) {
    std::visit([&, &what = what](const auto& one) { out[what] = one; }, value);
  }
  return out;
}

void warn_of_beyond(const geom::MadeMap& made, const std::string& source, const Common& common) {
  if (made.beyond == 0) return;
  common.warn(fmt::format("{}: {} wholly outside the bounds", source,
                          geom::counted(made.beyond, "box lies", "boxes lie")));
}

void write_map(const Common& common, const std::string& output, const geom::MadeMap& made,
               const std::string& source, nlohmann::ordered_json stats) {
  const geom::BoxMapSpec& spec = made.map.spec();
  const geom::Vec3 corners[] = {spec.bounds.min, spec.bounds.max};
  if (spec.bounds_from == "option" && look_like_degrees(spec.frame, corners)) {
    throw UsageError(
        fmt::format("--bounds [{}, {}] to [{}, {}] look like degrees: the map's coordinates "
                    "are metres from its origin, so give metres",
                    corners[0].x(), corners[0].y(), corners[1].x(), corners[1].y()));
  }
  warn_of_beyond(made, source, common);
  OutputFile out(output, OutputKind::artefact);
  geom::write_box_map(out.stream(), made.map);
  out.commit();
  stats.update({{"boxes", made.map.size()},
                {"sealed", made.sealed},
                {"beyond", made.beyond},
                {"tiles", made.map.tile_count()},
                {"hash", made.map.hash()}});
  common.write_stats(std::move(stats));
}

void write_map(const Common& common, const std::string& output, geom::MapDraft draft) {
  const std::string source = draft.source;
  nlohmann::ordered_json stats = to_json(draft.facts);
  write_map(common, output, geom::make_map(std::move(draft), {common.execution("").threads, {}}),
            source, std::move(stats));
}

}  // namespace cli
