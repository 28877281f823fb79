"""For analysts of GIS data: from footprints to a grid of how much room there is at one height.

    python3 analyst.py FOOTPRINTS FOLDER [HEIGHT]      leaves clearance.asc (an ASCII grid), plan.svg and page.html there
"""
import sys
from pathlib import Path

import numpy
import skyway

source, folder = Path(sys.argv[1]), Path(sys.argv[2])
height = float(sys.argv[3]) if len(sys.argv) > 3 else 6.0
cell = 1.0  # metres

town = skyway.import_footprints(source, default_height=9, pad=20, ceiling=60, allow_skipped=True)
print(town)
assert town.origin
print(f"(0, 0, 0) is at latitude {town.origin[0]:.6f}, longitude {town.origin[1]:.6f}")
tops = town.boxes[:, 5]
print(f"{len(town)} boxes, the highest {tops.max():.1f} m, {(tops > height).mean():.0%} higher than {height:g} m")

# A point in the middle of each cell of the grid, in rows from north to south, as the grid's format wants them.
(west, south, _), (east, north, _) = town.bounds
x = numpy.arange(west + cell / 2, east, cell)
y = numpy.arange(south + cell / 2, north, cell)[::-1]
grid = numpy.stack([*numpy.meshgrid(x, y), numpy.full((len(y), len(x)), height)], axis=-1)

# The distance from each to the nearest wall or roof; 0 inside. A point has no size, so the vehicle is one.
scene = skyway.CollisionScene(town, "sphere:0")
distance, box = scene.nearest(grid.reshape(-1, 3))
clearance = distance.reshape(len(y), len(x))
print(f"{(clearance == 0).mean():.1%} is built up at {height:g} m; {(clearance > 5).mean():.1%} has 5 m of room")
widest = clearance.argmax()
print(f"most room: {clearance.max():.1f} m around x {x[widest % len(x)]:.1f}, y {y[widest // len(x)]:.1f}")

header = f"ncols {len(x)}\nnrows {len(y)}\nxllcorner {west}\nyllcorner {y[-1] - cell / 2}\ncellsize {cell}"
numpy.savetxt(folder / "clearance.asc", clearance, fmt="%.3f", header=header, comments="")
skyway.plot_plan(town).save(folder / "plan.svg")
skyway.page(town, title=source.name).save(folder / "page.html")
skyway.write_box_map(folder / "town.boxmap", town)
