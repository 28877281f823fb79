#include "report_output.h"

#include <unistd.h>

#include "cli/file/standard_streams.h"
#include "cli/option/output_option.h"

namespace checking {

void ReportOutput::add_to(CLI::App& app) {
  app_ = &app;
  cli::add_output(app, "-o,--output", file_, "reports (default: stdout)");
  app.add_option("--report", form_,
                 "how reports are written; text: a sentence for one record, a table for several; "
                 "json: a line for each (default, but on a terminal)")
      ->check(CLI::IsMember({"text", "json"}));
}

bool ReportOutput::is_text() const {
  if (!form_.empty()) return form_ == "text";
  return file_ == "-" && app_->count("--shard") == 0 && isatty(STDOUT_FILENO) != 0;
}

traj::Colour ReportOutput::colour() const {
  const bool shown = file_ == "-" && app_->count("--quiet") == 0;
  return shown && cli::takes_colour(STDOUT_FILENO) ? traj::Colour::terminal : traj::Colour::none;
}

}  // namespace checking
