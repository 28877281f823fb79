#pragma once

// What a run tells people that warns of nothing: counts, and how a batch came out.

#include <string>
#include <string_view>

#include "cli/option/common.h"
#include "geom/base/notes.h"

namespace cli {

// One line on stderr, as complain() writes it; nothing with -q.
void tell(const Common& common, std::string_view tool, std::string_view message);

// The same of something that is refused: red on a terminal.
void tell_no(const Common& common, std::string_view tool, std::string_view message);

// Of `count` records that were not found or solved, and so are not shown; nothing of none.
void tell_left_out(const Common& common, std::string_view tool, std::size_t count);

// What a reader says of a file, on stderr. `common` must outlive it.
geom::Notes notes_of(const Common& common, std::string tool);

}  // namespace cli
