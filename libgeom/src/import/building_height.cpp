#include "geom/import/building_height.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "geom/text/text_table.h"
#include "import/written_height.h"

namespace geom {
namespace {

// Whether a word of what stands far above its surroundings is in the text, as in "bell_tower".
bool names_tower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  static constexpr std::array<std::string_view, 17> kTall{
      "tower",     "mast",     "chimney",   "crane",   "silo",       "tank",
      "gasometer", "windmill", "antenna",   "obelisk", "lighthouse", "minaret",
      "spire",     "steeple",  "campanile", "pylon",   "turbine"};
  return std::any_of(kTall.begin(), kTall.end(),
                     [&](std::string_view word) { return text.find(word) != text.npos; });
}

// The height of one building from its attributes.
class Attributes {
 public:
  Attributes(const std::function<std::string(const char*)>& tag, const HeightOptions& options)
      : tag_(tag), options_(options) {}

  BuildingHeight height() {
    auto top = given();
    if (top) out_.from = HeightFrom::height;
    if (!top) top = estimated();
    out_.unread = out_.junk;
    out_.junk |= not_positive_;
    out_.tower = is_tower();
    out_.top = top.value_or(options_.default_height);
    stand();
    return out_;
  }

 private:
  template <class Parse>
  std::optional<double> read(const char* key, const Parse& parse) {
    const std::string text = tag_(key);
    if (trimmed(text).empty()) return std::nullopt;
    const auto value = parse(text);
    if (!value) out_.junk = true;
    return value;
  }

  std::optional<double> length(const char* key,
                               std::optional<double> (*parse)(std::string_view, double)) {
    return read(key, [&](std::string_view text) {
      out_.bare |= parse(text, 1) != parse(text, 2);
      return parse(text, options_.unit);
    });
  }

  // 0 and -1 say that nobody knows.
  std::optional<double> known(std::optional<double> value) {
    if (!value || *value > 0) return value;
    not_positive_ = true;
    return std::nullopt;
  }

  std::optional<double> given() {
    if (!options_.attribute.empty()) {
      const char* const key = options_.attribute.c_str();
      out_.asked = !trimmed(tag_(key)).empty();
      if (const auto top = known(length(key, parse_highest))) return top;
    }
    auto top = known(length("height", parse_highest));
    const auto other = known(length("building:height", parse_highest));
    if (other && !(top && *top >= *other)) top = other;
    return top;
  }

  // The higher of what somebody estimated and what the storeys add up to.
  std::optional<double> estimated() {
    auto top = known(length("est_height", parse_highest));
    if (top) out_.from = HeightFrom::height;
    auto storeys = read("building:levels", parse_levels);
    const auto others = read("building:levels:aboveground", parse_levels);
    if (others && !(storeys && *storeys >= *others)) storeys = others;
    if (!storeys) return top;
    const auto roof = length("roof:height", parse_highest);
    const double above =
        roof ? *roof : read("roof:levels", parse_levels).value_or(0) * options_.storey;
    const auto stacked = known(std::max(0.0, *storeys) * options_.storey + std::max(0.0, above));
    if (!stacked || (top && *top >= *stacked)) return top;
    out_.from = HeightFrom::levels;
    return stacked;
  }

  bool is_tower() const {
    for (const char* key :
         {"building", "building:part", "man_made", "power", "type", "fclass", "class"}) {
      if (names_tower(tag_(key))) return true;
    }
    return !tag_("tower:type").empty();
  }

  // Where it begins: a number of storeys does not tell, because nobody knows how high they are.
  // One that would begin above its own top may be as high as both together: some give the height of
  // a part from where the part begins. It is kept down to the ground.
  void stand() {
    const auto given = length("min_height", parse_lowest);
    auto bottom = given;
    if (!bottom) {
      bottom = read("building:min_level", parse_lowest_level);
      if (bottom) *bottom *= options_.storey;
    }
    if (!bottom || !(*bottom > 0)) return;
    if (*bottom < out_.top) {
      if (given) out_.bottom = *bottom;
    } else {
      out_.junk = true;
      out_.top += *bottom;
    }
  }

  const std::function<std::string(const char*)>& tag_;
  const HeightOptions& options_;
  bool not_positive_ = false;
  BuildingHeight out_;
};

}  // namespace

bool is_attribute(std::string_view name, std::string_view key) {
  return std::equal(name.begin(), name.end(), key.begin(), key.end(),
                    [](unsigned char a, unsigned char b) {
                      return a == b || std::tolower(a) == std::tolower(b);
                    });
}

void add_value(std::string_view value, std::string& list) {
  if (trimmed(value).empty()) return;
  if (!list.empty()) list += ';';
  list += value;
}

BuildingHeight building_height(const std::function<std::string(const char*)>& tag,
                               const HeightOptions& options) {
  return Attributes(tag, options).height();
}

}  // namespace geom
