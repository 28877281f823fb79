#include "tool_page.h"

#include "geom/base/text_stream.h"

namespace cli {
namespace {

struct Page {
  const char* tool;
  const char* example;
  const char* common;  // empty: --help shows all options
};

constexpr Page kPages[] = {
    {"skyway-bench",
     "skyway-import data/downtown.csv | skyway-bench - --vehicle tello --queries "
     "data/samples/queries.jsonl --method auto,astar -o report.json",
     "--queries --length --roadmap --lattice --output --vehicle --margin --method "
     "--planner-cmd --quality --precision --trials --seed --threads"},
    {"skyway-check",
     "skyway-import data/downtown.csv | skyway-check - data/samples/trajectories.jsonl",
     "--file-format --output --report --certificate --vehicle --margin --vmax --ground "
     "--return --together --exact"},
    {"skyway-cloud", "skyway-cloud data/samples/scan.xyz --cell 1 -o scan.boxmap",
     "--format --crs --origin --unknown --allow-skipped --output --mode --cell --ground-points "
     "--floor --ceiling --bounds --threads"},
    {"skyway-export",
     "skyway-import data/downtown.csv | skyway-export - data/samples/trajectories.jsonl --id north "
     "--format crazyflie -o north.csv",
     "--format --id --output --speed --show --unchecked --vehicle --margin --origin "
     "--ground --separation"},
    {"skyway-fleet",
     "skyway-fleet data/samples/trajectories.jsonl --separation 20,8 -o fleet.jsonl --report-file "
     "delays.json",
     "--map --moving --others --alternatives --output --report-file --vehicle --separation "
     "--parked --max-delay --threads"},
    {"skyway-fly",
     "skyway-import data/downtown.csv | skyway-fly - data/samples/trajectories.jsonl --vehicle "
     "quad2kg --wind 2,0,0 -o flight.csv",
     "--output --report-file --proved-tube --vehicle --margin --wind --gusts --noise "
     "--controller --gains "
     "--runs --tune --seed --threads"},
    {"skyway-footprints", "skyway-footprints data/samples/blocks.geojson -o blocks.boxmap",
     "--format --origin --terrain --height-attribute --default-height --allow-skipped --output "
     "--slack --floor --ceiling --bounds --threads"},
    {"skyway-import", "skyway-import data/downtown.csv -o downtown.boxmap",
     "--format --units --frame --allow-skipped --model-path --output --seal --floor --ceiling "
     "--pad --bounds --threads"},
    {"skyway-import-flight", "skyway-import-flight data/samples/hop.ulg -o flight.csv", ""},
    {"skyway-import-trajectory",
     "skyway-import-trajectory data/samples/mission.plan --origin 37,-122,0 --ground 0 --vehicle "
     "quad2kg -o mission.jsonl",
     "--format --map --id --origin --geoid --ground --return-height --terrain-height --gap "
     "--output --vehicle --margin --takeoff-place --heading"},
    {"skyway-info", "skyway-info data/downtown.csv", ""},
    {"skyway-join",
     "skyway-fly data/samples/trajectories.jsonl --vehicle quad2kg --shard 1/1 -o s.1 && "
     "skyway-join s.1 -o flight.csv",
     ""},
    {"skyway-lattice",
     "skyway-import data/downtown.csv | skyway-lattice - --spacing 10 --connect 26 --vehicle tello "
     "-o city.lattice",
     "--output --vehicle --margin --memory --spacing --connect --node --threads --shard"},
    {"skyway-map", "skyway-import data/downtown.csv | skyway-map info -", "--threads --quiet"},
    {"skyway-mesh", "skyway-mesh data/samples/house.obj --solid --slack 0.5 -o house.boxmap",
     "--format --units --up --origin --allow-skipped --output --slack --solid --seal --floor "
     "--bounds --threads"},
    {"skyway-plan",
     "skyway-import data/downtown.csv | skyway-plan - --vehicle tello --from=-372,-149,12 "
     "--to=-205,-292,40 -o path.jsonl",
     "--from --to --queries --home --roadmap --lattice --output --vehicle --margin "
     "--method --quality --bound --threads"},
    {"skyway-plot", "skyway-plot profile data/samples/trajectories.jsonl --id north -o profile.svg",
     ""},
    {"skyway-query",
     "skyway-import data/downtown.csv -o city.boxmap && echo '{\"point\":[-372,-149,12]}' | "
     "skyway-query city.boxmap --vehicle tello",
     "--metres --output --degrees --vehicle --margin --memory --threads --quiet"},
    {"skyway-render",
     "skyway-import data/downtown.csv | skyway-render - --view overview -o overview.png",
     "--output --depth --vehicle --id --view --camera --rate --at --image-size --azimuth "
     "--elevation --shadows --threads"},
    {"skyway-replan",
     "skyway-import data/downtown.csv | skyway-replan - data/samples/paths.jsonl -o paths.jsonl",
     "--paths --lattice --roadmap --output --vehicle --margin --quality --metres --threads --stats "
     "--quiet"},
    {"skyway-roadmap",
     "skyway-import data/downtown.csv | skyway-roadmap - --vehicle tello --reach 30 -o "
     "city.roadmap",
     "--patch --old-map --output --vehicle --margin --reach --part --region --shard --threads"},
    {"skyway-submit",
     "skyway-import data/downtown.csv -o city.boxmap && skyway-submit city.boxmap "
     "data/samples/mission.plan --operation data/samples/operation.json --vehicle quad2kg "
     "--origin 37,-122,10 --ground 0 --between 2026-05-04T06:30:00Z,2026-05-04T07:00:00Z -o folder",
     "--operation --output --origin --buffer --contingency --ground-buffer --population --between "
     "--vehicle --threads"},
    {"skyway-synth", "skyway-synth --seed 7 --size 400 -o town.csv", ""},
    {"skyway-traj",
     "skyway-import data/downtown.csv | skyway-traj - data/samples/paths.jsonl --vmax 8 --amax 6 "
     "-o trajectories.jsonl",
     "--output --vehicle --margin --vmax --amax --jmax --tilt --yaw-rate --solver "
     "--times --yaw --rho --threads"},
    {"skyway-view",
     "skyway-import data/downtown.csv | skyway-view - data/samples/trajectories.jsonl -o page.html",
     "--frames --poses --output --title --vehicle --margin --origin --ground --takeoff-place "
     "--heading --return-height"},
};

}  // namespace

ToolPage page_of_tool(std::string_view tool) {
  for (const Page& page : kPages) {
    if (page.tool != tool) continue;
    ToolPage out{page.example, {}};
    geom::TextInput names(page.common);
    for (std::string name; names >> name;) out.common.insert(name);
    return out;
  }
  return {};
}

}  // namespace cli
