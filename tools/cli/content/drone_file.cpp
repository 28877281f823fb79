#include "drone_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/option/numbers_option.h"
#include "cli/option/placement_option.h"
#include "geom/base/error.h"
#include "traj/files/drone_formats.h"
#include "traj/files/own_formats.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/mission/idle_rules.h"

namespace cli {
namespace {

// "--origin" and so on, in the order of the words.
const std::vector<std::string>& option_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const auto& [option, word] : traj::kFileOptionWords) {
      out.push_back(fmt::format("--{}", word));
    }
    return out;
  }();
  return names;
}

// What says how an autopilot brakes and returns, from records too.
std::vector<const char*> also_with(std::string_view option) {
  constexpr std::string_view kBraking[] = {"--autopilot", "--params", "--drag", "--navigation"};
  if (option == "--return-height") return {"--return"};
  if (std::find(std::begin(kBraking), std::end(kBraking), option) == std::end(kBraking)) return {};
  return {"--return", "--contingencies"};
}

// What the tools that read drone files take.
const std::vector<FormatOption>& reading_options() {
  static const std::vector<FormatOption> rows = [] {
    auto out = file_option_rows(&traj::MissionFormat::reads_with);
    for (FormatOption& row : out) {
      row.with = also_with(row.option);
    }
    FormatOption& metres =
        out.emplace_back(FormatOption{"--metres", {kRecordsWord, kFlightLogWord}});
    for (const traj::MissionFormat* one : traj::mission_formats()) {
      if (!one->is_flown) metres.formats.push_back(one->format.word);
    }
    return out;
  }();
  return rows;
}

}  // namespace

std::vector<FormatOption> file_option_rows(traj::FileOptionSet traj::MissionFormat::*used) {
  std::vector<FormatOption> rows;
  for (std::size_t i = 0; i < traj::kFileOptionWords.size(); ++i) {
    FormatOption row{option_names()[i].c_str(), {}};
    for (const traj::MissionFormat* one : traj::mission_formats()) {
      if ((one->*used).has(traj::kFileOptionWords[i].value)) {
        row.formats.push_back(one->format.word);
      }
    }
    if (!row.formats.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string> drone_file_words(std::string_view tool) {
  std::vector<std::string> words{kAuto};
  for (const std::string_view word : traj::mission_words_of(tool)) words.emplace_back(word);
  return words;
}

void DroneFileOptions::add_to(CLI::App& parser) {
  app = &parser;
  std::vector<std::string> words = drone_file_words("skyway-check");
  words.emplace_back(kFlightLogWord);
  words.emplace_back(kRecordsWord);
  parser
      .add_option(
          "--file-format", format,
          "records, or a drone file to be checked as it will be flown; auto (default): found "
          "out from its beginning")
      ->check(CLI::IsMember(words));
  parser.add_flag_callback(
      "--paths-csv", [this] { format = traj::kPathsCsv.format.word; },
      "FILE is a table of paths with columns id,x,y,z");
  add_point(parser, "--takeoff-place", reading.start,
            "where a Tello stands before it takes off, along the map's axes");
  add_placement(parser, reading.placement);
  add_mission_to(parser);
  autopilot.add_to(parser);
  autopilot.add_tracking_to(parser);
}

void DroneFileOptions::settle(InputFile& file) {
  const bool insists = format == kRecordsWord;
  if (insists) format.clear();
  if (insists || !(format.empty() || format == kAuto)) return;
  const geom::Format* own = nullptr;
  const geom::Format* drone = nullptr;
  file.head_until([&](std::string_view head) {
    own = geom::recognise(head, traj::files::own_formats());
    drone = own ? nullptr : geom::recognise(head, traj::files::drone_formats());
    return own || drone;
  });
  if (own == &traj::files::kFlightLog) format = kFlightLogWord;
  if (own == &traj::files::kTrajectories || own == &traj::files::kPaths) format.clear();
  if (drone) format = kAuto;
}

void DroneFileOptions::settle_ground(const geom::Frame& frame) {
  terrain.refuse_idle(reading.rules);
  terrain.settle(frame, reading.rules);
}

void DroneFileOptions::require_used(std::string_view of_format, std::string_view because) const {
  if (app) cli::require_used(*app, reading_options(), of_format, because);
}

void DroneFileOptions::require_any_used(const CLI::App& parser,
                                        std::span<const traj::FileFlight> flights) const {
  std::vector<std::string_view> formats{kRecordsWord, kFlightLogWord};
  for (const traj::FileFlight& one : flights) formats.push_back(one.format->format.word);
  cli::require_used(parser, reading_options(), formats, "no file is one of these");
  require_used(flights, "what is shown");
}

void DroneFileOptions::require_used(std::span<const traj::FileFlight> flights,
                                    const std::string& source) const {
  traj::MissionRules rules = reading.rules;
  const CLI::Option* const returns = app ? app->get_option_no_throw("--return") : nullptr;
  if (returns && returns->count() > 0) rules.return_height.reset();  // it is used for that
  if (const auto idle = traj::idle_rule(rules, flights)) {
    throw UsageError(fmt::format("{}, and {} has none: leave it out", *idle, source));
  }
}

void DroneFileOptions::add_mission_to(CLI::App& parser) {
  parser
      .add_option("--acceptance", reading.rules.acceptance,
                  "a mission's vehicle may turn so many metres before a waypoint where it does not "
                  "rest, 0: not at all (default: 2, or 10 where the item says nothing); never less "
                  "than the item says")
      ->check(CLI::Range(0.0, 1e4));
  parser
      .add_option("--braking", reading.rules.braking,
                  "how hard it brakes, m/s2: what it needs more than that distance is looked at "
                  "beyond the waypoint (default 3)")
      ->check(CLI::Range(0.1, 100.0));
  add_heights_to(parser);
}

void DroneFileOptions::add_heights_to(CLI::App& parser) {
  parser
      .add_option("--return-height", reading.rules.return_height,
                  "metres above home at which a mission's return is flown; without it, a mission "
                  "with a return fails the check")
      ->check(CLI::Range(0.0, 1e4));
  parser
      .add_option("--terrain-height", reading.rules.ground,
                  "the map's z of flat ground, from which a mission's heights above terrain count")
      ->check(CLI::Range(-1e6, 1e6));
  terrain.add_to(parser);
}

std::vector<traj::FileFlight> read_drone_file(const std::string& text, const std::string& source,
                                              const DroneFileOptions& options,
                                              const geom::Frame& frame) {
  if (text.starts_with("id,t_s,")) {
    throw geom::InputError(source,
                           {.says = "this is a flight log: skyway-check holds it against a map"});
  }
  const traj::MissionFormat* const named = traj::mission_format_named(options.format);
  const traj::MissionFormat& format = named ? *named : traj::recognised_mission_format(text);
  options.require_used(format.format.word, read_as(source, format.format.word));
  traj::MissionReading reading = options.reading;
  reading.flier = options.autopilot.flier;
  return traj::read_mission(text, source, format, reading, frame);
}

}  // namespace cli
