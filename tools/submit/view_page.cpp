#include "view_page.h"

#include "cli/content/contents.h"
#include "view/layers.h"
#include "view/page.h"

namespace submitting {

std::string view_page(const cli::Common& common, const std::vector<std::string>& files,
                      const traj::SubmittedFlights& flights, const std::string& title) {
  cli::DroneFileOptions missions{.format = cli::kAuto};
  missions.reading = flights.reading();
  missions.autopilot.flier = flights.reading().flier;
  const cli::ContentKinds kinds{
      .archives = true, .drone_files = &missions, .expected = "a trajectory or a mission"};
  const cli::Contents contents = cli::read_contents(files, kinds);
  view::Bundle bundle;
  const view::Json meta =
      view::describe(contents, {}, cli::VehicleOptions(), common.execution("pairs"), bundle);
  return view::page(title, meta, bundle);
}

}  // namespace submitting
