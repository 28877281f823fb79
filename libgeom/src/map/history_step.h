#pragma once

// One step of a map's history: the tool, its inputs and its options.

#include <nlohmann/json.hpp>
#include <string>

#include "geom/base/notes.h"
#include "geom/base/skipped.h"
#include "geom/map/make_map.h"

namespace geom {

using HistoryStep = nlohmann::ordered_json;

// What the step says of the options of make_map().
void add_options(HistoryStep& step, const MakeMapOptions& options);

// Why a source is refused whose skipped obstacles nobody allowed. `skipped` is not empty.
std::string skipped_fault(const Skipped& skipped);

// Throws InputError(source, …) if an obstacle was skipped and that is not allowed, because a
// vehicle could fly through it. Else warns of it and counts it in the step.
void settle_skipped(const Skipped& skipped, bool allowed, const std::string& source,
                    const Notes& notes, HistoryStep& step);

// A history of this step alone, as JSON.
std::string history_of(const HistoryStep& step);

}  // namespace geom
