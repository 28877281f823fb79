#include "option_groups.h"

#include <cctype>
#include <map>

#include "geom/base/text_stream.h"
#include "geom/vehicle/limits.h"

namespace cli {
namespace {

// "--margin=METRES": an option and the word for its value. A row with a tool before the option,
// such as "cloud--gap=METRES", holds for that tool alone and comes before the row without one.
struct Group {
  const char* title;
  const char* options;
};

constexpr Group kGroups[] = {
    {"Input",
     "--queries --set --length=METRES --from --to --format --file-format --paths-csv --paths "
     "plan--home --home-local --contingencies --lattice --roadmap --old-map --patch --map --plan "
     "check--tube export--tube submit--tube --moving --home-place --operation --population "
     "--between --alternatives --others --planner-cmd=COMMAND --frames view--poses "
     "--epoch=INSTANT --departure=SECONDS --id=NAME --terrain --where=SQL "
     "--height-attribute=NAME --types=TYPE,... --label-by --model-path=FOLDER --without=NAME "
     "--fence --keep-out --keep-out-local --add --zones --type=TYPE,... --days=COUNT "
     "--ground-model=FILE|METRES --zero-sea=METRES --geoid-grid=GRID --remove=IDS|FILE --far "
     "--metres --crs --units --vertical-units --height-units --ground-of --vertical-error=METRES "
     "footprints--cell=METRES --default-height=METRES --storey=METRES --classes cloud--origin "
     "footprints--origin=LAT,LON mesh--origin --zero-height=METRES --up footprints--axes --frame "
     "--begin --noise-points --unknown --allow-skipped --collisions-only "
     "import-trajectory--gap=METRES --resolution=METRES --scale=FACTOR --all --verify"},
    {"Output",
     "-o --output query--grid query--cell=METRES --at-height=METRES check--report=WORD "
     "--report-file --json --degrees --profile --profile-step=LENGTH --junit --certificate "
     "--tree --corridor-file --python --table --show --unchecked --no-clearance "
     "--resample=METRES export--rate=HERTZ export--axes --wpml-version --aircraft --hover "
     "--turns=METRES --lost-link --gimbal=DEGREES --rally --fence-budget=CORNERS --fence-out "
     "--rally-out --params-out --procedure export--fence export--return --volumes "
     "--buffer=METRES --no-page --contingency --ground-buffer --reaction=SECONDS "
     "--stop-tilt=DEGREES --ground-level=METRES --speed=METRES/S export--tolerance=METRES "
     "--title=WORDS --depth --depth-unit=METRES --ids render--poses --clear-tube --log-rate=HERTZ"},
    {"Vehicle and room",
     "--vehicle --margin=METRES --spare=METRES --memory=BYTES --navigation --tracking"},
    {"Limits",
     "--override --require-clearance=METRES --sampled --drop-refused check--return "
     "--no-least-height"},  // and geom::kLimitKinds
    {"Drone and place",
     "--takeoff-place --origin --geoid=METRES --ground=METRES --takeoff-height=METRES "
     "--heading=DEGREES --acceptance=METRES --braking=METRES/S2 --return-height=METRES "
     "--terrain-height=METRES --autopilot=WORD --params --drag=PER-SECOND "
     "check--ground-model=FILE|METRES view--ground-model=FILE|METRES "
     "import-trajectory--ground-model=FILE|METRES --terrain-error=METRES --surface-band=LOW,HIGH"},
    {"Flights together",
     "--together --separation --separation-box --downwash --parked --max-delay=SECONDS --improve "
     "--nearer-than=METRES"},
    {"Boxes",
     "cloud--mode cloud--cell=METRES cloud--step=METRES cloud--gap=METRES --ground-points "
     "cloud--tolerance=METRES --outliers=COUNT,FACTOR --voxel=METRES --ground-by "
     "--ground-cell=METRES --ground-slope=METRES --ground-height=METRES --ground-step=METRES "
     "--ground-widest=METRES --min-points --seal=METRES --floor=METRES --ceiling=METRES "
     "--pad=METRES --bounds --bloat-percent=PERCENT --inflate=METRES --tile=METRES "
     "--slack=METRES map--step=METRES --agl=LOW,HIGH --close-unknown --solid "
     "--height-step=METRES --by=METRES --size=METRES --height=METRES"},
    {"Search and solver",
     "--method --quality --spacing=METRES --connect=COUNT --node plan--step=METRES "
     "--goal-bias=SHARE --iterations --radius=METRES --patience plan--seconds=SECONDS --raw "
     "--snap-ends=METRES --bound=SHARE --layers --reach=METRES --part=METRES --region --exact "
     "--solver --times --corridor --rho=SECONDS --yaw=WORD --until-converged --precision=PERCENT "
     "--min-trials --trials --repeat --ompl-seconds=SECONDS"},
    {"Simulated flight",
     "--wind --gusts=METRES/S --noise --controller --gains=WORD|FILE --feed-forward "
     "--delay=SECONDS --hover-time=SECONDS --settle=SECONDS --loop-period=SECONDS "
     "--mass-error=SHARE --proved-tube --wind-spread=METRES/S --gust-most=METRES/S "
     "--gust-lag=SECONDS --start-error=METRES --start-speed=METRES/S --drag-error=SHARE "
     "--motor-lag-error=SHARE --inertia-error=SHARE --gain-error=SHARE --noise-most --runs "
     "--tune --cost=WORDS"},
    {"Picture",
     "--view --camera --rate=HERTZ --at=SECONDS --image-size=WIDTHxHEIGHT --azimuth=DEGREES "
     "--elevation=DEGREES --shadows --samples"},
    {"How it runs",
     "--seed=NUMBER --threads --progress --stats -q --quiet --shard=K/N --version -h --help "
     "--help-all"},
};

// "METRES/S2" of the unit "m/s2".
std::string word_of_unit(std::string_view unit) {
  std::string word;
  for (const char c : unit) word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (unit.starts_with("m/")) word.replace(0, 1, "METRES");
  return word;
}

std::map<std::string, OptionPlace, std::less<>> read_groups() {
  std::map<std::string, OptionPlace, std::less<>> places;
  for (const Group& group : kGroups) {
    geom::TextInput words(group.options);
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      places[word.substr(0, equals)] = {group.title,
                                        equals == std::string::npos ? "" : word.substr(equals + 1)};
    }
  }
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    places[kind.option] = {"Limits", word_of_unit(kind.unit)};
  }
  return places;
}

}  // namespace

OptionPlace place_of_option(std::string_view tool, std::string_view option) {
  static const auto places = read_groups();
  constexpr std::string_view kFamily = "skyway-";
  if (tool.starts_with(kFamily)) tool.remove_prefix(kFamily.size());
  auto at = places.find(std::string(tool) + std::string(option));
  if (at == places.end()) at = places.find(option);
  return at == places.end() ? OptionPlace{kOptionGroups.back(), ""} : at->second;
}

}  // namespace cli
