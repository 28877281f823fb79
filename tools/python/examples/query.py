"""A hundred thousand questions to the collision structure, in one call each."""
import sys
import numpy
import skyway

city = skyway.read_box_map(f"{sys.argv[1]}/city.boxmap")
scene = skyway.CollisionScene(city, "tello", margin=0.2)
low, high = map(numpy.array, city.bounds)
random = numpy.random.default_rng(1)
points = random.uniform(low, high, (100_000, 3))
segments = numpy.hstack([points, points + random.uniform(-20, 20, points.shape)])
print(f"{scene.hits(segments).mean():.1%} of the segments hit a building")
distance, box = scene.nearest(points)
print(f"clearance: median {numpy.median(distance):.1f} m; the building near the first point: {city.boxes[box[0]]}")
