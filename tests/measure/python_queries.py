"""python_queries.py BUILD_DIR MAP: 1e6 segment queries from Python beside the same batch in C++, turn by turn."""

import pathlib
import subprocess
import sys
import tempfile
import time

import numpy

build, city = pathlib.Path(sys.argv[1]), sys.argv[2]
sys.path.insert(0, str(build / "python"))
import skyway  # noqa: E402

REPEATS = 7
scene = skyway.CollisionScene(skyway.read_box_map(city), "box:1,1,1")
low, high = map(numpy.array, scene.free_bounds)
random = numpy.random.default_rng(1)
points = random.uniform(low, high, (1_000_000, 3))
way = random.normal(size=points.shape)
way *= (random.uniform(5, 50, len(way)) / numpy.linalg.norm(way, axis=1))[:, None]
segments = numpy.hstack([points, points + way])


def of_python(threads):
    begin = time.perf_counter()
    hits = scene.hits(segments, threads=threads)
    return time.perf_counter() - begin, int(hits.sum())


def of_cpp(threads):
    told = subprocess.run([build / "tests/measure/segment_batch", city, file.name, str(threads), "3"], check=True,
                          capture_output=True, text=True).stdout.split()
    return float(told[0]), int(told[1])


with tempfile.NamedTemporaryFile() as file:
    segments.tofile(file.name)
    for threads in (1, 2):
        of_python(threads)
        pairs = [(of_python(threads), of_cpp(threads)) for _ in range(REPEATS)]
        counts = {count for pair in pairs for _, count in pair}
        assert len(counts) == 1, counts
        ours, theirs = (min(pair[i][0] for pair in pairs) for i in (0, 1))
        print(f"threads {threads}: Python {ours:.4f} s, C++ {theirs:.4f} s, ratio {ours / theirs:.3f}; {counts.pop()} hit")
