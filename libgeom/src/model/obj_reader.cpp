#include <fmt/format.h>

#include <charconv>
#include <map>

#include "geom/base/text_stream.h"
#include "geom/model/model.h"
#include "geom/model/model_format.h"
#include "geom/model/model_polygons.h"
#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"
#include "text/unit_comment.h"

// Wavefront's Advanced Visualizer Manual, appendix B: the polygons of it.

namespace geom {
namespace {

// Words that make nothing by themselves.
constexpr std::string_view kIdle[] = {"vt",       "vn",       "vp",     "s",          "mg",
                                      "usemtl",   "usemap",   "mtllib", "maplib",     "bevel",
                                      "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj"};

class ObjReader {
 public:
  ObjReader(std::istream& in, std::string_view source) : lines_(in, source, true) {}

  Model read() {
    std::string whole;
    while (lines_.next()) {
      std::string_view line = lines_.line();
      if (line.starts_with('#')) take_comment(line);
      line = line.substr(0, line.find('#'));  // a comment goes to the end of its line, "\" or not
      if (line.ends_with('\\')) {
        require_numbers(whole.empty() ? line : whole);
        whole += line.substr(0, line.size() - 1);
        whole += ' ';
        continue;
      }
      if (whole.empty()) {
        add(line);
      } else {
        whole += line;
        add(whole);
        whole.clear();
      }
    }
    if (!whole.empty())
      lines_.refuse({.expected = "the line to go on after \"\\\"", .found = "the end"});
    require_vertices();
    polygons_.finish(model_);
    return std::move(model_);
  }

 private:
  // A name may end in a backslash that does not mean to swallow the next line.
  void require_numbers(std::string_view line) const {
    const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
    const std::string_view word = line.substr(first, line.find_first_of(" \t\\", first) - first);
    for (const char* known : {"v", "vt", "vn", "f", "fo", "l", "p"}) {
      if (word == known) return;
    }
    lines_.refuse(
        {.expected = "a line of numbers before \"\\\"", .found = in_quotes(excerpt(line, 40))});
  }

  void take_comment(std::string_view line) {
    const auto unit = unit_of_comment(line);
    if (unit && model_.unit && *unit != *model_.unit) {
      lines_.refuse({.expected = "the unit that a comment before names",
                     .found = in_quotes(excerpt(line, 40))});
    }
    if (unit) model_.unit = unit;
  }

  void add(std::string_view line) {
    words_.clear();
    for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
      words_.push_back(line.substr(at, end - at));
      at = end;
    }
    if (words_.empty()) return;
    const std::string_view word = words_.front();
    if (word == "v") {
      add_vertex();
    } else if (word == "f" || word == "fo") {
      add_face();
    } else if (word == "o" || word == "g") {
      const std::size_t name = line.find_first_not_of(" \t", line.find(word) + 1);
      begin_part(word == "o", name == std::string_view::npos ? "" : trimmed(line.substr(name)));
    } else if (std::find(std::begin(kIdle), std::end(kIdle), word) == std::end(kIdle)) {
      model_.skipped.add(word == "l" || word == "p" ? "point or line" : "unknown keyword",
                         fmt::format("line {}: {}", lines_.number(), excerpt(word, 20)));
    }
  }

  // Objects go before groups, of which there may be many in one.
  void begin_part(bool object, std::string_view name) {
    if (object) in_object_ = true;
    if (!object && in_object_) return;
    const auto next = static_cast<std::uint32_t>(model_.parts.size());
    const auto [at, added] = part_of_.try_emplace(std::string(name), next);
    if (added) model_.parts.emplace_back(name);
    part_ = at->second;
    any_part_ = true;
  }

  void add_vertex() {
    if (words_.size() < 4) {
      lines_.refuse(
          {.expected = "\"v\" and three numbers", .found = fmt::to_string(words_.size() - 1)});
    }
    Vec3 v;
    for (int i = 0; i < 3; ++i) {
      v[i] = coordinate(lines_, "vertex", words_[static_cast<std::size_t>(i) + 1]);
    }
    require_weight_or_colour();
    model_.mesh.vertices.push_back(v);
  }

  // Behind the three: a weight, by which other readers divide; or a colour of three or four
  // numbers.
  void require_weight_or_colour() const {
    const std::size_t more = words_.size() - 4;
    if (more == 0) return;
    if (more == 2 || more > 4) {
      lines_.refuse({.expected = "\"v\" and three numbers, then none, a weight of 1 or a colour",
                     .found = fmt::format("{} numbers", words_.size() - 1)});
    }
    for (std::size_t i = 4; i < words_.size(); ++i) {
      const auto value = parse_number(words_[i]);
      if (value && (more > 1 || *value == 1)) continue;
      lines_.refuse({.expected = more == 1 ? "a weight of 1 after the three numbers of a vertex"
                                           : "numbers as the colour of a vertex",
                     .found = in_quotes(excerpt(words_[i], 40))});
    }
  }

  std::uint32_t vertex_of(std::string_view word) const {
    const std::string_view number = word.substr(0, word.find('/'));
    long k = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), k);
    const auto count = static_cast<long>(model_.mesh.vertices.size());
    if (k < 0) k += count + 1;  // counted from the last
    if (error != std::errc() || end != number.data() + number.size() || k < 1 ||
        k > std::numeric_limits<std::uint32_t>::max() ||
        word.find_first_not_of("-0123456789/") != std::string_view::npos) {
      lines_.refuse(
          {.expected = fmt::format("the number of a vertex, of which there are {}", count),
           .found = in_quotes(excerpt(word, 40))});
    }
    return static_cast<std::uint32_t>(k - 1);
  }

  void add_face() {
    if (words_.size() < 4) {
      lines_.refuse({.expected = "a face of at least 3 vertices",
                     .found = fmt::to_string(words_.size() - 1)});
    }
    if (!any_part_) begin_part(false, "");
    face_.clear();
    bool later = false;
    for (std::size_t i = 1; i < words_.size(); ++i) {
      face_.push_back(vertex_of(words_[i]));
      later |= face_.back() >= model_.mesh.vertices.size();
    }
    if (later)
      lines_.refuse({.expected = "vertices before the face", .found = "one that is not there yet"});
    polygons_.add(model_, face_, part_);
  }

  void require_vertices() const {
    if (model_.mesh.vertices.empty())
      lines_.refuse({.expected = "vertices (\"v\")", .found = "none"});
  }

  TextLines lines_;
  Model model_;
  ModelPolygons polygons_;
  std::map<std::string, std::uint32_t> part_of_;
  std::vector<std::string_view> words_;
  std::vector<std::uint32_t> face_;
  std::uint32_t part_ = 0;
  bool any_part_ = false;
  bool in_object_ = false;
};

}  // namespace

Model read_obj(std::istream& in, std::string_view source) { return ObjReader(in, source).read(); }

namespace {

LoadedModel load_obj(const ModelFile& file) {
  TextInput in(file.bytes);
  return {read_obj(in, file.path)};
}

constexpr std::string_view kReaders[] = {"skyway-mesh"};
constexpr Format kFormat{.word = "obj", .what = "an OBJ model", .readers = kReaders};

}  // namespace

constinit const ModelFormat kObjModel{.format = &kFormat, .ending = ".obj", .read = load_obj};

}  // namespace geom
