#include "traj/mission/formats/gltf_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/mesh/gltf.h"
#include "geom/model/model_format.h"
#include "geom/text/parse_json.h"
#include "mission/formats/text_head.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

using Json = nlohmann::ordered_json;
using geom::shown;

using geom::Vec3;

Vec3 from_gltf(const Vec3& v) { return {v.x(), -v.z(), v.y()}; }

constexpr int kFloat = 5126;
constexpr int kLineStrip = 3;

class GltfReader {
 public:
  GltfReader(std::string_view bytes, std::string_view source) : bytes_(bytes), source_(source) {
    take_chunks();
  }

  std::vector<geom::Polyline> lines() const {
    require_only(json_, "the file",
                 {"asset", "scene", "scenes", "nodes", "meshes", "materials", "accessors",
                  "bufferViews", "buffers"});
    if (list("scenes").size() != 1) refuse({.expected = "one scene"});
    const Json& shown_nodes = member(list("scenes")[0], "nodes", "scenes[0]");
    if (!shown_nodes.is_array()) refuse({.expected = "scenes[0].nodes to be a list"});
    std::vector<bool> seen(list("nodes").size());
    std::vector<bool> drawn(list("meshes").size());
    std::vector<geom::Polyline> lines;
    for (const Json& index : shown_nodes) {
      const std::size_t node = whole(index, "scenes[0].nodes", seen.size());
      if (seen[node]) refuse({.expected = "each node once in the scene", .found = "one twice"});
      seen[node] = true;
      append_node(list("nodes")[node], drawn, lines);
    }
    if (std::find(seen.begin(), seen.end(), false) != seen.end() ||
        std::find(drawn.begin(), drawn.end(), false) != drawn.end()) {
      refuse({.expected = "every node and mesh in the scene", .found = "one that is not shown"});
    }
    if (lines.empty()) refuse({.expected = "a line of points", .found = "none"});
    return lines;
  }

 private:
  [[noreturn]] void refuse(geom::Fault fault) const {
    fault.says = "expected a glTF line" + (fault.says.empty() ? "" : ": " + fault.says);
    throw geom::InputError(source_, std::move(fault));
  }

  std::size_t word(std::size_t at) const {
    std::uint32_t value = 0;
    if (at + 4 > bytes_.size()) refuse({.says = "the file ends early"});
    std::memcpy(&value, bytes_.data() + at, 4);
    return value;
  }

  // A chunk of that type at that place, and where the next begins.
  std::string_view chunk(std::size_t& at, std::string_view type) const {
    const std::size_t size = word(at);
    if (at + 8 + size > bytes_.size()) refuse({.says = "the file ends early"});
    if (bytes_.substr(at + 4, 4) != type) refuse({.expected = "the chunks JSON and BIN"});
    const std::string_view found = bytes_.substr(at + 8, size);
    at += 8 + size;
    return found;
  }

  void take_chunks() {
    if (!bytes_.starts_with("glTF") || word(4) != 2) refuse({.says = "this is no binary glTF 2"});
    if (word(8) != bytes_.size()) {
      refuse({.says = fmt::format("its header says {} bytes, it has {}", word(8), bytes_.size())});
    }
    std::size_t at = 12;
    json_ = geom::parse_ordered_json(chunk(at, "JSON"), source_);
    bin_ = chunk(at, std::string_view("BIN\0", 4));
    if (at != bytes_.size()) refuse({.expected = "the chunks JSON and BIN", .found = "more"});
    if (!json_.is_object())
      refuse({.key = "its JSON", .expected = "an object", .found = shown(json_)});
  }

  const Json& member(const Json& object, const char* key, const std::string& where) const {
    const auto it = object.is_object() ? object.find(key) : object.end();
    if (it == object.end()) refuse({.expected = fmt::format("{}.{}", where, key), .found = "none"});
    return *it;
  }

  const Json& list(const char* key) const {
    const Json& value = member(json_, key, "the file");
    if (!value.is_array())
      refuse({.key = std::string(key), .expected = "a list", .found = shown(value)});
    return value;
  }

  std::size_t whole(const Json& value, const std::string& what, std::size_t below) const {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= below) {
      refuse({.key = what,
              .expected = fmt::format("whole and less than {}", below),
              .found = shown(value)});
    }
    return value.get<std::size_t>();
  }

  // Whatever else could move a point, or be a way to fly.
  void require_only(const Json& object, const std::string& where,
                    std::initializer_list<const char*> known) const {
    if (!object.is_object()) refuse({.key = where, .expected = "an object"});
    for (const auto& [key, value] : object.items()) {
      const bool aside = key == "name" || key == "extras";
      if (aside || std::find(known.begin(), known.end(), key) != known.end()) continue;
      refuse({.says = fmt::format("{} has \"{}\", which is not read", where, key.substr(0, 60)),
              .advice = "write plain line strips"});
    }
  }

  void append_node(const Json& node, std::vector<bool>& drawn,
                   std::vector<geom::Polyline>& lines) const {
    require_only(node, "a node", {"mesh", "translation"});
    const std::size_t mesh = whole(member(node, "mesh", "a node"), "a node's mesh", drawn.size());
    drawn[mesh] = true;
    Vec3 origin = Vec3::Zero();
    if (node.contains("translation")) {
      const Json& at = node["translation"];
      const bool numbers = at.is_array() && at.size() == 3 &&
                           std::all_of(at.begin(), at.end(), [](auto& v) { return v.is_number(); });
      if (!numbers)
        refuse({.key = "a node's translation", .expected = "three numbers", .found = shown(at)});
      origin = Vec3(at[0], at[1], at[2]);
    }
    const Json& holder = list("meshes")[mesh];
    require_only(holder, "a mesh", {"primitives"});
    const Json& parts = member(holder, "primitives", "a mesh");
    if (!parts.is_array()) refuse({.key = "a mesh's primitives", .expected = "a list"});
    for (const Json& part : parts) lines.push_back(line(part, origin));
  }

  geom::Polyline line(const Json& part, const Vec3& origin) const {
    require_only(part, "a primitive", {"attributes", "mode", "material"});
    if (member(part, "mode", "a primitive") != kLineStrip) {
      refuse({.key = "a primitive's mode",
              .expected = "3 (a line strip)",
              .found = shown(part["mode"])});
    }
    const Json& attributes = member(part, "attributes", "a primitive");
    require_only(attributes, "attributes", {"POSITION"});
    const Json& accessors = list("accessors");
    const Json& accessor = accessors[whole(member(attributes, "POSITION", "attributes"), "POSITION",
                                           accessors.size())];
    geom::Polyline points;
    const std::string_view floats = floats_of(accessor);
    for (std::size_t at = 0; at < floats.size(); at += kPointBytes) {
      float v[3];
      std::memcpy(v, floats.data() + at, kPointBytes);
      points.push_back(from_gltf(origin + Vec3(v[0], v[1], v[2])));
      if (!(points.back().cwiseAbs().maxCoeff() <= geom::kLargestCoordinate)) {
        refuse({.expected = "coordinates within 1e8 m"});
      }
    }
    return points;
  }

  // The bytes of an accessor's points.
  std::string_view floats_of(const Json& accessor) const {
    require_only(accessor, "an accessor",
                 {"bufferView", "byteOffset", "componentType", "count", "type", "min", "max"});
    if (member(accessor, "componentType", "an accessor") != kFloat ||
        member(accessor, "type", "an accessor") != "VEC3") {
      refuse({.says = "an accessor must hold three floats a point"});
    }
    const Json& views = list("bufferViews");
    const Json& view = views[whole(member(accessor, "bufferView", "an accessor"),
                                   "an accessor's bufferView", views.size())];
    require_only(view, "a bufferView",
                 {"buffer", "byteOffset", "byteLength", "byteStride", "target"});
    const Json& buffers = list("buffers");
    if (buffers.size() != 1) refuse({.expected = "one buffer, the file's own"});
    require_only(buffers[0], "a buffer", {"byteLength"});
    const std::size_t most = bin_.size() + 1;
    const auto offset = [&](const Json& object) {
      return object.contains("byteOffset") ? whole(object["byteOffset"], "a byteOffset", most) : 0;
    };
    whole(member(view, "buffer", "a bufferView"), "a bufferView's buffer", 1);
    if (view.contains("byteStride") && view["byteStride"] != kPointBytes) {
      refuse({.key = "a bufferView's byteStride",
              .expected = "12",
              .found = shown(view["byteStride"])});
    }
    const std::size_t length =
        whole(member(view, "byteLength", "a bufferView"), "a bufferView's byteLength", most);
    const std::size_t count =
        whole(member(accessor, "count", "an accessor"), "an accessor's count", most);
    const std::size_t begin = offset(accessor);
    const std::size_t size = count * kPointBytes;
    if (count == 0) refuse({.expected = "a line of points", .found = "none"});
    if (begin + size > length || offset(view) + length > bin_.size())
      refuse({.says = "the file ends early"});
    return bin_.substr(offset(view) + begin, size);
  }

  static constexpr std::size_t kPointBytes = 12;
  std::string_view bytes_;
  std::string_view source_;
  Json json_;
  std::string_view bin_;
};

}  // namespace

void write_gltf_line(std::ostream& out, std::span<const geom::Vec3> enu, std::string_view name,
                     std::string_view note) {
  geom::Gltf gltf(enu.front());
  geom::GltfPrimitive line{geom::GltfMode::line_strip, 0, {}, 0};
  line.positions = gltf.add_positions(enu.size(), [&](std::size_t i) { return enu[i]; });
  line.material = gltf.add_material({{}, {0, 0, 0}, 1, geom::Rgb{1, 0.4, 0}});
  gltf.add_node(std::string(name), {line});
  gltf.write(out, note);
}

std::vector<geom::Polyline> read_gltf_lines(std::istream& in, std::string_view source) {
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  return GltfReader(bytes, source).lines();
}

namespace {

constexpr std::string_view kReaders[] = {"skyway-check", "skyway-import-trajectory", "skyway-mesh"};

ReadFlights read(std::istream& in, const ReadTask& task) {
  ReadFlights out;
  for (geom::Polyline& line : read_gltf_lines(in, task.source)) {
    out.flights.push_back({FlownLegs{std::move(line)}});
  }
  return out;
}

WrittenMission write(const MissionTask& task, const geom::Polyline& legs) {
  geom::TextOutput text;
  write_gltf_line(text, legs, task.flight->id, unchecked_note(task));
  WrittenMission written{text.str()};
  written.reading.placement = task.options.placement;
  return written;
}

}  // namespace

constinit const MissionFormat kGltfLine{
    .format = {.word = "gltf",
               .what = "a binary glTF",
               .begins = [](std::string_view head) { return geom::kGlbFile.begins(head); },
               .readers = kReaders},
    .may_be = [](std::string_view text) { return text_head(text).starts_with("glTF"); },
    .read = read,
    .write = write,
    .reads_with = {FileOption::navigation, FileOption::tracking},
    .writes_with = {FileOption::tolerance, FileOption::navigation, FileOption::tracking},
    .has_legs = true,
    .is_binary = true};

}  // namespace traj
