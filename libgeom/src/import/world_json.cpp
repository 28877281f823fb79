// RotorPy worlds: JSON with `bounds` and `blocks`, extents as xmin,xmax,ymin,ymax,zmin,zmax. Ids
// count the blocks from 0, and a colour becomes the label "R G B". The keys of a course (start,
// goal, resolution, margin, expected_path_length) are no obstacles. Other keys may mean obstacles,
// or turn blocks: they are skipped, unless their name says that they are no geometry.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/import/import_boxes.h"
#include "geom/text/beginning.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;

class World {
 public:
  explicit World(std::string_view source) : source_(source) {}

  [[noreturn]] void refuse(Fault fault) const { throw InputError(source_, std::move(fault)); }

  // `what` says whose extents they are.
  Aabb extents(const Json& owner, std::string_view what, std::size_t& reversed) const {
    const Json found = owner.is_object() ? owner.value("extents", Json()) : Json();
    if (!found.is_array() || found.size() != 6) {
      refuse({.says = fmt::format("{} must have \"extents\":[xmin,xmax,ymin,ymax,zmin,zmax]", what),
              .found = shown(found)});
    }
    Aabb box;
    bool turned = false;
    for (int i = 0; i < 3; ++i) {
      box.min[i] = coordinate(found[2 * i], what);
      box.max[i] = coordinate(found[2 * i + 1], what);
      if (box.min[i] <= box.max[i]) continue;
      std::swap(box.min[i], box.max[i]);
      turned = true;
    }
    reversed += turned;
    return box;
  }

  std::string colour(const Json& block, std::string_view what) const {
    if (!block.contains("color")) return "";
    const Json& found = block["color"];
    if (!found.is_array() || found.size() != 3) {
      refuse({.item = std::string(what),
              .key = "color",
              .expected = "3 numbers",
              .found = shown(found)});
    }
    std::string label;
    for (const Json& part : found) {
      label += fmt::format("{}{}", label.empty() ? "" : " ", coordinate(part, what));
    }
    return label;
  }

 private:
  double coordinate(const Json& value, std::string_view what) const {
    const double v = value.is_number() ? value.get<double>() : HUGE_VAL;
    if (!(std::abs(v) <= kLargestCoordinate)) {
      refuse({.item = std::string(what),
              .expected = "a finite number within 1e8",
              .found = shown(value)});
    }
    return v;
  }

  std::string source_;
};

constexpr std::array<std::string_view, 6> kNames = {"colour", "name",    "label",
                                                    "id",     "comment", "description"};

void note_unknown(const Json& object, std::initializer_list<std::string_view> known,
                  const std::string& where, ImportedBoxes& out) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      const bool name = std::find(kNames.begin(), kNames.end(), key) != kNames.end();
      if (name) {
        out.names.push_back(where + key);
      } else {
        out.skipped.add("unknown key", where + key.substr(0, 40));
      }
    }
  }
}

ImportedBoxes read_world_json(std::istream& in, std::string_view source, const ImportOptions&) {
  const World world(source);
  const Json root = parse_json(in, source);
  if (!root.is_object()) world.refuse({.expected = "a JSON object with \"bounds\" and \"blocks\""});
  ImportedBoxes out;
  out.bounds = world.extents(root.value("bounds", Json()), "bounds", out.reversed);
  const Json blocks = root.value("blocks", Json());
  if (!blocks.is_array() || blocks.empty()) {
    world.refuse({.expected = "at least one block in \"blocks\"", .found = shown(blocks)});
  }
  note_unknown(
      root, {"bounds", "blocks", "start", "goal", "resolution", "margin", "expected_path_length"},
      "", out);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::string what = fmt::format("block {}", i);
    const Aabb box = world.extents(blocks[i], what, out.reversed);
    const auto zeros = (box.min.array() == box.max.array()).count();
    if (zeros == 3)
      world.refuse({.says = fmt::format("{} must have some extent", what), .found = "a point"});
    out.flat += zeros > 0;
    note_unknown(blocks[i], {"extents", "color"}, what + ": ", out);
    const std::string colour = world.colour(blocks[i], what);
    out.table.add(box, i, out.table.label_of(colour));
  }
  return out;
}

bool may_be_world_json(std::string_view head) { return first_line(head).starts_with('{'); }

constexpr std::string_view kReaders[] = {"skyway-import"};
constexpr Format kFormat{.word = "world-json",
                         .what = "a RotorPy world",
                         .begins = json_with<R"("bounds":{"extents")">,
                         .readers = kReaders};

}  // namespace

constinit const BoxFormat kRotorPyWorld{
    .format = &kFormat, .may_be = may_be_world_json, .read = read_world_json};

}  // namespace geom
