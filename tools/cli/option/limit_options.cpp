#include "limit_options.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/answer/exit.h"

namespace cli {

void LimitOptions::add_to(CLI::App& app) {
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    CLI::Option* option = app.add_option(kind.option, given_[kind.limit], kind.meaning);
    if (kind.most > 0) {
      option->check(CLI::Range(kind.least, kind.most));
    } else {
      option->check(CLI::PositiveNumber);
    }
  }
}

traj::Limits LimitOptions::limits() const {
  traj::Limits out;
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    const std::optional<double>& given = given_[kind.limit];
    if (!given) continue;
    if (!std::isfinite(*given)) {
      throw UsageError(fmt::format("{}: expected a finite number, found {}", kind.name, *given));
    }
    out[kind.limit] = *given * kind.in_unit;
  }
  return out;
}

}  // namespace cli
