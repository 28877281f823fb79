#include "collada_links.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"
#include "text/xml_head.h"

namespace geom {
namespace {

constexpr double kMostNodes = 1e6;  // wherever others place them
constexpr std::size_t kDeepest = 200;

// The value of an attribute of a tag; empty where there is none.
std::string_view attribute(std::string_view tag, std::string_view key) {
  for (std::size_t at = 0; (at = tag.find(key, at)) != std::string_view::npos;) {
    const bool alone = at > 0 && std::string_view(" \t\r\n").find(tag[at - 1]) != tag.npos;
    at += key.size();
    std::string_view rest = tag.substr(at);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    if (!alone || !rest.starts_with('=')) continue;
    rest.remove_prefix(1);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) continue;
    return rest.substr(1, rest.find(rest[0], 1) - 1);
  }
  return {};
}

// Where what begins at `at` with '<' ends: at its last character. Nothing where it does not end.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
  for (const auto& [begin, end] : {std::pair<std::string_view, std::string_view>{"<!--", "-->"},
                                   {"<![CDATA[", "]]>"},
                                   {"<?", "?>"}}) {
    if (!text.substr(at).starts_with(begin)) continue;
    const std::size_t found = text.find(end, at + begin.size());
    return found == std::string_view::npos ? found : found + end.size() - 1;
  }
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote == 0 && c == '>') return at;
    if (c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    }
  }
  return std::string_view::npos;
}

// The numbers of a text; nothing of one where a word is none.
std::vector<double> numbers_of(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  std::vector<double> out;
  for (std::size_t at = 0; (at = text.find_first_not_of(kSpace, at)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, at), text.size());
    const auto number = parse_number(text.substr(at, end - at));
    if (!number) return {};
    out.push_back(*number);
    at = end;
  }
  return out;
}

class Links {
 public:
  Links(const std::string& source, Skipped& skipped) : source_(source), skipped_(skipped) {}

  void read(std::string_view text) {
    XmlWatch(source_).look(text);
    std::size_t last = 0;
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string_view::npos;) {
      const std::size_t end = end_of_tag(text, at);
      if (end == std::string_view::npos)
        refuse({.says = "a tag is not ended", .advice = "the file may be cut"});
      before_ = text.substr(last, at - last);
      require_no_entity(before_);
      const bool aside = text[at + 1] == '!' || text[at + 1] == '?';
      require_one_text(aside);
      if (!aside) take(text.substr(at + 1, end - at - 1));
      at = end;
      last = end + 1;
    }
    for (const Accessor& accessor : accessors_) {
      require_within(accessor);
      require_places(accessor);
    }
    for (const std::string& geometry : placed_) {
      if (!geometries_.contains(geometry)) lose(geometry, "geometry");
    }
    for (const std::string& geometry : geometries_) {
      if (!placed_.contains(geometry)) skipped_.add("geometry that no node places", geometry);
    }
    if (scenes_ > 1) skipped_.add("scenes beside the first", fmt::format("{} in all", scenes_));
    for (const auto& [node, inner] : nodes_) count(node, 0);
  }

 private:
  struct Accessor {
    std::string_view source;
    double numbers;  // that it reaches to
    double stride;
    std::string owner;  // the <source> that it stands in
    double params = 0;
    std::string names;
  };

  [[noreturn]] void refuse(Fault fault) const { throw InputError(source_, std::move(fault)); }

  void lose(std::string_view url, const char* what) {
    skipped_.add(fmt::format("{} that is not in the file", what), excerpt(url, 60));
  }

  // assimp leaves an entity that nobody declared as it stands, and what it stands for out.
  void require_no_entity(std::string_view text) const {
    for (std::size_t at = 0; (at = text.find('&', at)) != std::string_view::npos; ++at) {
      const std::string_view rest = text.substr(at + 1);
      if (rest.starts_with('#')) continue;
      const std::string_view name = rest.substr(0, rest.find(';'));
      if (name == "amp" || name == "lt" || name == "gt" || name == "quot" || name == "apos")
        continue;
      refuse({.expected = "only entities of XML itself",
              .found = fmt::format("\"&{}\"", excerpt(name, 40)),
              .advice = "write out what it stands for"});
    }
  }

  // Of the text of an element assimp reads what stands before a comment in it.
  void require_one_text(bool aside) {
    const bool blank = before_.find_first_not_of(" \t\r\n") == before_.npos;
    if (text_before_aside_ && !blank) {
      refuse({.expected = "no comment within numbers",
              .found = fmt::format("one before \"{}\"", excerpt(before_, 40)),
              .advice = "write the file without comments, for example with `xmllint --c14n`"});
    }
    text_before_aside_ = aside && (text_before_aside_ || !blank);
  }

  // assimp passes over elements of other names, also of the same behind a prefix.
  void require_no_prefix(std::string_view name) const {
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos) return;
    static const std::set<std::string_view> kRead = {"geometry",
                                                     "include",
                                                     "instance_geometry",
                                                     "instance_node",
                                                     "mesh",
                                                     "node",
                                                     "polygons",
                                                     "library_geometries",
                                                     "library_nodes",
                                                     "polylist",
                                                     "triangles",
                                                     "tristrips",
                                                     "trifans",
                                                     "visual_scene",
                                                     "library_visual_scenes"};
    if (!kRead.contains(name.substr(colon + 1))) return;
    refuse({.expected = "elements without a prefix",
            .found = fmt::format("<{}>, which assimp passes over", excerpt(name, 40))});
  }

  void take(std::string_view tag) {
    const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/", 1));
    require_no_prefix(name);
    require_no_entity(tag);
    std::string id(attribute(tag, "id"));
    if (name == "skew" || name == "lookat") {
      refuse({.says = fmt::format("it has a <{}>, which is not read", name),
              .advice = "write its nodes with matrices"});
    }
    if (name == "/rotate") require_axis();
    if (name == "/matrix") require_affine();
    if (name == "instance_controller") {
      refuse({.says = "bones or morphs move its meshes (<instance_controller>)",
              .advice = "write one state of it"});
    }
    if (name == "convex_mesh" || name == "spline" || name == "brep") {
      skipped_.add("geometry that is no mesh", fmt::format("<{}>", name));
    }
    if (name == "unit") require_unit(attribute(tag, "meter"));
    if (name == "up_axis" && tag.ends_with('/')) refuse_up_axis("");
    if (name == "/up_axis") take_up_axis(before_);
    in_library_ = in_library_ || name.starts_with("library_");
    take_numbers(name, tag, id);
    scenes_ += name == "visual_scene";
    if (name == "geometry") geometries_.insert(id);
    if (name == "node") {
      if (id.empty()) id = attribute(tag, "name");  // assimp finds them by that, too
      nodes_[id];
      if (!tag.ends_with('/')) open_.push_back(id);
    }
    if (name == "/node" && !open_.empty()) open_.pop_back();
    const bool node = name == "instance_node";
    if (!node && name != "instance_geometry") return;
    const std::string_view url = attribute(tag, "url");
    if (!url.starts_with('#')) {
      lose(url, node ? "node" : "geometry");
    } else if (node) {
      place_node(std::string(url.substr(1)));
    } else {
      placed_.emplace(url.substr(1));
    }
  }

  double count_of(std::string_view tag, std::string_view key, double otherwise) const {
    const std::string_view text = attribute(tag, key);
    if (text.empty()) return otherwise;
    const auto value = parse_number(text);
    if (value && *value >= 0 && *value <= 1e12 && *value == std::floor(*value)) return *value;
    refuse({.expected = fmt::format("{} to be a whole number", key),
            .found = in_quotes(excerpt(text))});
  }

  void take_numbers(std::string_view name, std::string_view tag, const std::string& id) {
    if (name == "float_array") {
      const double count = count_of(tag, "count", 0);
      const auto known = arrays_.emplace(id, count).first;
      known->second = std::min(known->second, count);
    } else if (name == "accessor") {
      const double stride = count_of(tag, "stride", 1);
      const double numbers = count_of(tag, "offset", 0) + stride * count_of(tag, "count", 0);
      accessors_.push_back({attribute(tag, "source"), numbers, stride, open_source_});
      in_accessor_ = !tag.ends_with('/');
    } else if (name == "/accessor") {
      in_accessor_ = false;
    } else if (name == "param" && in_accessor_) {
      ++accessors_.back().params;
      accessors_.back().names += attribute(tag, "name");
    } else if (name == "source") {
      open_source_ = id;
    } else if (name == "input" && attribute(tag, "semantic") == "POSITION") {
      positions_.emplace(attribute(tag, "source"));
    }
  }

  // Beyond its numbers assimp reads whatever memory holds.
  void require_within(const Accessor& accessor) const {
    if (!accessor.source.starts_with('#')) return;
    const auto array = arrays_.find(std::string(accessor.source.substr(1)));
    if (array == arrays_.end()) return;
    if (accessor.numbers <= array->second && accessor.params <= accessor.stride) return;
    refuse({.expected = fmt::format("an <accessor> within the {} numbers of \"{}\"", array->second,
                                    excerpt(accessor.source)),
            .found = fmt::format("one to {}, {} at a time of {}", accessor.numbers, accessor.params,
                                 accessor.stride)});
  }

  // Without one of these names assimp takes x for y or z.
  void require_places(const Accessor& accessor) const {
    if (!positions_.contains("#" + accessor.owner) || accessor.names == "XYZ") return;
    refuse({.expected = "positions to have the <param> names X, Y and Z",
            .found =
                fmt::format("\"{}\" in \"{}\"", excerpt(accessor.names), excerpt(accessor.owner))});
  }

  // A last row that assimp passes over.
  void require_affine() const {
    const std::vector<double> v = numbers_of(before_);
    const bool whole = v.size() == 16;
    if (whole && v[12] == 0 && v[13] == 0 && v[14] == 0 && v[15] == 1) return;
    refuse({.expected = "<matrix> to have 16 numbers, the last row 0 0 0 1",
            .found = in_quotes(excerpt(before_))});
  }

  // Of others assimp makes 0, and all triangles are one point. It takes the unit of the file for
  // parts that name their own.
  void require_unit(std::string_view metres) {
    const auto value = metres.empty() ? 1 : parse_number(metres);
    if (!value || !std::isfinite(*value) || *value <= 0) {
      refuse(
          {.expected = "<unit meter> to be a number above 0", .found = in_quotes(excerpt(metres))});
    }
    if (in_library_ && *value != unit_) {
      refuse({.expected = "one unit in the whole file",
              .found = fmt::format("{} m and {} m", unit_, *value)});
    }
    unit_ = *value;
  }

  [[noreturn]] void refuse_up_axis(std::string_view found) const {
    refuse({.expected =
                "<up_axis> to be X_UP, Y_UP or Z_UP, without blanks and once for the whole file",
            .found = in_quotes(excerpt(found))});
  }

  // Any other word is Y_UP to assimp, and so are these between blanks.
  void take_up_axis(std::string_view up) {
    if (up != "X_UP" && up != "Y_UP" && up != "Z_UP") refuse_up_axis(up);
    if (in_library_ && up != up_) refuse_up_axis(up);
    up_ = up;
  }

  // About other axes programs turn in different ways, or shear.
  void require_axis() const {
    const std::vector<double> v = numbers_of(before_);
    if (v.size() == 4 && (v[3] == 0 || std::abs(std::hypot(v[0], v[1], v[2]) - 1) < 1e-3)) return;
    refuse({.expected = "<rotate> to have an axis of length 1 and an angle",
            .found = in_quotes(excerpt(before_))});
  }

  void place_node(const std::string& id) {
    for (const std::string& outer : open_) nodes_[outer].push_back(id);
  }

  // The nodes that one stands for, with all that it places.
  double count(const std::string& node, std::size_t depth) {
    if (const auto known = counts_.find(node); known != counts_.end()) return known->second;
    if (!nodes_.contains(node)) {
      lose(node, "node");
      return counts_[node] = 0;
    }
    if (depth > kDeepest)
      refuse({.expected = "nodes that do not place themselves", .found = "one that does"});
    double sum = 1;
    for (const std::string& inner : nodes_.at(node)) sum += count(inner, depth + 1);
    if (sum > kMostNodes)
      refuse({.expected = "nodes that place less than 1e6 others", .found = "more"});
    return counts_[node] = sum;
  }

  const std::string& source_;
  Skipped& skipped_;
  std::set<std::string> geometries_;
  std::set<std::string> placed_;                           // geometries
  std::map<std::string, std::vector<std::string>> nodes_;  // by id: which others they place
  std::map<std::string, double> counts_;
  std::vector<std::string> open_;         // nodes
  std::map<std::string, double> arrays_;  // by id: how many numbers
  std::vector<Accessor> accessors_;
  std::string open_source_;          // the id of the last <source>
  std::set<std::string> positions_;  // urls of sources
  std::string_view before_;          // the text between the last tag and this one
  std::string_view up_ = "Y_UP";
  double unit_ = 1;  // metres
  bool text_before_aside_ = false;
  bool in_library_ = false;
  bool in_accessor_ = false;
  int scenes_ = 0;
};

}  // namespace

void check_collada_links(std::string_view text, const std::string& source, Skipped& skipped) {
  Links(source, skipped).read(text);
}

}  // namespace geom
