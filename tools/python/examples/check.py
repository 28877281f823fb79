"""The proof, and what an error looks like."""
import sys
import numpy
import skyway

city = skyway.read_box_map(f"{sys.argv[1]}/city.boxmap")
for trajectory in skyway.read_trajectories(f"{sys.argv[1]}/trajectory.jsonl"):
    assert trajectory.vehicle and trajectory.margin is not None
    scene = skyway.CollisionScene(city, trajectory.vehicle, trajectory.margin)
    report = skyway.check(scene, trajectory, exact=True)
    print(report["id"], report["ok"], f"clearance {report['clearance']:.3f} m at {report['clearance_time']:.1f} s")
scene = skyway.CollisionScene(city, "tello")
report = skyway.check(scene, numpy.array([[-425, -320.5, 7], [357, 204, 5.0]]))
print(report["ok"], report["reason"], report["place"])
try:
    skyway.read_paths(f"{sys.argv[1]}/trajectory.jsonl")
except skyway.InputError as error:
    print("refused:", error)
