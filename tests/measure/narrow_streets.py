"""narrow_streets.py BIN_DIR [options]: how many flights through narrow streets the proved tube makes possible.

The city is made up from --seed: for each query an own pair of squares, which one street joins. A street is 1 to 3 m
wide, drawn evenly, between houses that reach the ceiling, and has a bend of two corners. So there is no other way, and
the narrowest place of each query is known.

For each query: is there a path with a guessed margin (--guess), and is there a trajectory whose own proved tube is clear
(skyway-traj --proved-tube, from a path with the margin --begin)? skyway-check holds the map against these tubes once more.
--first and --count take a part of the queries, for a measurement in parts: seeds of one city give the same parts.
"""

import argparse
import json
import pathlib
import random
import resource
import subprocess
import tempfile

WIDE, DEEP = 20.0, 12.0  # m, of the place of a query
HIGH = 12.0  # m, of houses and ceiling
WALL = 1.0  # m


def street(rng):
    """The width of a street, and how far its second half is beside its first."""
    return rng.uniform(1, 3), rng.uniform(1, 3) * rng.choice((-1, 1))


def houses(x, y, width, aside):
    """Boxes (low corner, high corner) of a place at x, y: walls around, and houses with the street between them."""
    middle = y + DEEP / 2
    first, second = middle - aside / 2, middle + aside / 2  # of the halves of the street
    begin, bend, end = x + 5, x + 10, x + 15
    boxes = [((x, y), (x + WIDE, y + WALL)), ((x, y + DEEP - WALL), (x + WIDE, y + DEEP)),
             ((x, y), (x + WALL, y + DEEP)), ((x + WIDE - WALL, y), (x + WIDE, y + DEEP))]
    half = width / 2
    for low, high, at in ((begin, bend - half, first), (bend + half, end, second)):
        boxes += [((low, y), (high, at - half)), ((low, at + half), (high, y + DEEP))]
    # Where the street bends: houses on the outer sides of both corners.
    south, north = min(first, second) - half, max(first, second) + half
    boxes += [((bend - half, y), (bend + half, south)), ((bend - half, north), (bend + half, y + DEEP))]
    return boxes


def city(seed, count, first):
    """CSV rows of boxes, CSV rows of queries, and the width of each street."""
    rng = random.Random(seed)
    boxes, queries, widths = [], [], {}
    for i in range(first + count):
        width, aside = street(rng)
        if i < first:
            continue
        x, y = WIDE * (i % 32), DEEP * (i // 32)
        for low, high in houses(x, y, width, aside):
            boxes.append((*low, 0, *high, HIGH, "house"))
        queries.append((f"s{i}", x + 3, y + DEEP / 2, 4, x + WIDE - 3, y + DEEP / 2, 4))
        widths[f"s{i}"] = width
    return boxes, queries, widths


def write(path, header, rows):
    path.write_text(header + "\n" + "".join(",".join(map(str, row)) + "\n" for row in rows))


def run(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(map(str, words))}\n{done.stderr}")
    return done


def records(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def cpu():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bin_dir", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--vehicle", default="quad2kg")
    parser.add_argument("--guess", type=float, nargs="+", default=[1.0, 0.5, 0.2])
    parser.add_argument("--begin", type=float, default=0.02, help="m of the path that the search for a tube begins with")
    parser.add_argument("--limits", default="--vmax 5 --amax 5")
    parser.add_argument("--ranges", default="--wind 1,0,0 --wind-spread 0.2 --gust-most 0.5 --mass-error 0.005")
    parser.add_argument("--save", type=pathlib.Path, help="a folder for the files")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as made:
        measure(asked, asked.save or pathlib.Path(made))


def measure(asked, folder):
    tool = lambda name: asked.bin_dir / f"skyway-{name}"
    folder.mkdir(exist_ok=True)
    boxes, queries, widths = city(asked.seed, asked.count, asked.first)
    write(folder / "boxes.csv", "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label", boxes)
    write(folder / "queries.csv", "id,from_x,from_y,from_z,to_x,to_y,to_z", queries)
    streets = folder / "streets.boxmap"
    run(tool("import"), folder / "boxes.csv", "-q", "-o", streets)
    plan = [tool("plan"), streets, "--queries", folder / "queries.csv", "--vehicle", asked.vehicle, "-q", "-o"]
    print(f"seed {asked.seed}, queries {asked.first} to {asked.first + asked.count - 1}, {asked.vehicle} {asked.limits} {asked.ranges}")
    for guess in asked.guess:
        run(*plan, folder / "guessed.jsonl", "--margin", guess)
        found = [one["id"] for one in records(folder / "guessed.jsonl") if one["status"] == "found"]
        narrowest = f", the narrowest {min(widths[i] for i in found):.3f} m" if found else ""
        print(f"a path with a margin of {guess} m: {len(found)}{narrowest}")
    run(*plan, folder / "paths.jsonl", "--margin", asked.begin)
    found = [one for one in records(folder / "paths.jsonl") if one["status"] == "found"]
    narrowest = f", the narrowest {min(widths[one['id']] for one in found):.3f} m" if found else ""
    print(f"a path with the margin to begin with, {asked.begin} m: {len(found)}{narrowest}")
    before = cpu()
    tubes = run(tool("traj"), streets, folder / "paths.jsonl", "--vehicle", asked.vehicle, *asked.limits.split(), "--controller", "geometric",
                "--proved-tube", *asked.ranges.split(), "--hover-time", 0.2, "--settle", 0.2, "--report-file", folder / "tubes.jsonl",
                "-o", folder / "trajectories.jsonl")
    seconds = cpu() - before
    solved = [one for one in records(folder / "trajectories.jsonl") if one["status"] == "solved"]
    (folder / "solved.jsonl").write_text("".join(json.dumps(one) + "\n" for one in solved))
    radius = sorted(one["proved_tube"]["largest"] for one in records(folder / "tubes.jsonl") if one["ok"])
    words = f", the narrowest {min(widths[one['id']] for one in solved):.3f} m; radius {radius[len(radius) // 2]:.4f} m in the median, {radius[-1]:.4f} m at most" if solved else ""
    print(f"a trajectory whose own proved tube is clear: {len(solved)}{words}; {seconds:.0f} s of CPU")
    print("\n".join(tubes.stderr.splitlines()[-3:]))
    checked = run(tool("check"), streets, folder / "solved.jsonl", "--tube", folder / "tubes.jsonl", "--vehicle", asked.vehicle, "-q")
    ok = sum(json.loads(line)["ok"] for line in checked.stdout.splitlines())
    print(f"of these accepted by skyway-check --tube: {ok}")


if __name__ == "__main__":
    main()
