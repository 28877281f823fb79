#include "airspace.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/file/files.h"
#include "cli/option/geoid_option.h"
#include "cli/option/ground_option.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/tell.h"
#include "geom/base/sha256.h"
#include "geom/import/volume_keep_out.h"
#include "geom/text/counted.h"
#include "geom/text/instant.h"
#include "geom/zone/read_zones.h"
#include "geom/zone/zone_boxes.h"
#include "geom/zone/zone_report.h"

namespace verbs {
namespace {

using Json = nlohmann::ordered_json;

std::string hash_of(const std::string& text) {
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span(std::string_view(text))));
  return "sha256:" + sum.hex();
}

std::set<geom::ZoneType> types_of(const std::string& words) {
  std::set<geom::ZoneType> out;
  for (const std::string& word : CLI::detail::split(words, ',')) {
    const std::string plain = word == "REQ_AUTHORISATION" ? "REQ_AUTHORIZATION" : word;
    const auto type = geom::value_of(geom::kZoneTypeWords, plain);
    if (!type) {
      throw cli::UsageError(fmt::format("--type: expected words of {}, found \"{}\"",
                                        geom::listed(geom::kZoneTypeWords), word));
    }
    out.insert(*type);
  }
  return out;
}

std::optional<double> number_in(std::string_view text) {
  const auto numbers = cli::parse_numbers(text, 1);
  return numbers ? std::optional((*numbers)[0]) : std::nullopt;
}

geom::GroundBand band_of(const Airspace& airspace) {
  geom::GroundBand band{
      .low = {}, .high = {}, .step = airspace.step, .close_unknown = airspace.close_unknown};
  if (!airspace.ceiling.empty()) {
    const std::string& word = airspace.ceiling;
    if (word.ends_with("agl")) {
      band.high = number_in(std::string_view(word).substr(0, word.size() - 3));
    }
    if (!band.high) {
      throw cli::UsageError(
          "--ceiling: expected metres above the ground, such as 120agl, found \"" + word + '"');
    }
  }
  if (!airspace.agl.empty()) {
    const geom::GroundBand both = cli::band_from(airspace.agl);
    band.low = both.low;
    band.high = std::min(*both.high, band.high.value_or(*both.high));
  }
  return band;
}

// The geoid above the ellipsoid, anywhere over the map.
geom::ZeroOffset geoid_of(const std::string& word, const geom::BoxMapSpec& spec, Json& note) {
  const cli::NamedGeoidGrid geoid = cli::geoid_grid_of(word);
  const geom::SunArea area = geom::area_of(spec);
  const auto range = geoid.grid.over({area.south, area.north, area.west, area.east});
  if (!range) {
    throw geom::InputError(geoid.path,
                           {.says = "the grid does not know the geoid all over the map"});
  }
  note = {{"grid", std::filesystem::path(geoid.path).filename().string()},
          {"least", range->least},
          {"most", range->most}};
  return {range->least, range->most};
}

// What the map's z of a height above the ellipsoid and above the sea is.
geom::ZoneRoom room_of(const Airspace& airspace, const AirspaceHeights& heights,
                       const geom::BoxMapSpec& spec, Json& note) {
  geom::ZoneRoom room{.spec = spec, .ground = nullptr, .sea = {}, .ellipsoid = {}};
  std::optional<double> zero = heights.zero_height;
  if (!zero && geom::knows_height(spec.frame)) zero = spec.frame.origin->height;
  if (airspace.zero_sea) {
    room.sea = geom::ZeroOffset{-*airspace.zero_sea, -*airspace.zero_sea};
  }
  std::optional<geom::ZeroOffset> geoid;
  if (airspace.geoid) {
    geoid = geom::ZeroOffset{*airspace.geoid, *airspace.geoid};
    note = *airspace.geoid;
  }
  if (!airspace.geoid_grid.empty()) geoid = geoid_of(airspace.geoid_grid, spec, note);
  if (zero) room.ellipsoid = geom::ZeroOffset{-*zero, -*zero};
  if (!zero && airspace.zero_sea && geoid) {
    room.ellipsoid =
        geom::ZeroOffset{-*airspace.zero_sea - geoid->most, -*airspace.zero_sea - geoid->least};
  }
  if (zero && geoid && !room.sea) {
    room.sea = geom::ZeroOffset{geoid->least - *zero, geoid->most - *zero};
  }
  room.slack = heights.slack;
  room.step = airspace.step;
  room.clock = {spec.epoch, airspace.days};
  if (!airspace.types.empty()) room.types = types_of(airspace.types);
  return room;
}

// "CH-1 (PROHIBITED, Airport): 12 boxes; authority: …; message: …".
std::string sentence_of(const geom::ListedZone& zone) {
  std::string out = fmt::format("{} ({}{}{})", zone.identifier, geom::name(zone.type),
                                zone.name.empty() ? "" : ", ", zone.name);
  out += zone.boxes > 0 ? fmt::format(" is closed by {}", geom::counted(zone.boxes, "box", "boxes"))
                        : std::string(" is not closed");
  if (zone.times.empty()) out += "; it is never there";
  if (!zone.authority.empty()) out += "; authority: " + zone.authority;
  if (!zone.message.empty()) out += "; message: " + zone.message;
  return out;
}

// What was read on the safe side because something is not known.
void warn_of_open(const geom::ZoneFile& file, const geom::ZoneBoxes& boxes, const std::string& name,
                  const cli::Common& common) {
  std::size_t zero = 0;
  std::size_t hole = 0;
  for (const geom::NearZone& near : boxes.near) {
    zero += near.open_for_zero;
    hole += near.open_for_hole;
  }
  if (zero > 0) {
    common.warn(fmt::format(
        "{}: {} limits whose zero the map does not know (above ground: --ground-model; above the "
        "sea: --zero-sea, or --zero-height and --geoid); such a limit counts as open, down to the "
        "floor or up to the top of the map",
        name, zero == 1 ? "a zone has" : fmt::format("{} zones have", zero)));
  }
  if (hole > 0) {
    common.warn(fmt::format(
        "{}: under {} the height model does not know the ground everywhere; there they are closed "
        "at all heights",
        name, geom::counted(hole, "zone")));
  }
  for (const std::string& warning : file.warnings) common.warn(name + ": " + warning);
}

void warn_of_schedules(const geom::ZoneFile& file, const geom::ZoneBoxes& boxes,
                       const geom::ZoneRoom& room, const std::string& name,
                       const cli::Common& common) {
  std::size_t timed = 0;
  for (const geom::NearZone& near : boxes.near) timed += !file.zones[near.index].periods.empty();
  if (timed > 0 && !room.clock.epoch) {
    common.warn(
        fmt::format("{}: {} limited in time, and the map has no epoch to count from, so "
                    "they are closed always; give --epoch",
                    name, timed == 1 ? "a zone is" : fmt::format("{} zones are", timed)));
  }
  if (!room.clock.epoch || !file.valid_to) return;
  if (geom::seconds_between(*room.clock.epoch, *file.valid_to).least < 0) {
    common.warn(
        fmt::format("{}: it says that it is valid until {}, which is before the epoch of "
                    "the map: get a newer one",
                    name, *file.valid_to));
  }
}

// Zones that restrict and are not closed are warned of; the others are told.
void tell_zones(const geom::ZoneSource& source, const std::string& name,
                const cli::Common& common) {
  for (const geom::ListedZone& zone : source.zones) {
    const bool open = zone.boxes == 0 && zone.type != geom::ZoneType::none && !zone.times.empty();
    const std::string text = name + ": " + sentence_of(zone);
    if (open) {
      common.warn(text);
    } else {
      cli::tell(common, "skyway-map", text);
    }
  }
  cli::tell(
      common, "skyway-map",
      fmt::format("{}: {} read ({}{}{}), {} over the map", name,
                  geom::counted(source.zones_read, "zone"), source.format,
                  source.issued.empty() ? "" : ", issued ", source.issued, source.zones.size()));
}

void patch_zones(const Airspace& airspace, const geom::ZoneRoom& room, geom::MapPatch& patch,
                 const cli::Common& common, Json& stats) {
  cli::InputFile input(airspace.zones);
  const std::string text = input.read_all();
  const geom::ZoneFile file = geom::read_zones(text, input.name());
  const geom::ZoneBoxes boxes = geom::zone_boxes(file, input.name(), room);
  geom::ZoneSource source = geom::zone_source(file, boxes);
  source.file = std::filesystem::path(input.name()).filename().string();
  source.hash = hash_of(text);
  warn_of_open(file, boxes, input.name(), common);
  warn_of_schedules(file, boxes, room, input.name(), common);
  tell_zones(source, input.name(), common);
  stats["zone_boxes"] = patch.add("zone_boxes", boxes.table);
  stats["zones"] = geom::to_json(source);
  patch.note("zones", stats["zones"]);
  patch.note("zone_days", airspace.days);
}

}  // namespace

void Airspace::add_to(CLI::App& app) {
  app.add_option("--zones", zones,
                 "zones of airspace: EUROCAE ED-269 or ED-318, or a UAS facility map of the FAA; "
                 "they become boxes that are there at the zone's times");
  app.add_option("--type", types,
                 "types of zones that are closed (default: PROHIBITED,REQ_AUTHORIZATION,"
                 "CONDITIONAL,USPACE); others are listed");
  app.add_option("--days", days,
                 "schedules of zones are worked out so many days before and after the epoch; "
                 "beyond, such zones are closed always (default 7)")
      ->check(CLI::Range(1, 400));
  app.add_option("--ground-model", ground, cli::kGroundHelp);
  app.add_option("--ceiling", ceiling, "close what is higher above the ground, metres: 120agl");
  app.add_option("--agl", agl, "close what is lower or higher above the ground, metres: LOW,HIGH");
  app.add_option("--step", step,
                 "how far boxes may reach beyond a limit over sloping ground, metres (default 2)")
      ->check(CLI::Range(0.01, 1000.0));
  app.add_flag("--close-unknown", close_unknown,
               "close the map at all heights where the height model does not know the ground");
  app.add_option("--zero-sea", zero_sea,
                 "height of the map's z = 0 above the sea level, metres; 0 where it is the sea's")
      ->check(CLI::Range(-1e4, 1e5));
  app.add_option("--geoid", geoid,
                 "height of the sea level (geoid) above the ellipsoid there, metres")
      ->check(CLI::Range(-200.0, 200.0));
  app.add_option("--geoid-grid", geoid_grid, cli::kGeoidGridHelp)->excludes("--geoid");
}

void Airspace::refuse_idle(const CLI::App& app) const {
  const bool band = !ceiling.empty() || !agl.empty();
  cli::only_for(app, !zones.empty(), {"--type", "--days", "--zero-sea", "--geoid", "--geoid-grid"},
                "--zones");
  cli::only_for(app, band, {"--close-unknown"}, "--ceiling and --agl");
  cli::only_for(app, any(), {"--ground-model", "--step"}, "--zones, --ceiling and --agl");
  if (band && ground.empty()) {
    throw cli::UsageError("--ceiling and --agl count from the ground: give --ground-model");
  }
}

void patch_airspace(const Airspace& airspace, const AirspaceHeights& heights, geom::MapPatch& patch,
                    const cli::Common& common, Json& stats) {
  if (!airspace.any()) return;
  const auto ground = airspace.ground.empty() ? std::optional<geom::GroundModel>()
                                              : std::optional(cli::ground_from(airspace.ground));
  if (ground) {
    geom::require_same_zero(*ground, heights.map, airspace.ground);
    cli::note_ground(*ground, airspace.ground, patch);
  }
  patch.note_cut_to_bounds();
  if (!airspace.zones.empty()) {
    Json geoid;
    geom::ZoneRoom room = room_of(airspace, heights, patch.spec(), geoid);
    if (!geoid.is_null()) patch.note("geoid", geoid);
    room.ground = ground ? &*ground : nullptr;
    patch_zones(airspace, room, patch, common, stats);
  }
  const geom::GroundBand band = band_of(airspace);
  if (!band.low && !band.high) return;
  stats["ground_band"] = cli::close_band(band, *ground, airspace.ground, patch);
}

}  // namespace verbs
