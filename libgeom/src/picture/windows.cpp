#include "windows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "geom/map/box_index.h"
#include "geom/map/label_colour.h"

namespace geom::picture {
namespace {

constexpr double kStorey = 3;      // metres
constexpr double kBay = 4;         // metres
constexpr double kTouches = 0.25;  // metres between a box and what it stands on
constexpr double kCarried = 0.25;  // of the base

// In the singular.
constexpr std::array<std::string_view, 41> kNoBuildings = {
    "antenna",    "barrier", "bridge", "bush",    "cable",     "canopy",    "ceiling",
    "column",     "crane",   "crown",  "fence",   "floor",     "forest",    "gate",
    "ground",     "hedge",   "keep",   "lamp",    "light",     "line",      "mast",
    "palm",       "pillar",  "plant",  "pole",    "post",      "powerline", "relief",
    "shrub",      "sign",    "stem",   "terrain", "tinrelief", "tree",      "trunk",
    "vegetation", "wall",    "water",  "wire",    "wood",      "zone"};

bool is_no_building(std::string word) {
  if (word.size() > 1 && word.back() == 's') word.pop_back();
  return std::find(kNoBuildings.begin(), kNoBuildings.end(), word) != kNoBuildings.end();
}

double overlap(const Aabb& a, const Aabb& b, int axis) {
  return std::max(0.0, std::min(a.max[axis], b.max[axis]) - std::max(a.min[axis], b.min[axis]));
}

// The area of `box` in plan that `other` carries.
double carried(const Aabb& box, const Aabb& other) {
  const double base = box.min.z();
  const bool below = other.min.z() < base && other.max.z() >= base - kTouches;
  return below ? overlap(box, other, 0) * overlap(box, other, 1) : 0;
}

// What is counted twice, where the carriers overlap, only makes a stem thicker.
bool on_stem(std::span<const Aabb> boxes, std::size_t i, const BoxIndex& index) {
  const Aabb& box = boxes[i];
  double area = 0;
  for (const std::size_t other : index.near(box)) {
    if (other != i) area += carried(box, boxes[other]);
  }
  const double base = (box.max.x() - box.min.x()) * (box.max.y() - box.min.y());
  return area > 0 && area < kCarried * base;
}

bool is_large(const Aabb& box) {
  const Vec3 size = box.max - box.min;
  return size.z() >= kStorey && size.head<2>().maxCoeff() >= kBay;
}

}  // namespace

bool names_no_building(std::string_view label) {
  if (written_colour(label)) return true;
  std::string word;
  bool after_small = false;
  for (const char c : label) {
    const auto letter = static_cast<unsigned char>(c);
    if (!std::isalpha(letter) || (std::isupper(letter) && after_small)) {
      if (is_no_building(word)) return true;
      word.clear();
    }
    if (std::isalpha(letter)) word += static_cast<char>(std::tolower(letter));
    after_small = std::islower(letter) != 0;
  }
  return is_no_building(word);
}

std::vector<bool> windows_of(const BoxMap& map) {
  const std::span<const Aabb> boxes = map.boxes();
  BoxIndex index(index_cell(boxes));
  for (std::size_t i = 0; i < boxes.size(); ++i) index.add(i, boxes[i]);
  std::vector<bool> building;
  for (const std::string& label : map.labels()) building.push_back(!names_no_building(label));
  std::vector<bool> out(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    out[i] = building[map.label()[i]] && is_large(boxes[i]) && !on_stem(boxes, i, index);
  }
  return out;
}

}  // namespace geom::picture
