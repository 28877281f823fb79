#include "geom/map/box_table.h"

namespace geom {

std::uint32_t BoxTable::label_of(std::string_view text) {
  if (known_.size() != labels.size()) {
    known_.clear();
    for (std::size_t i = 0; i < labels.size(); ++i) {
      known_.emplace(labels[i], static_cast<std::uint32_t>(i));
    }
  }
  if (const auto at = known_.find(text); at != known_.end()) return at->second;
  const auto index = static_cast<std::uint32_t>(labels.size());
  labels.emplace_back(text);
  known_.emplace(text, index);
  return index;
}

void append(BoxTable& a, const BoxTable& b) {
  if (!b.times.empty()) {
    a.times.resize(a.boxes.size());
    a.times.insert(a.times.end(), b.times.begin(), b.times.end());
  }
  std::vector<std::uint32_t> label_of;
  for (const std::string& label : b.labels) label_of.push_back(a.label_of(label));
  a.boxes.insert(a.boxes.end(), b.boxes.begin(), b.boxes.end());
  a.ids.insert(a.ids.end(), b.ids.begin(), b.ids.end());
  for (const std::uint32_t label : b.label) a.label.push_back(label_of[label]);
}

}  // namespace geom
