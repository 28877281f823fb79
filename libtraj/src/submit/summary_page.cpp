#include "traj/submit/summary_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "assumptions.h"
#include "geom/text/counted.h"
#include "geom/text/markup.h"
#include "geom/text/rounded.h"

namespace traj {
namespace {

constexpr const char* kStyle = R"(
body { font: 11pt/1.45 "DejaVu Sans", Verdana, sans-serif; color: #111; background: #fff;
       max-width: 62em; margin: 2em auto; padding: 0 1.5em; }
h1 { font-size: 20pt; margin: 0 0 .2em; }
h2 { font-size: 13pt; margin: 1.6em 0 .4em; border-bottom: 1px solid #888; break-after: avoid; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .25em .6em .25em 0;
         border-bottom: 1px solid #ddd; }
thead th { border-bottom: 1px solid #555; }
thead { display: table-header-group; }
tr { break-inside: avoid; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
table.said th { width: 14em; font-weight: normal; color: #444; }
.flights { font-size: 9pt; }
code { font-family: "DejaVu Sans Mono", monospace; font-size: 9.5pt; }
pre { background: #f3f3f3; padding: .6em; overflow-x: auto; }
.hash { word-break: break-all; font-size: 8.5pt; }
p.note { color: #444; }
@media print { body { margin: 0; max-width: none; padding: 0; font-size: 9.5pt; } }
@page { margin: 18mm 16mm; }
)";

std::string said(std::string_view text) { return geom::escaped_markup(text); }

// Tables round to the safe side.
constexpr double kClearanceRoom = 1e-3;  // metres, by which a clearance may be less than was found

class Page {
 public:
  Page(const Operation& operation, const Submission& submission,
       std::span<const FlightClaims> flights)
      : operation_(operation),
        submission_(submission),
        method_(submission.method),
        flights_(flights) {}

  std::string html() {
    out_ = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<title>Flights of {}</title>\n<style>{}</style>\n</head>\n<body>\n",
        said(operation_.by.name), kStyle);
    head();
    proved();
    assumed();
    volumes();
    flights();
    ground();
    files();
    return out_ + "</body>\n</html>\n";
  }

 private:
  void heading(std::string_view text) { out_ += fmt::format("<h2>{}</h2>\n", said(text)); }
  void begin_table() { out_ += "<table class=\"said\">\n"; }
  void row(std::string_view what, std::string_view value) {
    if (value.empty()) return;
    out_ += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", said(what), said(value));
  }
  void end_table() { out_ += "</table>\n"; }
  void item(const std::string& text) { out_ += fmt::format("<li>{}</li>\n", said(text)); }

  void head() {
    out_ +=
        fmt::format("<h1>{}</h1>\n<p>{}. Made by {}.</p>\n",
                    operation_.what.empty() ? "Flights and their proofs" : said(operation_.what),
                    said(geom::counted(submission_.flights, "flight")), said(submission_.made_by));
    heading("Operator and vehicle");
    begin_table();
    row("Operator", operation_.by.name);
    row("Registration", operation_.by.registration);
    row("Contact", operation_.by.contact);
    const Uas& uas = operation_.uas;
    row("Vehicle", uas.manufacturer.empty() ? uas.model : uas.manufacturer + " " + uas.model);
    row("Serial number", uas.serial);
    row("Class", uas.uas_class);
    row("Characteristic dimension", fmt::format("{:g} m", uas.dimension));
    if (uas.mass) row("Take-off mass", fmt::format("{:g} kg", *uas.mass));
    if (uas.endurance) row("Endurance", fmt::format("{:g} s", *uas.endurance));
    row("If the link is lost", operation_.lost_link);
    if (!flights_.empty()) {
      const auto first =
          std::min_element(flights_.begin(), flights_.end(),
                           [](const auto& a, const auto& b) { return a.begins < b.begins; });
      const auto last =
          std::max_element(flights_.begin(), flights_.end(),
                           [](const auto& a, const auto& b) { return a.ends < b.ends; });
      rooms();
      row("From", first->begins);
      row("Until", last->ends);
    }
    end_table();
  }

  // The boxes and margins for which flights are proved, each once.
  void rooms() {
    std::vector<std::string> said_before;
    for (const FlightClaims& one : flights_) {
      std::string room = fmt::format(
          "{}: a box of {:.3g} x {:.3g} x {:.3g} m, which holds the vehicle in every attitude that "
          "it takes, and a margin of {:g} m on every side",
          one.vehicle.empty() ? "vehicle" : one.vehicle, 2 * one.half.x(), 2 * one.half.y(),
          2 * one.half.z(), one.margin);
      if (std::find(said_before.begin(), said_before.end(), room) != said_before.end()) continue;
      row("Room that is proved clear", room);
      said_before.push_back(std::move(room));
    }
  }

  void proved() {
    heading("What is proved");
    out_ += "<ul>\n";
    if (has_kind(flights_, "trajectory")) {
      item(
          "Every trajectory is clear of every obstacle of the map, at every instant, with the "
          "vehicle's size and its margin; it stays within the map's bounds and its limits on "
          "speed and acceleration. This was checked in exact numbers, and certificates.jsonl "
          "holds the reasons.");
      item(method_.tubes
               ? fmt::format(
                     "Each trajectory has a tube of at most {:.3g} m, which is clear of every "
                     "obstacle: the simulated vehicle never leaves it. The nominal volumes hold "
                     "that vehicle with the buffer, wherever in its tube it is, at every instant.",
                     geom::rounded_up(widest_tube(flights_), 3))
               : "The nominal volumes hold the vehicle with its margin and the buffer at every "
                 "instant of each trajectory.");
    }
    if (has_kind(flights_, "mission")) {
      item(
          "Every mission file is clear of every obstacle of the map wherever the vehicle may be "
          "while it flies the file: by the model of the autopilot's firmware, or on its way and in "
          "its turns where the file is DJI's. Its volumes hold all of these places.");
    }
    if (method_.risk.contingency == ContingencyRule::ways_home) {
      item("The off-nominal volumes hold every return of the autopilot, from every instant.");
    }
    item(
        "Contingency volumes and ground risk buffers reach as far around these as the formulas "
        "below say.");
    if (submission_.population) {
      item(
          "The number of people is that of all cells of the raster which a ground risk buffer "
          "touches, each counted whole.");
    }
    pairs();
    if (method_.energy && has_kind(flights_, "trajectory")) {
      item(
          "Each trajectory ends before the battery is down to its reserve, at the largest power "
          "that the vehicle's profile names.");
    }
    out_ += "</ul>\n";
  }

  // How far apart flights keep, in words.
  std::string spacing() const {
    const Spacing& asked = method_.together->spacing;
    std::string out = "the boxes that hold them, with their margins, never touch";
    if (const auto& zone = asked.zone) {
      out = zone->round
                ? fmt::format("{:g} m across or {:g} m in height", zone->reach.x(), zone->reach.z())
                : fmt::format("{:g}, {:g} or {:g} m along the map's axes", zone->reach.x(),
                              zone->reach.y(), zone->reach.z());
    }
    if (const auto& zone = asked.downwash) {
      out += fmt::format(", and no flight is within {:g} m across and {:g} m below another",
                         zone->reach.x(), zone->reach.z());
    }
    return out + (method_.together->parked == Parked::pad
                      ? "; before and after its flight each stands where it begins and ends"
                      : "; before and after its flight none is there");
  }

  void pairs() {
    if (!submission_.pairs) return;
    const FlightPairs& found = *submission_.pairs;
    if (found.refused == 0) {
      item(fmt::format(
          "At every instant the trajectories keep apart from each other ({} compared): {}. "
          "pair_certificates.jsonl holds the reasons.",
          geom::counted(found.compared, "pair"), spacing()));
      return;
    }
    std::string named;
    for (const auto& [one, other] : found.named) {
      named += fmt::format("{}{} and {}", named.empty() ? "" : "; ", one, other);
    }
    item(
        fmt::format("{} of {} of trajectories come too near to one another: {}{}. "
                    "Asked for: {}. All others keep apart.",
                    found.refused, geom::counted(found.compared, "pair"), named,
                    found.named.size() < found.refused ? "; pairs.jsonl has all" : "", spacing()));
  }

  void assumed() {
    heading("What was assumed, and is not proved");
    out_ += "<ul>\n";
    for (const std::string& one : assumptions(submission_, flights_)) item(one);
    out_ += "</ul>\n";
  }

  void volumes() {
    heading("Volumes, and their formulas");
    out_ += "<table>\n<thead><tr><th>volume</th><th>formula</th><th>source</th></tr></thead>\n";
    for (const RiskFormula& one : formulas(method_.risk)) {
      out_ += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", said(one.what),
                          said(one.formula), said(one.source));
    }
    out_ += "</table>\n";
    out_ += fmt::format(
        "<p class=\"note\">V: the limit on the flight's speed. g: 9.80665 m/s². CD: {:g} m. H_CV: "
        "the top of a contingency volume above {:g} m. The volumes stand in "
        "<code>volumes/</code> (ASTM F3548) and <code>risk/</code> (GeoJSON).</p>\n",
        method_.risk.dimension, method_.floor);
    smallest_geography();
  }

  // Every volume holds the vehicle's box, with its margin and the buffer: never less than that.
  void smallest_geography() {
    if (flights_.empty()) return;
    double across = std::numeric_limits<double>::infinity();
    double height = across;
    for (const FlightClaims& one : flights_) {
      const double beyond = 2 * ((method_.tubes ? 0 : one.margin) + method_.buffer);
      across = std::min(across, 2 * std::min(one.half.x(), one.half.y()) + beyond);
      height = std::min(height, 2 * one.half.z() + beyond);
    }
    const double least = least_geography(method_.risk);
    const bool enough = across >= least && height >= least;
    out_ += fmt::format(
        "<p>{} flight geography is at least {:g} m wide and {:g} m high. LBA's guideline asks "
        "for 3 CD ({:g} m){}.</p>\n",
        flights_.size() == 1 ? "The" : "Every", std::floor(100 * across) / 100,
        std::floor(100 * height) / 100, least,
        enough ? "" : ", and <strong>this is less</strong>: a larger --buffer makes it larger");
  }

  std::vector<std::size_t> rows() const {
    std::vector<std::size_t> out(flights_.size());
    std::iota(out.begin(), out.end(), 0u);
    if (out.size() <= kMostRows) return out;
    const auto before = [&](std::size_t i, std::size_t k) {
      const FlightClaims& a = flights_[i];
      const FlightClaims& b = flights_[k];
      if (a.people != b.people) return a.people.value_or(0) > b.people.value_or(0);
      return a.clearance.value_or(1e9) < b.clearance.value_or(1e9);
    };
    std::stable_sort(out.begin(), out.end(), before);
    out.resize(kMostRows);
    return out;
  }

  void flights() {
    heading("Flights");
    const std::vector<std::size_t> shown = rows();
    if (shown.size() < flights_.size()) {
      out_ += fmt::format(
          "<p>{} of {} flights: those with the most people below, then those that come nearest to "
          "an obstacle. <code>claims.jsonl</code> has all.</p>\n",
          shown.size(), flights_.size());
    }
    const bool people = submission_.population.has_value();
    const bool energy = method_.energy.has_value();
    const bool returns = method_.risk.contingency == ContingencyRule::ways_home;
    out_ +=
        "<table class=\"flights\">\n<thead><tr><th>flight</th><th>begins</th>"
        "<th class=\"n\">lasts s</th><th class=\"n\">speed m/s</th>"
        "<th class=\"n\">clearance m</th><th class=\"n\">top m</th>";
    out_ += returns ? "<th class=\"n\">returns %</th>" : "<th class=\"n\">contingency m</th>";
    out_ += "<th class=\"n\">ground buffer m</th>";
    if (energy) out_ += "<th class=\"n\">energy Wh</th>";
    if (people) out_ += "<th class=\"n\">people</th>";
    out_ += "</tr></thead>\n";
    for (const std::size_t i : shown) {
      const FlightClaims& one = flights_[i];
      out_ += fmt::format(
          "<tr><td>{}</td><td>{}</td><td class=\"n\">{:.1f}</td><td class=\"n\">{:g}</td>"
          "<td class=\"n\">{}</td><td class=\"n\">{:.1f}</td><td class=\"n\">{}</td>"
          "<td class=\"n\">{:.1f}</td>",
          said(one.id), said(one.begins), geom::rounded_up_to(one.duration, 0.1), one.speed,
          one.clearance
              ? fmt::format("{:.2f}", geom::rounded_down_to(
                                          std::max(0.0, *one.clearance - kClearanceRoom), 0.01))
              : "",
          geom::rounded_up_to(one.top, 0.1),
          returns ? fmt::format("{:.4g}", geom::rounded_down(100 * one.returns.value_or(0)))
                  : fmt::format("{:.1f}", geom::rounded_up_to(one.contingency.across, 0.1)),
          geom::rounded_up_to(one.buffer, 0.1));
      if (energy)
        out_ += fmt::format("<td class=\"n\">{:.1f}</td>",
                            geom::rounded_up_to(one.energy.value_or(0) / 3600, 0.1));
      if (people)
        out_ += fmt::format("<td class=\"n\">{:.0f}</td>",
                            geom::rounded_up_to(one.people.value_or(0), 1));
      out_ += "</tr>\n";
    }
    out_ += "</table>\n";
  }

  void source_row(const char* what, const SourceFile& file) {
    out_ += fmt::format(
        "<tr><th>{}</th><td>{}{}<br><span class=\"hash\">SHA-256 {}</span></td></tr>\n", what,
        said(file.name), file.date.empty() ? "" : ", of " + said(file.date), said(file.sha256));
  }

  void ground() {
    heading("Sources");
    begin_table();
    if (method_.made_for.map) {
      out_ += fmt::format(
          "<tr><th>Map</th><td>map.boxmap<br><span class=\"hash\">{}</span></td></tr>\n",
          said(*method_.made_for.map));
    }
    if (submission_.population) source_row("Population", *submission_.population);
    if (method_.tubes) source_row("Proved tubes", *method_.tubes);
    if (method_.ground_model) source_row("Ground", *method_.ground_model);
    for (const SourceFile& zone : submission_.zones) source_row("Zones", zone);
    end_table();
  }

  void files() {
    heading("How to check this folder");
    out_ +=
        "<p><code>manifest.json</code> lists every other file with its SHA-256. Skyway proves the "
        "folder with</p>\n<pre>skyway-check FOLDER</pre>\n"
        "<p>Scripts that share no code with it, and need only Python, are in the folder:</p>\n"
        "<pre>python3 FOLDER/verify/verify_folder.py FOLDER</pre>\n"
        "<p class=\"note\"><code>page.html</code>, where it is there, shows map and flights. It is "
        "for "
        "looking, and nothing is proved of it.</p>\n";
  }

  const Operation& operation_;
  const Submission& submission_;
  const SubmissionMethod& method_;
  std::span<const FlightClaims> flights_;
  std::string out_;
};

}  // namespace

std::string summary_page(const Operation& operation, const Submission& submission,
                         std::span<const FlightClaims> flights) {
  return Page(operation, submission, flights).html();
}

}  // namespace traj
