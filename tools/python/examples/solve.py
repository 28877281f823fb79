"""From path to proved trajectory, and its states over time."""
import sys
import numpy
import skyway

city = skyway.read_box_map(f"{sys.argv[1]}/city.boxmap")
path = skyway.read_paths(f"{sys.argv[1]}/path.jsonl")[0]
assert path.vehicle and path.margin is not None
scene = skyway.CollisionScene(city, path.vehicle, path.margin)  # with the limits of its profile
trajectory = skyway.solve(scene, path, limits={"vmax": 8, "amax": 6}, yaw="along")
position, velocity, acceleration, jerk = trajectory.sample(numpy.linspace(0, trajectory.duration, 1000))
print(trajectory.status, trajectory.rung, f"{trajectory.duration:.1f} s")
print(f"fastest {numpy.linalg.norm(velocity, axis=1).max():.2f} m/s, highest {position[:, 2].max():.1f} m")
skyway.write_trajectories(f"{sys.argv[1]}/python-trajectory.jsonl", [trajectory])
