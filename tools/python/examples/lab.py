"""For a lab: a room and four small drones, whose trajectories are checked against the room and one another, and drawn.

    python3 lab.py FOLDER      leaves plan.svg, profile.svg, clearance.svg, page.html, trajectories and Crazyflie files there
"""
import itertools
import sys
from pathlib import Path

import numpy
import skyway

folder = Path(sys.argv[1])
room = skyway.BoxMap([[-0.3, -0.3, 0, 0.3, 0.3, 2.0], [1.5, -2, 0, 1.8, -0.5, 1.2]], labels=["pillar", "table"],
                     bounds=[[-3, -3, 0.0], [3, 3, 2.5]])
scene = skyway.CollisionScene(room, "crazyflie", margin=0.1)
print(scene)

# Four drones fly once around the pillar, each a quarter of the circle ahead of the next.
limits = {"vmax": 1.5, "amax": 3.0}
corners = numpy.linspace(0, 2 * numpy.pi, 9)
fleet = []
for i in range(4):
    angle = corners + i * numpy.pi / 2
    circle = numpy.stack([1.1 * numpy.cos(angle), 1.1 * numpy.sin(angle), 1 + 0.2 * numpy.sin(angle)], axis=1)
    fleet.append(skyway.Trajectory.through(circle, 1.5 * numpy.arange(9), id=f"cf{i + 1}", limits=limits))

# The proof of each against the room; the vehicle's own limits hold too.
reports = [skyway.check(scene, one) for one in fleet]
for report in reports:
    print(report["id"], "ok" if report["ok"] else report["reason"], f"clearance {report.get('clearance', 0):.2f} m",
          f"fastest {report.get('speed', 0):.2f} m/s")

# How near each pair comes, at 100 instants a second. This looks; `skyway-check --separation` proves.
times = numpy.linspace(0, max(one.duration for one in fleet), 1200)
places = [one.sample(times)[0] for one in fleet]
for (i, a), (j, b) in itertools.combinations(enumerate(places), 2):
    print(f"{fleet[i].id} and {fleet[j].id}: {numpy.linalg.norm(a - b, axis=1).min():.2f} m")

skyway.write_trajectories(folder / "fleet.jsonl", fleet)
skyway.plot_plan(room, fleet).save(folder / "plan.svg")
skyway.plot_profile(fleet[0]).save(folder / "profile.svg")
skyway.plot_clearance(scene, fleet).save(folder / "clearance.svg")
skyway.page(room, fleet, reports=reports, title="Around the pillar").save(folder / "page.html")
for one in fleet:
    made = skyway.export_mission(scene, one, "crazyflie")
    print(one.id, f"{len(made['bytes'])} bytes" if made["ok"] else made["message"])
    if made["ok"]:
        (folder / f"{one.id}.csv").write_bytes(made["bytes"])
