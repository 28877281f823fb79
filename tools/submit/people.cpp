#include "people.h"

#include <filesystem>
#include <stdexcept>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "traj/submit/population.h"
#ifdef SKYWAY_FOOTPRINTS
#include "geom/gis/people_raster.h"
#endif

namespace submitting {
namespace {

#ifdef SKYWAY_FOOTPRINTS

// Of all buffers, as latitudes and longitudes.
struct Region {
  geom::Vec2 low = geom::Vec2::Constant(1e9);
  geom::Vec2 high = -low;

  explicit Region(const FlightFiles& flights) {
    for (const auto& buffers : flights.buffers()) {
      for (const traj::RiskVolume& one : buffers) {
        for (const geom::GeodeticPlace& p : one.volume.outline.ring) {
          low = low.cwiseMin(geom::Vec2(p.latitude, p.longitude));
          high = high.cwiseMax(geom::Vec2(p.latitude, p.longitude));
        }
      }
    }
  }
};

traj::Population read(const std::string& path, const FlightFiles& flights) {
  const Region region(flights);
  traj::Population out;
  for (const auto& cell : geom::gis::people_within(path, region.low, region.high)) {
    out.cells.push_back({cell.row, cell.column, cell.people, cell.corners});
  }
  return out;
}

#else

traj::Population read(const std::string&, const FlightFiles&) {
  throw std::runtime_error(
      "--population needs GDAL, and this build of Skyway is without it (SKYWAY_FOOTPRINTS)");
}

#endif

}  // namespace

void count_people(const std::string& path, FlightFiles& flights, traj::Submission& submission,
                  SubmissionFolder& folder) {
  const traj::Population population = read(path, flights);
  const traj::PopulationOnMap cells(population, submission.method.origin);
  for (std::size_t i = 0; i < flights.count(); ++i) {
    const traj::Exposed exposed = cells.exposed(flights.buffers()[i]);
    traj::FlightClaims& claims = flights.claims()[i];
    if (!exposed.inside || population.cells.empty()) {
      throw geom::InputError(path, {.expected = "a raster that reaches as far as every ground risk "
                                                "buffer",
                                    .found = "one that does not hold that of " + claims.id});
    }
    claims.people = exposed.people;
    claims.people_unknown = exposed.unknown;
  }
  folder.add("population.csv", traj::population_csv(population));
  submission.population =
      traj::SourceFile{std::filesystem::path(path).filename().string(),
                       traj::listed_file(path, cli::InputFile(path).read_all()).sha256};
}

}  // namespace submitting
