#pragma once

// What skyway-cloud is asked, beside its files and shards.

#include <CLI/CLI.hpp>
#include <string>

#include "geom/cloud/draft_cloud.h"
#include "place_options.h"

namespace cloud {

struct Options {
  const geom::CloudFormat* format = nullptr;  // null: found out
  std::string mode = "columns";
  std::string ground = "keep";
  std::string noise = "keep";
  std::string unknown = "free";
  std::string outliers;  // "NEIGHBOURS,DEVIATIONS"
  PlaceOptions place;
  geom::CloudDraftOptions draft;

  void add_to(CLI::App& app);
  void settle();  // once parsed; throws cli::UsageError

  // Once it is known what the file is: throws cli::UsageError for options that change nothing then.
  void settle_format(const geom::CloudFormat& known, const std::string& name);

 private:
  // Throws cli::UsageError for options that change nothing where the ground is told so.
  void require_used_ground(const std::string& told_by) const;
  void settle_outliers();

  const CLI::App* app_ = nullptr;
};

}  // namespace cloud
