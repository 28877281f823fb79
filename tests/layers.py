"""layers.py SOURCE_DIR: each room includes only what lies left of it in the drawing of docs/architecture.md.

The drawing is the block below the heading "Layers". A line names an area (the libraries, one library, tools/cli,
tools, one room such as libtraj/mission) and its rooms in their order, `base <- shape, text <- map`: a room may
include what is left of it in a line of its area, and whatever is left of that. An area may have several lines. A tool
that is not drawn includes tools/cli and the libraries alone. In a room that is an area, and in tools/cli, the name of
the folder stands for the files that lie in no folder below it.
"""

import collections
import pathlib
import re
import sys

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">\n]+)[">]', re.M)
LIBRARIES = ("libgeom", "libplan", "libtraj")


def drawing(text):
    """Of each area a dictionary: for a room the rooms left of it, next to it in some line."""
    block = re.search(r"^## Layers\n.*?^```\w*\n(.*?)^```", text, re.M | re.S)
    areas = {}
    for line in block.group(1).splitlines() if block else []:
        area, _, order = line.strip().partition(" ")
        rooms = areas.setdefault(area, {})
        groups = [[name.strip() for name in group.split(",")] for group in order.split("<-")] if order else []
        for left, group in zip([[]] + groups, groups):
            for room in group:
                rooms.setdefault(room, set()).update(left)
    return areas


def reachable(graph):
    """Of each node all that it leads to, over any number of edges."""
    found = {}
    for start in graph:
        seen, waiting = set(), [start]
        while waiting:
            for node in graph.get(waiting.pop(), ()):
                if node not in seen:
                    seen.add(node)
                    waiting.append(node)
        found[start] = seen
    return found


def cycles(graph):
    """Sets of nodes that lead to one another."""
    to = reachable(graph)
    return {frozenset(other for other in to[node] if node in to.get(other, ())) for node in graph if node in to[node]}


def room_of(path):
    """(area, room) of a file's path below the source's folder; the room is "" where the file lies in none."""
    parts = path.split("/")
    if parts[0] in LIBRARIES:
        below = parts[2:] if parts[1] == "src" else parts[3:]
        return parts[0], below[0] if len(below) > 1 else ""
    if parts[:2] == ["tools", "cli"]:
        return "tools/cli", parts[2] if len(parts) > 3 else "cli"
    return "tools", parts[1] if len(parts) > 2 else ""


def part_of(path, area):
    """The room of a file within a room of a library that is an area; nothing where the file is not in that."""
    library, room = area.split("/")
    if room_of(path) != (library, room):
        return None
    below = path.partition(f"/{room}/")[2].split("/")
    return below[0] if len(below) > 1 else room


def divided(areas):
    """The areas that are rooms of libraries."""
    return [area for area in areas if area.split("/")[0] in LIBRARIES and "/" in area]


def meant(path, include, files):
    """The file that an include of `path` names, or nothing where that is none of ours."""
    folders = [path.rpartition("/")[0], "tools"]
    if path.startswith("lib"):
        folders.append(path.partition("/")[0] + "/src")
    folders += [f"{library}/include" for library in LIBRARIES]
    for folder in folders:
        parts = []
        for part in f"{folder}/{include}".split("/"):
            parts = parts[:-1] if part == ".." else parts + [part]
        if "/".join(parts) in files:
            return "/".join(parts)
    return None


def includes(files):
    """(path, line, include, the path that it names) of every include of another file of ours."""
    for path, text in sorted(files.items()):
        for found in INCLUDE.finditer(text):
            named = meant(path, found.group(1), files)
            if named:
                yield path, text.count("\n", 0, found.start()) + 1, found.group(1), named


def uses(files):
    """Of each room ("libgeom/map") the other rooms whose files it includes."""
    graph = {"/".join(room_of(path)): set() for path in files}
    for path, _, _, named in includes(files):
        if room_of(path) != room_of(named):
            graph["/".join(room_of(path))].add("/".join(room_of(named)))
    return graph


def faults_within(area, files, rooms):
    """What is wrong inside of a room that is an area, a line each."""
    left = reachable(rooms)
    there = {part_of(path, area) for path in files} - {None}
    for part in sorted(there - set(rooms)):
        yield f"{area}: the room {part} is not drawn in docs/architecture.md"
    for part in sorted(set(rooms) - there):
        yield f"docs/architecture.md: {area} has no room {part}"
    for path, line, include, named in includes(files):
        user, used = part_of(path, area), part_of(named, area)
        if user and used and user != used and used not in left.get(user, ()):
            yield (f"{path}:{line}: {user} of {area} may not use {used}, which is not left of it: move what it needs of "
                   f"\"{include}\" to a lower room, or this file to a higher one")


def why_not(user, used, left):
    """Why a file of the room `user` must not include one of the room `used`; nothing where it may."""
    if user == used:
        return None
    (area, room), (other, wanted) = user, used
    home, abroad = ("tools" if name == "tools/cli" else name for name in (area, other))
    if home != abroad:
        return None if abroad in left["libraries"].get(home, ()) else f"{area} may not use {other}"
    if area != other:
        return None if area == "tools" else f"{area} may not use a tool, {wanted}"
    if wanted in left[area].get(room, ()):
        return None
    return f"{room or 'no room'} of {area} may not use {wanted}, which is not left of it"


def faults(files, text):
    """What is wrong with the files or the drawing, a line each."""
    areas = drawing(text)
    for area in ("libraries", *LIBRARIES, "tools/cli", "tools"):
        if area not in areas:
            yield f"docs/architecture.md: the block below \"Layers\" draws no {area}"
            return
    for area in areas:
        for cycle in cycles(areas[area]):
            yield f"docs/architecture.md: the drawing of {area} has a cycle of {', '.join(sorted(cycle))}"
    left = {area: reachable(rooms) for area, rooms in areas.items()}
    there = {room_of(path) for path in files}
    for area, room in sorted(there):
        if area != "tools" and room not in areas[area]:
            yield f"{area}: the room {room or 'of files outside of rooms'} is not drawn in docs/architecture.md"
    for area in (*LIBRARIES, "tools/cli", "tools"):
        for room in sorted(set(areas[area]) - {at[1] for at in there if at[0] == area} - {"cli"}):
            yield f"docs/architecture.md: {area} has no room {room}"
    for area in divided(areas):
        yield from faults_within(area, files, areas[area])
    for path, line, include, named in includes(files):
        fault = why_not(room_of(path), room_of(named), left)
        if fault:
            yield f"{path}:{line}: {fault}: move what it needs of \"{include}\" to a lower room, or this file to a higher one"


DRAWN = """## Layers

```text
libraries  libgeom <- libplan, libtraj <- tools
libgeom    base <- shape, text <- map
libplan    lattice <- planner
libtraj    curve <- mission
libtraj/mission  ulog <- firmware <- mission
tools/cli  file <- option <- cli
tools      cli <- plot <- render
```
"""
TREE = {
    "libgeom/include/geom/base/error.h": "",
    "libgeom/include/geom/shape/aabb.h": '#include "geom/base/error.h"\n',
    "libgeom/include/geom/text/number.h": "",
    "libgeom/src/map/hash.h": '#include <vector>\n#include "geom/shape/aabb.h"\n',
    "libgeom/src/map/hash.cpp": '#include "hash.h"\n#include "geom/base/error.h"\n',
    "libplan/include/plan/lattice/lattice.h": '#include "geom/shape/aabb.h"\n',
    "libplan/src/planner/plan.cpp": '#include "plan/lattice/lattice.h"\n',
    "libtraj/include/traj/curve/yaw.h": '#include "geom/base/error.h"\n',
    "libtraj/include/traj/mission/ulog/log.h": '#include "traj/curve/yaw.h"\n',
    "libtraj/src/mission/firmware/drift.h": '#include "traj/mission/ulog/log.h"\n',
    "libtraj/include/traj/mission/judge.h": '#include "mission/firmware/drift.h"\n',
    "tools/cli/file/files.h": '#include "geom/base/error.h"\n',
    "tools/cli/option/degrees.h": '#include "cli/file/files.h"\n',
    "tools/cli/run.h": '#include "cli/option/degrees.h"\n',
    "tools/plot/svg.h": '#include "cli/run.h"\n',
    "tools/render/canvas.h": '#include "plot/svg.h"\n',
    "tools/synth/main.cpp": '#include "cli/run.h"\n#include "geom/base/error.h"\n',
}


def self_test():
    """What of this file does not do what it says."""
    def found(expected, path="tools/synth/city.h", line="", text=DRAWN):
        told = list(faults(TREE | {path: line}, text))
        if len(told) != 1 or expected not in told[0]:
            yield f"a fault {expected!r} was expected, found {told}"

    if told := list(faults(TREE, DRAWN)):
        yield f"no fault was expected, found {told}"
    # An include that goes upward, or beside.
    yield from found("base of libgeom may not use shape", "libgeom/src/base/a.h", '#include "geom/shape/aabb.h"')
    yield from found("text/a.h:2: text of libgeom may not use shape", "libgeom/src/text/a.h",
                     '\n#include "geom/shape/aabb.h"')
    yield from found("shape of libgeom may not use map", "libgeom/src/shape/a.h", '#include "map/hash.h"')
    yield from found("shape of libgeom may not use map", "libgeom/src/shape/a.cpp", '#include "../map/hash.h"')
    yield from found("file of tools/cli may not use option", "tools/cli/file/a.h", '#include "cli/option/degrees.h"')
    yield from found("option of tools/cli may not use cli", "tools/cli/option/a.h", '#include "cli/run.h"')
    # Of another library or tool.
    yield from found("libgeom may not use libplan", "libgeom/src/map/a.h", '#include "plan/lattice/lattice.h"')
    yield from found("libtraj may not use libplan", "libtraj/src/curve/a.h", "#include <plan/lattice/lattice.h>")
    yield from found("libgeom may not use tools/cli", "libgeom/src/map/a.h", '#include "cli/run.h"')
    yield from found("tools/cli may not use a tool, plot", "tools/cli/a.h", '#include "plot/svg.h"')
    yield from found("plot of tools may not use render", "tools/plot/a.h", '#include "render/canvas.h"')
    yield from found("synth of tools may not use plot", "tools/synth/a.h", '#include "plot/svg.h"')
    # A room that is not drawn, and a drawn one that is not there.
    yield from found("libgeom: the room mesh is not drawn", "libgeom/src/mesh/gltf.h")
    yield from found("tools/cli: the room shard is not drawn", "tools/cli/shard/shard.h")
    yield from found("libgeom: the room of files outside of rooms is not drawn", "libgeom/src/stray.h")
    yield from found("libplan has no room roadmap", text=DRAWN.replace("lattice <-", "lattice, roadmap <-"))
    # Within a room that is an area.
    yield from found("ulog of libtraj/mission may not use firmware", "libtraj/src/mission/ulog/a.h",
                     '#include "mission/firmware/drift.h"')
    yield from found("firmware of libtraj/mission may not use mission", "libtraj/src/mission/firmware/a.h",
                     '#include "traj/mission/judge.h"')
    yield from found("libtraj/mission: the room formats is not drawn", "libtraj/src/mission/formats/a.h")
    yield from found("libtraj/mission has no room formats", text=DRAWN.replace("ulog <- firmware", "ulog, formats <- firmware"))
    yield from found("libtraj/mission has a cycle of firmware, ulog",
                     text=DRAWN.replace("ulog <- firmware", "ulog <- firmware <- ulog"))
    # A drawing with a cycle, in one line or over two, and one of which an area is missing.
    yield from found("libgeom has a cycle of base, map, shape, text",
                     text=DRAWN.replace("text <- map", "text <- map <- base"))
    yield from found("libplan has a cycle of lattice, planner",
                     text=DRAWN.replace("libtraj    curve", "libplan    planner <- lattice\nlibtraj    curve"))
    yield from found("libraries has a cycle of libgeom, libplan, libtraj, tools",
                     text=DRAWN.replace("<- tools", "<- tools <- libgeom"))
    yield from found("draws no libtraj", text=DRAWN.replace("libtraj    curve <- mission\n", ""))
    both = {"libgeom/src/text/a.h": '#include "map/hash.h"', "libgeom/src/map/b.h": '#include "text/a.h"'}
    if cycles(uses(TREE)) or cycles(uses(TREE | both)) != {frozenset(("libgeom/map", "libgeom/text"))}:
        yield "a cycle of rooms was expected where map and text include each other, and none before"


def sources(folder):
    """The text of each header and source of the libraries and tools, by path."""
    paths = [path for top in (*LIBRARIES, "tools") for path in (folder / top).rglob("*")]
    return {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
            for path in paths if path.name.endswith((".h", ".cpp", ".cpp.in"))}


def main():
    folder = pathlib.Path(sys.argv[1])
    files = sources(folder)
    found = list(self_test()) + list(faults(files, (folder / "docs/architecture.md").read_text(encoding="utf-8")))
    if not files:
        found.append(f"{folder}: no source was found")
    for line in found:
        print(line)
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
