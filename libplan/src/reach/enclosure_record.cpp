#include "plan/reach/enclosure_record.h"

#include <tuple>

#include "geom/text/json_line.h"

namespace plan {

std::string to_json_line(const EnclosureRecord& record) {
  geom::JsonLine line;
  line.add("type", "enclosure").add("id", record.id);
  add(line, record.provenance);
  line.add("bounds", std::tuple(record.bounds.min, record.bounds.max));
  line.add("from", record.from).add("to", record.to);
  line.add("around", record.enclosure.around_start ? "from" : "to");
  line.add("cells", record.enclosure.cells,
           [](const geom::Aabb& cell) { return std::tuple(cell.min, cell.max); });
  return line.line();
}

}  // namespace plan
