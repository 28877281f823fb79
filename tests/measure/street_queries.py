"""Street-level queries all over a map, for measurements."""

import json
import math
import random
import subprocess

VEHICLE = ["--vehicle", "box:1,1,1"]


def info(bin_dir, map_file):
    """Boxes, and the bounds' corners."""
    lines = subprocess.run([bin_dir / "skyway-info", map_file], check=True, capture_output=True, text=True).stdout
    fields = dict(line.split(": ", 1) for line in lines.splitlines() if ": " in line)
    return int(fields["boxes"]), json.loads(fields["bounds_min_m"]), json.loads(fields["bounds_max_m"])


def blocked(bin_dir, map_file, low, high, length, count, tries):
    """At most `count` pairs of free ends under 20 m, so many metres apart, that do not see each other; of `tries`."""
    random.seed(7)
    pairs = []
    for _ in range(tries):
        a = [random.uniform(low[k] + length + 2, high[k] - length - 2) for k in range(2)] + [random.uniform(2, 20)]
        turn = random.uniform(0, 2 * math.pi)
        pairs.append((a, [a[0] + length * math.cos(turn), a[1] + length * math.sin(turn), random.uniform(2, 20)]))
    lines = [json.dumps(q) for a, b in pairs for q in ({"segment": [a, b]}, {"point": a}, {"point": b})]
    answers = subprocess.run([bin_dir / "skyway-query", map_file, *VEHICLE], input="\n".join(lines), check=True,
                             capture_output=True, text=True).stdout
    hit = [json.loads(line)["hit"] for line in answers.splitlines()]
    return [pair for i, pair in enumerate(pairs) if hit[3 * i:3 * i + 3] == [True, False, False]][:count]
