#pragma once

// Boxes before they are a map: what importers produce and a table holds.
//
// Example:
//   geom::BoxTable table;
//   table.add({{0, 0, 0}, {10, 10, 8}}, 17, table.label_of("house"));  // 17: its row in the source
//   table.set_time(0, {.from = 3600, .until = 7200});
//   table.keep_if([&](std::size_t i) { return table.boxes[i].max.z() > 5; });
//   assert(table.boxes.size() == 1 && table.labels[table.label[0]] == "house");

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/time_span.h"
#include "geom/shape/aabb.h"

namespace geom {

struct BoxTable {
  std::vector<Aabb> boxes;                 // in the order of the source
  std::vector<std::uint64_t> ids;          // source row or feature, one a box
  std::vector<std::uint32_t> label;        // index into `labels`, one a box
  std::vector<std::string> labels = {""};  // each once; labels[0] is "" (no label)
  std::vector<TimeSpan> times;  // when each is there; those beyond its end are always there

  void add(const Aabb& box, std::uint64_t id, std::uint32_t of_label = 0) {
    boxes.push_back(box);
    ids.push_back(id);
    label.push_back(of_label);
  }

  // When box i is there.
  TimeSpan time(std::size_t i) const { return i < times.size() ? times[i] : TimeSpan{}; }
  void set_time(std::size_t i, const TimeSpan& span) {
    if (i >= times.size()) times.resize(i + 1);
    times[i] = span;
  }

  // The index of a label, which is added where it is new. Cost: log of the labels.
  std::uint32_t label_of(std::string_view text);

  // Keeps the boxes for whose index `keep` says so, in their order; the labels stay.
  template <class Keep>
  void keep_if(const Keep& keep) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!keep(i)) continue;
      boxes[n] = boxes[i];
      ids[n] = ids[i];
      label[n] = label[i];
      if (n < times.size()) times[n] = time(i);
      ++n;
    }
    boxes.resize(n);
    ids.resize(n);
    label.resize(n);
    if (n < times.size()) times.resize(n);
  }

 private:
  std::map<std::string, std::uint32_t, std::less<>> known_;  // of labels, as far as they are asked
};

// Adds the boxes of `b` to those of `a`, each with the label of the same text and with its times.
void append(BoxTable& a, const BoxTable& b);

}  // namespace geom
