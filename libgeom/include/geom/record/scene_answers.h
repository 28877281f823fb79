#pragma once

// Answers of the collision structure to records: hits, clearance, nearest boxes (JSON Lines).
//
// Example:
//   const geom::SceneAnswers answers(scene);
//   std::cout << answers.answer(R"({"id":"a","point":[1,1,1]})", "points.jsonl", 1);
//   // {"type":"answer","id":"a","hit":false,"inside_bounds":true,"clearance":…}

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/map/geographic_frame.h"
#include "geom/record/locator.h"
#include "geom/record/record.h"

namespace geom {

class JsonFields;
class JsonLine;

// Any number of threads may ask at once. The scene must outlive this.
class SceneAnswers {
 public:
  // `degrees`: points are answered with their latitude and longitude. Throws UsageError if the map
  // has no origin on Earth then.
  explicit SceneAnswers(const CollisionScene& scene, bool degrees = false);

  // The answer to one record, which ends with a newline. The record has one of the keys "point"
  // (with "k": how many boxes near it), "segment" (with "planes" or "empty_box": how far around it,
  // metres), "box" and "sweep" (with "half"); docs/formats.md says what each answers. Throws
  // InputError(source, line, …) for a record that is malformed, that asks two things, that has one
  // of these keys beside another question than its own, or that says another map, frame, vehicle or
  // margin than the scene's.
  std::string answer(const std::string& record, const std::string& source, std::size_t line) const;

 private:
  std::uint64_t id(std::size_t box) const { return scene_.map().ids()[box]; }
  Vec3 place_of(const JsonFields& fields, const std::string& source, std::size_t line) const;
  void add_point(JsonLine& out, const JsonFields& fields, const Vec3& p) const;
  void add_segment(JsonLine& out, const JsonFields& fields) const;
  void add_box(JsonLine& out, const JsonFields& fields) const;
  void add_sweep(JsonLine& out, const JsonFields& fields) const;

  const CollisionScene& scene_;
  Provenance ours_;
  Locator locator_;
  std::optional<GeographicFrame> earth_;
};

// The points of a record that are given in metres. Empty for a record that is malformed.
std::vector<Vec3> points_asked(const std::string& record);

}  // namespace geom
