#include "flight_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/content/drone_file.h"
#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/base/in_order.h"
#include "geom/text/record_lines.h"
#include "traj/submit/flight_pairs.h"

namespace submitting {
namespace {

constexpr std::size_t kHeld = 64;     // flights at a time
constexpr std::size_t kMostTold = 5;  // refusals, on stderr

}  // namespace

void FlightFiles::take(Made made, const std::string& source) {
  if (!made.parts.refusal.empty()) {
    if (++refused_ > kMostTold) return;
    cli::complain("skyway-submit",
                  fmt::format("{}: refused: {}", made.parts.id, made.parts.refusal));
    return;
  }
  const std::string name = names_.of(made.parts.id, source);
  made.parts.claims.volumes = traj::volumes_file(name);
  made.parts.claims.risk = traj::risk_file(name);
  folder_.add(made.parts.claims.volumes, made.parts.volumes);
  folder_.add(made.parts.claims.risk, made.parts.risk);
  if (!made.record.empty()) take_record(made, source);
  claims_.push_back(std::move(made.parts.claims));
  buffers_.push_back(std::move(made.parts.buffers));
}

void FlightFiles::take_record(const Made& made, const std::string& source) {
  if (!records_) {
    records_.emplace("flights.jsonl", folder_.place_of("flights.jsonl"));
    certificates_.emplace("certificates.jsonl", folder_.place_of("certificates.jsonl"));
  }
  records_->append(made.record);
  certificates_->append(made.parts.certificate);
  if (!set_) return;
  dynamic_cast<const traj::SubmittedTrajectory&>(*made.flight.flight)
      .add_to(*set_, source, made.line);
}

std::optional<traj::FlightPairs> FlightFiles::compare() {
  if (!set_) return std::nullopt;
  const traj::ComparedFlights compared = traj::compare_flights(*set_, common_.execution("pairs"));
  folder_.add("pairs.jsonl", compared.records);
  if (!compared.certificates.empty()) {
    folder_.add("pair_certificates.jsonl", compared.certificates);
  }
  return compared.found;
}

void FlightFiles::add(const std::string& path, const geom::BoxMap& map) {
  cli::InputFile file(path);
  cli::DroneFileOptions kind;
  kind.settle(file);
  if (kind.is_flight_log()) {
    throw geom::InputError(file.name(),
                           {.expected = "trajectories or a mission", .found = "a flight log"});
  }
  if (!kind.format.empty()) {
    return add_mission(path, file.read_all(), map);
  }
  struct Item {
    geom::RecordLine line;
    Made made = {};
  };
  geom::RecordLines lines(file.stream(), file.name());
  const auto next = [&]() -> std::optional<Item> {
    if (auto line = lines.next()) return Item{*std::move(line)};
    return std::nullopt;
  };
  const auto work = [&](Item& item) {
    traj::FlightInScene flight = flights_.of_record(item.line.text, file.name(), item.line.number);
    item.made.parts = traj::flight_parts(*flight.flight, map);
    item.made.record = std::move(item.line.text) + '\n';
    item.made.line = item.line.number;
    if (set_) item.made.flight = std::move(flight);
  };
  geom::in_order<Item>(common_.execution("flights"), kHeld, next, work,
                       [&](Item& item) { take(std::move(item.made), file.name()); });
}

void FlightFiles::add_mission(const std::string& path, const std::string& text,
                              const geom::BoxMap& map) {
  const std::string name = std::filesystem::path(path).filename().string();
  if (std::find(missions_.begin(), missions_.end(), name) != missions_.end()) {
    throw cli::UsageError(fmt::format("two missions are named {}: rename one", name));
  }
  for (const auto& one : flights_.of_mission(text, path)) {
    const traj::ReportRecord& report = one.flight->report();
    for (const std::string& note : one.notes) common_.warn(report.id + ": " + note);
    terrain_use_.take(report);
    ends_at_home_ = ends_at_home_ || one.ends_at_home;
    of_missions_.push_back({traj::flight_parts(*one.flight, map)});
  }
  missions_.push_back(name);
  folder_.add("missions/" + name, text);
}

void FlightFiles::write() {
  for (Made& one : of_missions_) take(std::move(one), "missions");
  has_records_ = records_.has_value();
  if (!records_) return;
  folder_.add(*records_);
  folder_.add(*certificates_);
  records_.reset();
  certificates_.reset();
}

}  // namespace submitting
