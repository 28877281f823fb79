#include "traj/check/profile_csv.h"

#include "geom/text/csv_field.h"
#include "geom/text/number.h"

namespace traj {

std::string profile_rows(std::string_view id, std::span<const ClearanceSpan> spans) {
  std::string rows;
  for (const ClearanceSpan& span : spans) {
    rows += geom::csv_field(id);
    for (const double value : {span.begin, span.end, span.clearance}) {
      rows += ',';
      geom::append_number(rows, value);
    }
    rows += '\n';
  }
  return rows;
}

}  // namespace traj
