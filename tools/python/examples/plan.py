"""From query to path, one and many."""
import sys
import numpy
import skyway

city = skyway.read_box_map(f"{sys.argv[1]}/city.boxmap")
lattice = skyway.read_lattice(f"{sys.argv[1]}/city.lattice")
assert lattice.vehicle and lattice.margin is not None
scene = skyway.CollisionScene(city, lattice.vehicle, lattice.margin)
planner = skyway.Planner(scene, lattice=lattice)
path = planner.plan((-425, -320.5, 7), (357, 204, 5), snap_ends=5)
print(path.status, f"{path.length:.1f} m", path.points.shape)
low, high = map(numpy.array, city.bounds)
ends = numpy.random.default_rng(2).uniform(numpy.tile(low, 2), numpy.tile(high, 2), (50, 6))
paths = planner.plan_batch(ends, snap_ends=20)
print(sum(p.status == "found" for p in paths), "of", len(paths), "found")
skyway.write_paths(f"{sys.argv[1]}/python-paths.jsonl", paths)
