"""For researchers of planners: a sampler of your own, held against Skyway's on the same queries, judged by proof.

    python3 researcher.py FOLDER      the folder has city.boxmap (./bootstrap demo makes one); leaves comparison.svg there
"""
import sys
import time
from pathlib import Path

import numpy
import skyway
from numpy.typing import NDArray

folder = Path(sys.argv[1])
city = skyway.read_box_map(folder / "city.boxmap")
scene = skyway.CollisionScene(city, "box:0.5,0.5,0.3", margin=0.2)
random = numpy.random.default_rng(1)


def my_planner(start: NDArray[numpy.float64], goal: NDArray[numpy.float64]) -> skyway.Path | None:
    """A probabilistic roadmap: 400 points near the query, the straight lines between them in one batch, the shortest way."""
    reach = 0.4 * numpy.linalg.norm(goal - start) + 30
    points = random.normal((start + goal) / 2, reach / 2, (400, 3))
    points = numpy.vstack([start, goal, points[scene.free(points)]])
    distance = numpy.linalg.norm(points[:, None] - points[None], axis=2)
    a, b = numpy.nonzero(numpy.triu(distance < reach, 1))
    free = scene.free(numpy.hstack([points[a], points[b]]))
    length = numpy.full(distance.shape, numpy.inf)
    length[a[free], b[free]] = length[b[free], a[free]] = distance[a[free], b[free]]
    numpy.fill_diagonal(length, 0)
    cost, before = length[0], numpy.zeros(len(points), int)
    for _ in range(30):  # the shortest ways of one leg more
        through = cost[:, None] + length
        before = numpy.where(through.min(axis=0) < cost, through.argmin(axis=0), before)
        cost = numpy.minimum(cost, through.min(axis=0))
    if numpy.isinf(cost[1]):
        return None
    way = [1]
    while way[-1] != 0:
        way.append(before[way[-1]])
    return skyway.Path(points[way[::-1]], id="mine")


planner = skyway.Planner(scene)
pairs = random.uniform([-400, -300, 10], [350, 300, 40], (200, 2, 3))
free = scene.free(pairs.reshape(-1, 3)).reshape(-1, 2).all(axis=1)
blocked = scene.hits(pairs.reshape(-1, 6))
for query in pairs[free & blocked][:5]:  # the straight line tells nothing
    best = planner.plan(*query, quality="best")
    began = time.perf_counter()
    mine = my_planner(*query)
    print(f"mine {mine} in {time.perf_counter() - began:.2f} s, skyway {best}")
    if mine and best:
        assert skyway.check(scene, mine)["ok"]  # a proof along every leg, not at samples
        print(f"mine is {mine.length / best.length:.2f} times as long")
        skyway.plot_plan(city, [mine, best]).save(folder / "comparison.svg")
