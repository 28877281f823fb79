// skyway-query: hits, clearance and nearest boxes of points, segments and boxes.

#include <fmt/format.h>

#include <limits>

#include "cli/files.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/io/json_fields.h"

namespace {

using geom::Vec3;

void append_nearest(std::string& out, const geom::CollisionScene& scene, const Vec3& p) {
  const auto near = scene.nearest(p, std::numeric_limits<double>::infinity());
  if (!near) return;
  out += ",\"clearance\":";
  geom::append_json(out, near->distance);
  out += fmt::format(",\"nearest\":{}", scene.map().ids()[near->box]);
}

std::string answer_point(const geom::CollisionScene& scene, const Vec3& p) {
  std::string out =
      fmt::format(R"("hit":{},"inside_bounds":{})", scene.hits(p), scene.inside_bounds(p));
  append_nearest(out, scene, p);
  return out;
}

std::string answer_segment(const geom::CollisionScene& scene, const Vec3& a, const Vec3& b) {
  return fmt::format(R"("hit":{},"inside_bounds":{})", scene.hits(a, b),
                     scene.inside_bounds(a) && scene.inside_bounds(b));
}

std::string answer_box(const geom::CollisionScene& scene, const geom::Aabb& box) {
  std::string ids;
  const auto found = scene.boxes_meeting(box);
  for (const std::size_t i : found) {
    ids += fmt::format("{}{}", ids.empty() ? "" : ",", scene.map().ids()[i]);
  }
  return fmt::format(R"("hit":{},"boxes":[{}])", !found.empty(), ids);
}

std::string answer(const geom::CollisionScene& scene, const std::string& text,
                   const std::string& source, std::size_t line) {
  const geom::JsonFields fields(text, source, line);
  std::string out = "{\"type\":\"answer\",\"id\":";
  geom::append_json(out, std::string_view(fields.text("id", fmt::format("q{}", line))));
  out += ',';
  const auto pair = [&](const char* key) {
    const auto points = fields.points(key);
    if (points.size() != 2)
      fields.refuse(fmt::format("{} must be two points, found {}", key, points.size()));
    return std::pair(points[0], points[1]);
  };
  if (fields.has("point")) {
    out += answer_point(scene, fields.point("point"));
  } else if (fields.has("segment")) {
    const auto [a, b] = pair("segment");
    out += answer_segment(scene, a, b);
  } else if (fields.has("box")) {
    const auto [low, high] = pair("box");
    if ((low.array() > high.array()).any()) fields.refuse("box must have min <= max on every axis");
    out += answer_box(scene, {low, high});
  } else {
    fields.refuse("expected one of the keys \"point\", \"segment\" and \"box\", found none");
  }
  return out + "}\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Ask the collision structure of a box map (JSON Lines in, JSON Lines out).",
               "skyway-query"};
  cli::Common common(app);
  cli::VehicleOptions vehicle;
  std::string map_file;
  std::string input = "-";
  std::string output = "-";
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("file", input,
                 "records with \"point\":[x,y,z], \"segment\":[[…],[…]] or \"box\":[[min],[max]] "
                 "(default: stdin)");
  app.add_option("-o,--output", output, "answers (default: stdout)");
  vehicle.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, input});
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    cli::InputFile file(input);
    cli::OutputFile out(output, cli::OutputKind::text);
    file.for_each_line([&](const std::string& line, std::size_t number) {
      out.stream() << answer(scene, line, file.name(), number);
    });
    out.commit();
    return cli::Exit::yes;
  });
}
