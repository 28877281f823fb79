// Maps of the same obstacles, or fewer of them: crop, bounds, join, merge, simplify, inflate, tile.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/map_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/tell.h"
#include "geom/map/box_map_file.h"
#include "geom/map/derive.h"
#include "geom/map/join.h"
#include "geom/map/map_doubts.h"
#include "geom/text/counted.h"
#include "verbs.h"

namespace verbs {
namespace {

using geom::Aabb;
using geom::BoxMap;

void run_crop(const Files& files, const Aabb& region, const cli::MetresOption& metres,
              const cli::Common& common) {
  const BoxMap map = open(files.map, common);
  metres.check_option(map.spec().frame, std::array{region.min, region.max}, "--bounds");
  write(files, geom::crop(map, region, files.map));
}

void run_bounds(const Files& files, const geom::BoundsChange& change,
                const cli::MetresOption& metres, const cli::Common& common) {
  if (!change.bounds && !change.floor && !change.ceiling && !change.pad) {
    throw cli::UsageError("expected --ceiling, --floor, --pad or --bounds, found none");
  }
  const BoxMap map = open(files.map, common);
  if (const auto& box = change.bounds) {
    metres.check_option(map.spec().frame, std::array{box->min, box->max}, "--bounds");
  }
  const geom::MadeMap made = geom::with_bounds(map, change, files.map);
  cli::warn_of_beyond(made, files.map, common);
  write(files, made.map);
}

void run_join(const std::vector<std::string>& names, const std::string& output,
              const cli::Common& common) {
  cli::at_most_one_stdin({names[0]});
  std::vector<geom::SourceMap> maps;
  for (const std::string& name : names) {
    if (!maps.empty() && name == "-") {
      throw cli::UsageError("expected stdin (\"-\") as the first map only, found it later");
    }
    maps.push_back({name, open(name, common)});
  }
  const BoxMap joined = geom::join(maps);
  if (const double gap = geom::doubts_of(joined.spec()).gap; gap > 0) {
    common.warn(
        fmt::format("{:.3g} % of the joined bounds lie within the bounds of no map: nobody knows "
                    "what stands there, and it counts as free; give the maps bounds that meet "
                    "(skyway-map bounds)",
                    100 * gap));
  }
  if (maps.size() > 1 && geom::heights_unknown(maps)) {
    common.warn(
        "nobody knows how high these maps are above the ellipsoid (their origins have 0 m): their "
        "z = 0 count as equally high");
  }
  write({names[0], output}, joined);
}

void run_merge(const Files& files, const cli::Common& common) {
  const BoxMap map = open(files.map, common);
  const geom::Merged merged = geom::merge(geom::table_of(map));
  write(files, geom::derived(map, merged));
  cli::tell(common, "skyway-map",
            fmt::format("{}: {} before, {} after: {} contained in others, {} joined", files.map,
                        geom::counted(map.size(), "box", "boxes"), merged.table.boxes.size(),
                        merged.contained, merged.joined));
  common.write_stats({{"before", map.size()},
                      {"after", merged.table.boxes.size()},
                      {"contained", merged.contained},
                      {"joined", merged.joined}});
}

void run_simplify(const Files& files, double slack, const cli::Common& common) {
  const BoxMap map = open(files.map, common);
  const geom::Simplified simple =
      geom::simplify(geom::table_of(map), slack, common.execution("simplify"));
  write(files, geom::derived(map, simple, slack));
  cli::tell(common, "skyway-map",
            fmt::format("{}: {} before, {} after", files.map,
                        geom::counted(map.size(), "box", "boxes"), simple.table.boxes.size()));
  const double ratio = static_cast<double>(simple.table.boxes.size()) /
                       static_cast<double>(std::max<std::size_t>(1, map.size()));
  common.write_stats({{"before", map.size()},
                      {"after", simple.table.boxes.size()},
                      {"ratio", ratio},
                      {"rounds", simple.rounds},
                      {"tried", simple.tried}});
}

}  // namespace

CLI::App* Files::add(CLI::App& app, const char* name, const char* description) {
  CLI::App* verb = app.add_subcommand(name, description);
  verb->fallthrough();
  verb->add_option("map", map, "box map; - for stdin")->required();
  cli::add_output(*verb, "-o,--output", output, "file to write (default: stdout)");
  return verb;
}

geom::BoxMap open(const std::string& map, const cli::Common& common) {
  return cli::open_map(map, geom::Verified::contents, common.execution("verify"));
}

void write(const Files& files, const BoxMap& made) {
  cli::OutputFile out(files.output, cli::OutputKind::artefact, files.map);
  geom::write_box_map(out.stream(), made);
  out.commit();
}

Verb crop(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  auto region = std::make_shared<std::optional<Aabb>>();
  CLI::App* verb = files->add(app, "crop", "keep the boxes that meet a region");
  auto metres = std::make_shared<cli::MetresOption>();
  cli::add_box(*verb, "--bounds", *region, "the region to keep, along the map's axes")->required();
  metres->add_to(*verb);
  return {verb, [=, &common] {
            run_crop(*files, **region, *metres, common);
            return cli::Exit::yes;
          }};
}

Verb bounds(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  auto change = std::make_shared<geom::BoundsChange>();
  CLI::App* verb = files->add(app, "bounds", "the same boxes, and other bounds");
  auto metres = std::make_shared<cli::MetresOption>();
  verb->add_option("--ceiling", change->ceiling, "upper z of the bounds, metres");
  verb->add_option("--floor", change->floor, "lower z of the bounds, metres");
  verb->add_option("--pad", change->pad,
                   "widen the bounds to this far or more beyond obstacles, sideways and up, metres")
      ->check(CLI::Range(0.0, 1e6));
  cli::add_box(*verb, "--bounds", change->bounds,
               "the bounds along the map's axes, in place of --floor, --ceiling and --pad")
      ->excludes("--floor", "--ceiling", "--pad");
  metres->add_to(*verb);
  return {verb, [=, &common] {
            cli::only_for(*verb, change->bounds.has_value(), {"--metres"}, "--bounds");
            run_bounds(*files, *change, *metres, common);
            return cli::Exit::yes;
          }};
}

Verb join(CLI::App& app, const cli::Common& common) {
  auto names = std::make_shared<std::vector<std::string>>();
  auto output = std::make_shared<std::string>("-");
  CLI::App* verb = app.add_subcommand(
      "join", "one map of several: of one frame, or brought together by their origins");
  verb->fallthrough();
  verb->add_option("maps", *names, "box maps; the first gives the frame")
      ->required()
      ->expected(2, 10000);
  cli::add_output(*verb, "-o,--output", *output, "file to write (default: stdout)");
  return {verb, [=, &common] {
            run_join(*names, *output, common);
            return cli::Exit::yes;
          }};
}

Verb merge(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  CLI::App* verb = files->add(
      app, "merge", "drop contained boxes and join aligned neighbours: the same set, exactly");
  return {verb, [=, &common] {
            run_merge(*files, common);
            return cli::Exit::yes;
          }};
}

Verb simplify(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  auto slack = std::make_shared<double>(1);
  CLI::App* verb = files->add(app, "simplify", "fewer boxes that cover the same and little more");
  verb->add_option("--slack", *slack, "how far they may reach outside, metres (default 1)")
      ->check(CLI::Range(1e-3, 1000.0));
  return {verb, [=, &common] {
            run_simplify(*files, *slack, common);
            return cli::Exit::yes;
          }};
}

Verb inflate(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  auto by = std::make_shared<double>(0);
  CLI::App* verb = files->add(app, "inflate", "grow every box on every side");
  verb->add_option("--by", *by, "metres")->required()->check(CLI::Range(0.0, 1e4));
  return {verb, [=, &common] {
            write(*files, geom::inflate(open(files->map, common), *by));
            return cli::Exit::yes;
          }};
}

Verb tile(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  auto size = std::make_shared<double>(100);
  CLI::App* verb = files->add(app, "tile", "the same map in tiles of another size");
  verb->add_option("--tile", *size, "metres")->required()->check(CLI::Range(1.0, 1e6));
  return {verb, [=, &common] {
            write(*files, geom::tile(open(files->map, common), *size));
            return cli::Exit::yes;
          }};
}

}  // namespace verbs
