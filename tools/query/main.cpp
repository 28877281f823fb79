// skyway-query: hits, clearance and nearest boxes of points, segments and boxes.

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/map/geographic_frame.h"
#include "geom/record/locator.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace {

using geom::JsonFields;
using geom::JsonLine;
using geom::Vec3;

constexpr std::size_t kBatch = 4096;  // records answered at once, in order

using Line = std::pair<std::string, std::size_t>;  // and its number

// What the record's key says, or nothing; a whole number in [1, 1000].
std::optional<std::size_t> whole(const JsonFields& fields, const char* key) {
  const auto value = fields.number(key);
  if (!value) return std::nullopt;
  if (!(*value >= 1 && *value <= 1000) || *value != std::floor(*value)) {
    fields.refuse({.key = std::string(key),
                   .expected = "a whole number from 1 to 1000",
                   .found = fmt::to_string(*value)});
  }
  return static_cast<std::size_t>(*value);
}

std::optional<double> metres(const JsonFields& fields, const char* key) {
  const auto value = fields.number(key);
  if (value && !(*value >= 0 && *value <= 1000)) {
    fields.refuse({.key = std::string(key),
                   .expected = "metres from 0 to 1000",
                   .found = fmt::to_string(*value)});
  }
  return value;
}

std::pair<Vec3, Vec3> two_points(const JsonFields& fields, const char* key) {
  const auto points = fields.points(key);
  if (points.size() != 2) {
    fields.refuse({.key = std::string(key),
                   .expected = "two points",
                   .found = fmt::to_string(points.size())});
  }
  return {points[0], points[1]};
}

// The points of a record in metres, as far as it is one.
std::vector<Vec3> points_of(const std::string& text) {
  std::vector<Vec3> out;
  try {
    const JsonFields fields(text, "", 0);
    if (fields.has("point") && !fields.value("point").is_string()) {
      out.push_back(fields.point("point"));
    }
    for (const char* key : {"segment", "box", "sweep"}) {
      if (!fields.has(key)) continue;
      for (const Vec3& p : fields.points(key)) out.push_back(p);
    }
  } catch (const geom::InputError&) {  // is told when the record's turn comes
  }
  return out;
}

// Throws where a batch looks like degrees: the two points of a record, or all single ones, of which
// one in a million is near enough by chance.
void require_metres(const std::vector<Line>& batch, const geom::Frame& frame,
                    const cli::MetresOption& metres, const std::string& source) {
  std::vector<Vec3> single;
  std::size_t first = 0;
  for (const auto& [text, line] : batch) {
    const std::vector<Vec3> points = points_of(text);
    if (points.size() > 1) metres.check_input(frame, points, source, line);
    if (points.size() != 1) continue;
    if (single.empty()) first = line;
    single.push_back(points[0]);
  }
  metres.check_input(frame, single, source, first);
}

// "60.1719000N,24.9414000E": seven decimals are a centimetre.
std::string in_degrees(const geom::GeodeticPlace& place) {
  return fmt::format("{:.7f}{},{:.7f}{}", std::abs(place.latitude), place.latitude < 0 ? 'S' : 'N',
                     std::abs(place.longitude), place.longitude < 0 ? 'W' : 'E');
}

class Answers {
 public:
  // `degrees`: points are answered with their latitude and longitude.
  Answers(const geom::CollisionScene& scene, bool degrees) : scene_(scene), locator_(scene.map()) {
    const geom::Frame& frame = scene.map().spec().frame;
    if (!degrees) return;
    if (!geom::counts_from_origin(frame)) {
      throw cli::UsageError("--degrees: the map has no origin on Earth");
    }
    earth_.emplace(*frame.origin);
  }

  std::string answer(const std::string& text, const std::string& source, std::size_t line) const {
    const JsonFields fields(text, source, line);
    JsonLine out;
    out.add("type", "answer").add("id", fields.text("id", fmt::format("q{}", line)));
    if (fields.has("point")) {
      add_point(out, fields, place_of(fields, source, line));
    } else if (fields.has("segment")) {
      add_segment(out, fields);
    } else if (fields.has("box")) {
      add_box(out, fields);
    } else if (fields.has("sweep")) {
      add_sweep(out, fields);
    } else {
      fields.refuse({.expected = "one of the keys \"point\", \"segment\", \"box\" and \"sweep\"",
                     .found = "none"});
    }
    return out.line();
  }

 private:
  std::uint64_t id(std::size_t box) const { return scene_.map().ids()[box]; }

  // Metres, or a text as skyway-plan --from takes it.
  Vec3 place_of(const JsonFields& fields, const std::string& source, std::size_t line) const {
    if (!fields.value("point").is_string()) return fields.point("point");
    const std::string text = fields.text("point");
    const auto place = geom::parse_place(text);
    if (!place)
      fields.refuse({.key = "point",
                     .expected = std::string(geom::kPlaceForms),
                     .found = geom::in_quotes(text)});
    return locator_.at(*place, source, line);
  }

  void add_point(JsonLine& out, const JsonFields& fields, const Vec3& p) const {
    if (fields.value("point").is_string()) out.add("point", p);
    if (earth_) {
      const geom::Axes axes = scene_.map().spec().frame.axes;
      out.add("place", in_degrees(earth_->place(geom::to_enu(axes, p))));
    }
    out.add("hit", scene_.hits(p)).add("inside_bounds", scene_.inside_bounds(p));
    const auto k = whole(fields, "k");
    const auto near = scene_.nearest(p, std::numeric_limits<double>::infinity(), k.value_or(1));
    if (near.empty()) return;
    out.add("clearance", near.front().distance);
    if (k) {
      out.add("nearest", near, [&](const geom::Nearest& n) {
        return JsonLine().add("box", id(n.box)).add("distance", n.distance);
      });
    } else {
      out.add("nearest", id(near.front().box));
    }
  }

  void add_segment(JsonLine& out, const JsonFields& fields) const {
    const auto [a, b] = two_points(fields, "segment");
    out.add("hit", scene_.hits(a, b));
    out.add("inside_bounds", scene_.inside_bounds(a) && scene_.inside_bounds(b));
    if (const auto reach = metres(fields, "planes")) {
      const auto planes = scene_.separating_planes(a, b, *reach);
      out.add("planes", planes, [&](const geom::CollisionScene::Separated& s) {
        const auto& [plane, gap] = s.separation;
        JsonLine line;
        line.add("box", id(s.box)).add("normal", plane.normal).add("offset", plane.offset);
        return line.add("gap", gap);
      });
    }
    if (const auto reach = metres(fields, "empty_box")) {
      if (const auto found = scene_.empty_box(a, b, *reach)) {
        out.add("empty_box", std::tuple(found->box.min, found->box.max));
        out.add("largest", found->largest);
      } else {
        out.add("empty_box", nullptr);
      }
    }
  }

  void add_box(JsonLine& out, const JsonFields& fields) const {
    const auto [low, high] = two_points(fields, "box");
    if ((low.array() > high.array()).any())
      fields.refuse({.says = "box must have min <= max on every axis"});
    const auto found = scene_.boxes_meeting({low, high});
    out.add("hit", !found.empty());
    out.add("boxes", found, [&](std::size_t i) { return id(i); });
  }

  void add_sweep(JsonLine& out, const JsonFields& fields) const {
    const auto [a, b] = two_points(fields, "sweep");
    const Vec3 half = fields.point("half");
    if (half.minCoeff() < 0) fields.refuse({.says = "half must have half sizes >= 0"});
    out.add("hit", scene_.sweep_hits(a, b, half));
  }

  const geom::CollisionScene& scene_;
  geom::Locator locator_;
  std::optional<geom::GeographicFrame> earth_;
};

// Lines of a stream and their answers, batch after batch.
class Stream {
 public:
  Stream(const geom::CollisionScene& scene, bool degrees, const cli::InputFile& file,
         cli::OutputFile& out, const geom::Execution& run)
      : answers_(scene, degrees), file_(file), out_(out), run_(run) {}

  const std::vector<Line>& batch() const { return batch_; }

  // Whether the batch is full.
  bool add(const std::string& line, std::size_t number) {
    batch_.emplace_back(line, number);
    return batch_.size() == kBatch;
  }

  // Of a malformed record, what stood before it is answered and the rest is not.
  void answer() {
    std::vector<std::string> lines(batch_.size());
    try {
      geom::parallel_for(batch_.size(), run_, [&](std::size_t i) {
        lines[i] = answers_.answer(batch_[i].first, file_.name(), batch_[i].second);
      });
    } catch (const geom::InputError&) {
      write(lines);
      out_.flush();
      throw;
    }
    write(lines);
    batch_.clear();
  }

 private:
  void write(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      if (line.empty()) break;  // the malformed record
      out_.stream() << line;
    }
  }

  Answers answers_;
  const cli::InputFile& file_;
  cli::OutputFile& out_;
  geom::Execution run_;
  std::vector<Line> batch_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Ask the collision structure of a box map (JSON Lines in, JSON Lines out).",
               "skyway-query"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  std::string map_file;
  std::string input = "-";
  std::string output = "-";
  cli::MetresOption metres;
  bool degrees = false;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option(
      "file", input,
      "records with \"point\":[x,y,z] or \"60.1719N,24.9414E,30\" (\"k\":N nearest boxes), "
      "\"segment\":[[…],[…]] "
      "(\"planes\":REACH, \"empty_box\":REACH), \"box\":[[min],[max]] or "
      "\"sweep\":[[…],[…]] with \"half\":[x,y,z] (default: stdin)");
  cli::add_output(app, "-o,--output", output, "answers (default: stdout)");
  metres.add_to(app);
  app.add_flag("--degrees", degrees, "answer points with their latitude and longitude");
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, input});
    cli::Scenes scenes(cli::open_map(map_file, geom::Verified::extents, common.execution("verify")),
                       vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    cli::InputFile file(input);
    cli::OutputFile out(output, cli::OutputKind::text);
    Stream stream(scene, degrees, file, out, {common.execution("queries").threads, {}});
    const auto answer = [&] {
      require_metres(stream.batch(), scene.map().spec().frame, metres, file.name());
      stream.answer();
    };
    file.for_each_line([&](const std::string& line, std::size_t number) {
      if (stream.add(line, number)) answer();
    });
    answer();
    out.commit();
    common.write_stats({{"collision", scenes.stats()}});
    return cli::Exit::yes;
  });
}
