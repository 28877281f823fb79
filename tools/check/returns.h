#pragma once

// --return of skyway-check: whether the vehicle comes home by itself from every instant.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "traj/check/check_return.h"

namespace checking {

class Returns {
 public:
  void add_to(CLI::App& app);
  bool asked() const { return asked_; }
  // Throws cli::UsageError for options that mean nothing without --return.
  void refuse_idle(const CLI::App& app) const;

  // `height`: --return-height; `speed`: --vmax.
  traj::ReturnRules rules(const std::optional<double>& height,
                          const std::optional<double>& speed) const;

 private:
  bool asked_ = false;
  std::string action_ = "rtl";
  std::optional<geom::Vec3> home_;
  bool no_least_height_ = false;
};

}  // namespace checking
