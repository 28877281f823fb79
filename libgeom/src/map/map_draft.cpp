#include "geom/map/map_draft.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/text/counted.h"
#include "geom/text/parse_json.h"
#include "history_step.h"

namespace geom {

void add_options(HistoryStep& step, const MakeMapOptions& options) {
  step["seal"] = options.seal.value_or(0);
  step["pad"] = options.pad.value_or(0);
  if (options.headroom) step["headroom"] = *options.headroom;
  if (options.scale != 1) step["scale"] = options.scale;
  if (options.bloat_percent > 0) step["bloat_percent"] = options.bloat_percent;
  if (options.inflate > 0) step["inflate"] = options.inflate;
  if (options.floor) step["floor"] = *options.floor;
  if (options.ceiling) step["ceiling"] = *options.ceiling;
}

std::string skipped_fault(const Skipped& skipped) {
  return fmt::format(
      "{} cannot be built: {}; correct the file, or leave out what cannot be built with "
      "--allow-skipped",
      counted(skipped.count(), "possible obstacle"), skipped.text());
}

void settle_skipped(const Skipped& skipped, bool allowed, const std::string& source,
                    const Notes& notes, HistoryStep& step) {
  if (skipped.empty()) return;
  if (!allowed) throw InputError(source, {.says = skipped_fault(skipped)});
  notes.warning(fmt::format(
      "{}: {} left out: {}", source,
      counted(skipped.count(), "possible obstacle is", "possible obstacles are"), skipped.text()));
  step["skipped"] = skipped.count();
}

std::string history_of(const HistoryStep& step) { return HistoryStep::array({step}).dump(); }

MadeMap make_map(MapDraft draft, const Execution& run) {
  if (draft.table.boxes.empty()) {
    throw InputError(draft.source, {.expected = "at least one obstacle", .found = "none"});
  }
  return make_map(std::move(draft.table), std::move(draft.frame), std::move(draft.history),
                  draft.source, draft.options, run);
}

std::size_t skipped_in(const BoxMapSpec& spec) {
  std::size_t count = 0;
  if (spec.history.empty()) return count;
  const nlohmann::json steps = parse_json(spec.history, "the map's history");
  for (const nlohmann::json& step : steps) {
    if (!step.is_object()) continue;
    const auto skipped = step.find("skipped");
    if (skipped != step.end() && skipped->is_number_unsigned()) {
      count += skipped->get<std::size_t>();
    }
  }
  return count;
}

}  // namespace geom
