#include "geom/record/scene_answers.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/record/made_for_another.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

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

// "60.1719000N,24.9414000E": seven decimals are a centimetre.
std::string in_degrees(const GeodeticPlace& place) {
  return fmt::format("{:.7f}{},{:.7f}{}", std::abs(place.latitude), place.latitude < 0 ? 'S' : 'N',
                     std::abs(place.longitude), place.longitude < 0 ? 'W' : 'E');
}

struct IdleKey {
  const char* key;
  const char* question;  // that alone uses it
};
constexpr IdleKey kKeysOfOne[] = {
    {"k", "point"}, {"planes", "segment"}, {"empty_box", "segment"}, {"half", "sweep"}};

// The question that the record asks: one.
std::string question_of(const JsonFields& fields) {
  constexpr const char* kExpected = "one of the keys \"point\", \"segment\", \"box\" and \"sweep\"";
  std::string asked;
  for (const char* key : {"point", "segment", "box", "sweep"}) {
    if (!fields.has(key)) continue;
    if (!asked.empty()) {
      fields.refuse({.expected = kExpected,
                     .found = fmt::format("\"{}\" and \"{}\"", asked, key),
                     .advice = "make a record of each"});
    }
    asked = key;
  }
  if (asked.empty()) fields.refuse({.expected = kExpected, .found = "none"});
  for (const auto& [key, question] : kKeysOfOne) {
    if (!fields.has(key) || asked == question) continue;
    fields.refuse({.says = fmt::format("\"{}\" is only for \"{}\", and would change nothing beside "
                                       "\"{}\"",
                                       key, question, asked),
                   .advice = "leave it out"});
  }
  return asked;
}

}  // namespace

SceneAnswers::SceneAnswers(const CollisionScene& scene, bool degrees)
    : scene_(scene), ours_(provenance_of(scene)), locator_(scene.map()) {
  const Frame& frame = scene.map().spec().frame;
  if (!degrees) return;
  if (!counts_from_origin(frame)) {
    throw UsageError("--degrees: the map has no origin on Earth");
  }
  earth_.emplace(*frame.origin);
}

std::string SceneAnswers::answer(const std::string& text, const std::string& source,
                                 std::size_t line) const {
  const JsonFields fields(text, source, line);
  JsonLine out;
  out.add("type", "answer").add("id", fields.text("id", fmt::format("q{}", line)));
  const std::string question = question_of(fields);
  require_asked_of(read_provenance(fields), ours_, source, line);
  if (question == "point") {
    add_point(out, fields, place_of(fields, source, line));
  } else if (question == "segment") {
    add_segment(out, fields);
  } else if (question == "box") {
    add_box(out, fields);
  } else {
    add_sweep(out, fields);
  }
  return out.line();
}

// Metres, or a text as skyway-plan --from takes it.
Vec3 SceneAnswers::place_of(const JsonFields& fields, const std::string& source,
                            std::size_t line) const {
  if (!fields.value("point").is_string()) return fields.point("point");
  const std::string text = fields.text("point");
  const auto place = parse_place(text);
  if (!place)
    fields.refuse({.key = "point", .expected = std::string(kPlaceForms), .found = in_quotes(text)});
  return locator_.at(*place, source, line);
}

void SceneAnswers::add_point(JsonLine& out, const JsonFields& fields, const Vec3& p) const {
  if (fields.value("point").is_string()) out.add("point", p);
  if (earth_) {
    const Axes axes = scene_.map().spec().frame.axes;
    out.add("place", in_degrees(earth_->place(to_enu(axes, p))));
  }
  out.add("hit", scene_.hits(p)).add("inside_bounds", scene_.inside_bounds(p));
  const auto k = whole(fields, "k");
  const auto near = scene_.nearest(p, std::numeric_limits<double>::infinity(), k.value_or(1));
  if (near.empty()) return;
  out.add("clearance", near.front().distance);
  if (k) {
    out.add("nearest", near, [&](const Nearest& n) {
      return JsonLine().add("box", id(n.box)).add("distance", n.distance);
    });
  } else {
    out.add("nearest", id(near.front().box));
  }
}

void SceneAnswers::add_segment(JsonLine& out, const JsonFields& fields) const {
  const auto [a, b] = two_points(fields, "segment");
  out.add("hit", scene_.hits(a, b));
  out.add("inside_bounds", scene_.inside_bounds(a) && scene_.inside_bounds(b));
  if (const auto reach = metres(fields, "planes")) {
    const auto planes = scene_.separating_planes(a, b, *reach);
    out.add("planes", planes, [&](const CollisionScene::Separated& s) {
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

void SceneAnswers::add_box(JsonLine& out, const JsonFields& fields) const {
  const auto [low, high] = two_points(fields, "box");
  if ((low.array() > high.array()).any())
    fields.refuse({.says = "box must have min <= max on every axis"});
  const auto found = scene_.boxes_meeting({low, high});
  out.add("hit", !found.empty());
  out.add("boxes", found, [&](std::size_t i) { return id(i); });
}

void SceneAnswers::add_sweep(JsonLine& out, const JsonFields& fields) const {
  const auto [a, b] = two_points(fields, "sweep");
  const Vec3 half = fields.point("half");
  if (half.minCoeff() < 0) fields.refuse({.says = "half must have half sizes >= 0"});
  out.add("hit", scene_.sweep_hits(a, b, half));
}

std::vector<Vec3> points_asked(const std::string& text) {
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
  } catch (const InputError&) {  // is told when the record's turn comes
  }
  return out;
}

}  // namespace geom
