// Maps of the same obstacles, or fewer of them: crop, join, merge, simplify, inflate, tile.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/skipped_option.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/map/box_map_file.h"
#include "geom/map/join.h"
#include "geom/map/merge.h"
#include "geom/map/simplify.h"
#include "geom/text/counted.h"
#include "geom/text/parse_json.h"
#include "verbs.h"

namespace verbs {
namespace {

using geom::Aabb;
using geom::BoxMap;
using geom::BoxTable;
using Json = nlohmann::ordered_json;

Json numbers(const Aabb& box) {
  return {box.min[0], box.min[1], box.min[2], box.max[0], box.max[1], box.max[2]};
}

Json step_of(const char* verb, const BoxMap& input) {
  return {{"tool", std::string("skyway-map ") + verb}, {"input", input.hash()}};
}

void run_crop(const Files& files, const Aabb& region, const cli::MetresOption& metres,
              const cli::Common& common) {
  const BoxMap map = open(files.map, common);
  metres.check_option(map.spec().frame, std::array{region.min, region.max}, "--bounds");
  geom::BoxMapSpec spec = map.spec();
  spec.bounds = {spec.bounds.min.cwiseMax(region.min), spec.bounds.max.cwiseMin(region.max)};
  if ((spec.bounds.min.array() >= spec.bounds.max.array()).any()) {
    throw geom::InputError(files.map, {.expected = "--bounds that meet the bounds of the map",
                                       .found = "a region apart from them"});
  }
  Json step = step_of("crop", map);
  step["bounds"] = numbers(region);
  write(files, spec, geom::table_of(map, &region), step);
}

// Seconds after different instants cannot stand in one map.
void join_epoch(geom::BoxMapSpec& spec, const BoxMap& other, const std::string& name) {
  const auto& epoch = other.spec().epoch;
  if (!epoch || spec.epoch == epoch) return;
  if (spec.epoch) {
    throw geom::InputError(
        name, {.expected = fmt::format("the epoch of the maps before, {}", *spec.epoch),
               .found = std::string(*epoch)});
  }
  spec.epoch = epoch;
}

void run_join(const std::vector<std::string>& names, const std::string& output,
              const cli::Common& common) {
  cli::at_most_one_stdin({names[0]});
  const BoxMap first = open(names[0], common);
  geom::BoxMapSpec spec = first.spec();
  BoxTable table = geom::table_of(first);
  Json step = step_of("join", first);
  Json others = Json::array();
  Json histories = Json::array();
  std::size_t skipped = 0;  // that the others know of; the first has its own history
  for (std::size_t i = 1; i < names.size(); ++i) {
    if (names[i] == "-")
      throw cli::UsageError("expected stdin (\"-\") as the first map only, found it later");
    const BoxMap other = open(names[i], common);
    others.push_back(other.hash());
    const std::string& past = other.spec().history;
    histories.push_back(geom::parse_ordered_json(past.empty() ? "[]" : past, names[i]));
    skipped += cli::skipped_in(other.spec());
    geom::append(table, geom::in_frame(spec.frame, other, names[i]));
    join_epoch(spec, other, names[i]);
    // Bounds move as a box does.
    geom::BoxMapSpec moved = other.spec();
    BoxTable corner;
    corner.boxes = {other.spec().bounds};
    corner.ids = {0};
    corner.label = {0};
    const BoxTable bounds = geom::in_frame(spec.frame, BoxMap(moved, corner), names[i]);
    spec.bounds = geom::merged(spec.bounds, bounds.boxes.front());
  }
  step["others"] = others;
  step["histories"] = histories;
  if (skipped > 0) step["skipped"] = skipped;
  write({names[0], output}, spec, table, step);
}

void run_merge(const Files& files, const cli::Common& common) {
  const BoxMap map = open(files.map, common);
  const geom::Merged merged = geom::merge(geom::table_of(map));
  write(files, map.spec(), merged.table, step_of("merge", map));
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
  Json step = step_of("simplify", map);
  step["slack"] = slack;
  write(files, map.spec(), simple.table, step);
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

void run_inflate(const Files& files, double by, const cli::Common& common) {
  const BoxMap map = open(files.map, common);
  BoxTable table = geom::table_of(map);
  for (Aabb& box : table.boxes) box = geom::grow(box, geom::Vec3::Constant(by));
  Json step = step_of("inflate", map);
  step["by"] = by;
  write(files, map.spec(), table, step);
}

void run_tile(const Files& files, double size, const cli::Common& common) {
  const BoxMap map = open(files.map, common);
  geom::BoxMapSpec spec = map.spec();
  spec.tile_size = size;
  Json step = step_of("tile", map);
  step["size"] = size;
  write(files, spec, geom::table_of(map), step);
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

void write(const Files& files, geom::BoxMapSpec spec, const BoxTable& table, Json step) {
  Json history =
      geom::parse_ordered_json(spec.history.empty() ? "[]" : spec.history, "the map's history");
  history.push_back(std::move(step));
  spec.history = history.dump();
  const BoxMap made(std::move(spec), table);
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
            run_inflate(*files, *by, common);
            return cli::Exit::yes;
          }};
}

Verb tile(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  auto size = std::make_shared<double>(100);
  CLI::App* verb = files->add(app, "tile", "the same map in tiles of another size");
  verb->add_option("--size", *size, "metres")->required()->check(CLI::Range(1.0, 1e6));
  return {verb, [=, &common] {
            run_tile(*files, *size, common);
            return cli::Exit::yes;
          }};
}

}  // namespace verbs
