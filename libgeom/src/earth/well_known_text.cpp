#include <algorithm>
#include <cctype>
#include <vector>

#include "geom/earth/coordinate_reference.h"
#include "geom/text/text_table.h"

// Well-known text of coordinate reference systems: OGC 01-009 (WKT 1) and 18-010r7 (WKT 2).

namespace geom {
namespace {

using Kind = CoordinateReference::Kind;

constexpr int kDeepest = 32;

struct Node {
  std::string keyword;              // in capitals
  std::vector<std::string> values;  // numbers, words and unquoted texts
  std::vector<Node> children;

  const Node* child(std::initializer_list<std::string_view> keywords) const {
    for (const Node& node : children) {
      if (std::find(keywords.begin(), keywords.end(), node.keyword) != keywords.end()) return &node;
    }
    return nullptr;
  }
};

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::optional<Node> parse() {
    auto node = read_node(0);
    skip_blanks();
    while (at_ < text_.size() && text_[at_] == '\0') ++at_;  // LAS records end in one
    return at_ == text_.size() ? node : std::nullopt;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  std::optional<std::string> quoted() {
    std::string out;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] != '"') {
        out += text_[at_];
      } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
        out += text_[++at_];
      } else {
        ++at_;
        return out;
      }
    }
    return std::nullopt;
  }

  std::string word() {
    const std::size_t first = at_;
    const auto part = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '+' ||
             c == '-' || c == ':';
    };
    while (at_ < text_.size() && part(text_[at_])) ++at_;
    return std::string(text_.substr(first, at_ - first));
  }

  std::optional<Node> read_node(int depth) {
    skip_blanks();
    Node node;
    node.keyword = word();
    for (char& c : node.keyword) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (node.keyword.empty() || depth > kDeepest || !(take('[') || take('('))) return std::nullopt;
    do {
      if (!read_part(node, depth)) return std::nullopt;
    } while (take(','));
    if (!take(']') && !take(')')) return std::nullopt;
    return node;
  }

  bool read_part(Node& node, int depth) {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == '"') {
      auto text = quoted();
      if (text) node.values.push_back(std::move(*text));
      return text.has_value();
    }
    const std::size_t first = at_;
    std::string value = word();
    skip_blanks();
    if (at_ < text_.size() && (text_[at_] == '[' || text_[at_] == '(')) {
      at_ = first;
      auto child = read_node(depth + 1);
      if (child) node.children.push_back(std::move(*child));
      return child.has_value();
    }
    node.values.push_back(std::move(value));
    return !node.values.back().empty();
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

// The length that a unit's node gives.
std::optional<double> metres_of(const Node* unit) {
  if (!unit || unit->values.size() < 2) return std::nullopt;
  const auto value = parse_number(unit->values[1]);
  if (!value || !(*value > 0 && *value < 1e9)) return std::nullopt;
  return value;
}

const Node* unit_of(const Node& node) { return node.child({"UNIT", "LENGTHUNIT"}); }

// The unit of the axis of this number: its own, or that of the whole system.
std::optional<double> axis_unit(const Node& system, std::size_t axis) {
  std::size_t at = 0;
  for (const Node& child : system.children) {
    if (child.keyword != "AXIS" || at++ != axis) continue;
    if (const Node* own = unit_of(child)) return metres_of(own);
  }
  return metres_of(unit_of(system));
}

bool three_axes(const Node& system) {
  return std::count_if(system.children.begin(), system.children.end(),
                       [](const Node& c) { return c.keyword == "AXIS"; }) > 2;
}

// Mercator, whose scale grows with the latitude; not the transverse and oblique ones.
bool is_mercator(const Node& system) {
  const Node* method = system.child({"PROJECTION"});
  if (const Node* conversion = system.child({"CONVERSION"})) method = conversion->child({"METHOD"});
  if (!method || method->values.empty()) return false;
  const std::string& name = method->values.front();
  return name.starts_with("Mercator") || name.find("Pseudo") != std::string::npos;
}

// The code that the system itself has, not one of its parts.
std::optional<int> epsg_of(const Node& system) {
  const Node* const id = system.child({"AUTHORITY", "ID"});
  if (!id || id->values.size() < 2 || id->values[0] != "EPSG") return std::nullopt;
  const auto code = parse_number(id->values[1]);
  if (!code || !(*code >= 1 && *code < 1e8)) return std::nullopt;
  return static_cast<int>(*code);
}

CoordinateReference lengths(const Node& system) {
  CoordinateReference out;
  out.kind = is_mercator(system) ? Kind::no_plane : Kind::metric;
  out.plane = axis_unit(system, 0);
  if (out.plane != axis_unit(system, 1)) out.plane.reset();  // x in one unit and y in another
  if (three_axes(system)) out.up = axis_unit(system, 2);
  out.epsg = epsg_of(system);
  return out;
}

CoordinateReference reference_of(const Node& node) {
  static const auto is = [](const std::string& word, std::initializer_list<std::string_view> list) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  CoordinateReference out;
  if (is(node.keyword,
         {"PROJCS", "PROJCRS", "PROJECTEDCRS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"})) {
    return lengths(node);
  }
  if (is(node.keyword,
         {"GEOGCS", "GEOCCS", "GEOGCRS", "GEODCRS", "GEOGRAPHICCRS", "GEODETICCRS"})) {
    out.kind = Kind::no_plane;
    return out;
  }
  if (is(node.keyword, {"BOUNDCRS", "SOURCECRS"})) {
    for (const Node& child : node.children) {
      const CoordinateReference inner = reference_of(child);
      if (inner.kind != Kind::not_known) return inner;
    }
  }
  if (is(node.keyword, {"COMPD_CS", "COMPOUNDCRS"})) {
    for (const Node& child : node.children) {
      const CoordinateReference inner = reference_of(child);
      if (inner.kind != Kind::not_known) out = inner;
    }
    if (const Node* vertical = node.child({"VERT_CS", "VERTCRS", "VERTICALCRS"})) {
      out.up = axis_unit(*vertical, 0);
      out.up_unclear = !out.up;
    }
    if (out.kind != Kind::none) return out;
  }
  out.kind = Kind::not_known;
  return out;
}

}  // namespace

CoordinateReference reference_of_wkt(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  const auto node = Parser(trimmed(text)).parse();
  CoordinateReference out;
  if (node) out = reference_of(*node);
  if (!node) out.kind = Kind::not_known;
  out.name = node && !node->values.empty() ? node->values.front() : std::string(text.substr(0, 60));
  const bool local = node && (node->keyword == "LOCAL_CS" || node->keyword.starts_with("ENG"));
  if (!local) out.crs = std::string(trimmed(text));
  return out;
}

}  // namespace geom
