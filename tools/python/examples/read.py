"""Every artefact as arrays."""
import sys
import skyway

folder = sys.argv[1]
city = skyway.read_box_map(f"{folder}/city.boxmap")
print(f"{len(city)} boxes, the highest {city.boxes[:, 5].max():.0f} m, bounds {city.bounds}")
lattice = skyway.read_lattice(f"{folder}/city.lattice")
print(f"{(lattice.masks() >> 31).sum()} of {len(lattice)} nodes are free, {lattice.spacing:g} m apart")
for path in skyway.read_paths(f"{folder}/path.jsonl"):
    print(path.id, path.status, path.points.shape, f"{path.length:.1f} m")
for trajectory in skyway.read_trajectories(f"{folder}/trajectory.jsonl"):
    print(trajectory.id, trajectory.points.shape, f"{trajectory.durations.sum():.1f} s", trajectory.limits)
reports = skyway.read_reports(f"{folder}/report.jsonl")
print(f"{reports['ok'].mean():.0%} ok, least clearance {reports['clearance'].min():.3f} m")
