// Maps that differ: diff and patch.

#include <set>
#include <vector>

#include "airspace.h"
#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "geom/import/box_csv.h"
#include "geom/map/difference.h"
#include "geom/map/map_patch.h"
#include "geom/record/flight_time.h"
#include "geom/text/json_line.h"
#include "geom/zone/zone_report.h"
#include "verbs.h"
#include "volumes.h"

namespace verbs {
namespace {

using geom::Aabb;
using geom::BoxMap;
using geom::BoxTable;
using Json = nlohmann::ordered_json;

cli::Exit run_diff(const std::string& before, const std::string& after, const std::string& output,
                   const cli::Common& common) {
  cli::at_most_one_stdin({before, after});
  const BoxMap a = open(before, common);
  const BoxMap b = open(after, common);
  const geom::MapDifference change = geom::difference(a, b);
  cli::OutputFile out(output, cli::OutputKind::text);
  for (const auto& box : change.removed) out.stream() << geom::to_json_line("removed", box);
  for (const auto& box : change.added) out.stream() << geom::to_json_line("added", box);
  geom::JsonLine summary;
  summary.add("type", "diff").add("removed", change.removed.size());
  summary.add("added", change.added.size()).add("same_frame", change.same_frame);
  summary.add("same_bounds", change.same_bounds);
  if (a.spec().epoch || b.spec().epoch) summary.add("same_epoch", change.same_epoch);
  out.stream() << summary.line();
  out.commit();
  common.write_stats({{"removed", change.removed.size()}, {"added", change.added.size()}});
  return change.none() ? cli::Exit::yes : cli::Exit::no;
}

struct Changes {
  std::string add;
  std::string remove;
  std::string keep_out;
  std::string fence;
  std::string epoch;
  geom::VolumeOptions volumes;
  cli::MetresOption metres;
  Airspace airspace;

  bool any() const {
    return !add.empty() || !remove.empty() || !keep_out.empty() || !fence.empty() ||
           !epoch.empty() || airspace.any();
  }
};

// "1,2,3", or a file of ids between white space and commas.
std::set<std::uint64_t> ids_of(const std::string& word) {
  const bool list = word.find_first_not_of("0123456789, ") == std::string::npos;
  return list ? geom::parse_ids(word, "--remove")
              : geom::parse_ids(cli::InputFile(word).read_all(), word);
}

std::string epoch_of(const std::string& word) {
  if (const auto epoch = geom::epoch_from(word)) return *epoch;
  throw cli::UsageError(
      "--epoch: expected an instant in UTC such as 2026-05-04T06:30:00Z (RFC 3339), found \"" +
      word + '"');
}

// All lower and upper corners.
std::vector<geom::Vec3> corners_of(const BoxTable& table) {
  std::vector<geom::Vec3> out;
  for (const Aabb& box : table.boxes) {
    out.push_back(box.min);
    out.push_back(box.max);
  }
  return out;
}

// Options that say how another one's file is read.
void refuse_idle(const CLI::App& app, const Changes& changes) {
  const bool volumes = !changes.keep_out.empty();
  cli::only_for(app, volumes, {"--keep-out-local"}, "--keep-out");
  cli::only_for(app, volumes || !changes.fence.empty(), {"--far"}, "--keep-out and --fence");
  cli::only_for(app, volumes || !changes.fence.empty() || !changes.airspace.zones.empty(),
                {"--slack"}, "--keep-out, --fence and --zones");
  changes.airspace.refuse_idle(app);
  cli::only_for(app, volumes || !changes.add.empty(), {"--metres"}, "--add and --keep-out");
}

void warn_of_zones(const BoxMap& map, const cli::Common& common) {
  for (const geom::ZoneSource& zone : geom::zone_sources(map.spec())) {
    common.warn(
        fmt::format("--remove: the boxes may be of zones of {}, so reports no longer name it; "
                    "patch it in again",
                    zone.file));
  }
}

void run_patch(const Files& files, const Changes& changes, const cli::Common& common) {
  if (!changes.any()) {
    throw cli::UsageError(
        "nothing to change: give --add, --remove, --keep-out, --zones, --fence, --ceiling, --agl "
        "or --epoch");
  }
  cli::at_most_one_stdin(
      {files.map, changes.add, changes.keep_out, changes.fence, changes.airspace.zones});
  const BoxMap map = open(files.map, common);
  geom::MapPatch patch(map, files.map);
  Json stats;
  if (!changes.remove.empty()) {
    const std::set<std::uint64_t> ids = ids_of(changes.remove);
    stats["removed"] = patch.remove(ids);
    const std::string shared = geom::shared_ids(map, ids);
    if (!shared.empty()) common.warn("--remove: " + shared + "; all of them are removed");
    warn_of_zones(map, common);
  }
  if (!changes.add.empty()) {
    cli::InputFile file(changes.add);
    BoxTable fresh = geom::read_box_csv(file.stream(), file.name());
    changes.metres.check_input(patch.spec().frame, corners_of(fresh), file.name(), 0);
    stats["added"] = patch.add("added", std::move(fresh));
  }
  if (!changes.epoch.empty()) patch.set_epoch(epoch_of(changes.epoch));
  if (changes.volumes.zero_height && changes.keep_out.empty() && changes.airspace.zones.empty()) {
    throw cli::UsageError(
        "--zero-height: expected --keep-out with volumes of ASTM F3548, or --zones");
  }
  if (!changes.keep_out.empty()) {
    stats["keep_out"] =
        patch_keep_out(changes.keep_out, changes.volumes, changes.metres, common, patch);
  }
  if (!changes.fence.empty()) {
    stats["fence"] = patch_fence(changes.fence, changes.volumes, patch);
  }
  patch_airspace(changes.airspace, {map, changes.volumes.zero_height, changes.volumes.slack}, patch,
                 common, stats);
  write(files, patch.made());
  common.write_stats(stats);
}

}  // namespace

Verb diff(CLI::App& app, const cli::Common& common) {
  struct Options {
    std::string before;
    std::string after;
    std::string output = "-";
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand(
      "diff", "boxes that one of two maps has and the other has not (exit 1 if any)");
  verb->fallthrough();
  verb->add_option("before", options->before, "box map; - for stdin")->required();
  verb->add_option("after", options->after, "box map; - for stdin")->required();
  cli::add_output(*verb, "-o,--output", options->output, "JSON Lines (default: stdout)");
  return {verb, [=, &common] {
            return run_diff(options->before, options->after, options->output, common);
          }};
}

Verb patch(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  auto changes = std::make_shared<Changes>();
  CLI::App* verb = files->add(app, "patch", "add boxes, remove boxes, keep volumes out");
  verb->add_option("--add", changes->add, "box CSV of boxes to add");
  verb->add_option("--remove", changes->remove, "ids to remove: 1,2,3 or a file of them");
  verb->add_option(
      "--keep-out", changes->keep_out,
      "no-fly volumes: GeoJSON (lower, upper: metres; from, until: times), or Volume4D "
      "of ASTM F3548; they become boxes labelled keep-out");
  verb->add_option(
          "--zero-height", changes->volumes.zero_height,
          "height above the ellipsoid of the map's z = 0, metres, for ASTM F3548 volumes, zones")
      ->check(CLI::Range(-1e4, 1e5));
  verb->add_option("--epoch", changes->epoch,
                   "the instant that the map's times count from (RFC 3339, UTC)");
  verb->add_flag("--keep-out-local", changes->volumes.local,
                 "its coordinates are the map's metres, not longitude and latitude");
  verb->add_flag("--far", changes->volumes.far,
                 "volumes and fences may lie anywhere; without it, those are refused that are not "
                 "near the map");
  changes->metres.add_to(*verb);
  changes->airspace.add_to(*verb);
  verb->add_option("--fence", changes->fence,
                   "fences of a QGroundControl plan or a WPL file; what they forbid becomes boxes "
                   "labelled fence, from the bottom of the map to its top");
  verb->add_option("--slack", changes->volumes.slack,
                   "how far boxes may reach outside a volume, metres (default 0.5)")
      ->check(CLI::Range(0.01, 100.0));
  return {verb, [=, &common] {
            refuse_idle(*verb, *changes);
            run_patch(*files, *changes, common);
            return cli::Exit::yes;
          }};
}

}  // namespace verbs
