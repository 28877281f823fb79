#pragma once

// The exit codes of every tool, and the error that means wrong usage.

#include "geom/base/option_error.h"

namespace cli {

enum class Exit { yes = 0, no = 1, usage = 2, bad_input = 3, failed = 4 };

// Wrong usage found after parsing: exit 2.
class UsageError : public geom::OptionError {
 public:
  using geom::OptionError::OptionError;
};

}  // namespace cli
