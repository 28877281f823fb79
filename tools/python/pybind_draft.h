#pragma once

// What the Python functions that make maps share: from a draft to what the package's Python takes.

#include <functional>

#include "cli/file/files.h"
#include "geom/base/notes.h"
#include "geom/map/map_draft.h"
#include "pybind_module.h"

namespace binding {

// The map of what `draft` gives, and the warnings that it was given on the way, as a tuple. Works
// without the GIL.
inline py::tuple made(const std::function<geom::MapDraft(const geom::Notes&)>& draft) {
  std::vector<std::string> warnings;
  geom::Notes notes;
  notes.warning = [&](const std::string& text) { warnings.push_back(text); };
  std::optional<geom::MadeMap> made;
  {
    const Released released;
    made = geom::make_map(draft(notes), cli::all_cores());
  }
  return py::make_tuple(std::move(made->map), warnings);
}

}  // namespace binding
