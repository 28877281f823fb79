"""headers.py SOURCE_DIR: what each public header begins with, and whether docs/library.md lists it.
headers.py write UNIT NAME HEADER …: a unit that compiles the examples of the headers; run_NAME runs them.
headers.py alone SOURCE_DIR COMPILER FLAG …: whether each public header includes all that it needs. A header that a
source includes first is compiled there; the others are compiled here.

A header begins with a comment whose first line is a sentence that would make sense in a list of headers. Below it stands
a line "// Example:", under which the code is indented by two blanks more, or a line "// No example:" with the reason.
"// Example, not run:" is compiled only, because it reads a file that is not there or takes long. The names of
given.h (map, scene, path, …) stand for objects that a reader has already.
"""

import pathlib
import re
import subprocess
import sys

LIBRARIES = ("geom", "plan", "traj")
BEGINNING = re.compile(r"#pragma once\n\n((?://.*\n)+)")
MARK = re.compile(r"^// (Example|Example, not run|No example):(.*)\n((?://   .*\n)*)", re.M)
MOST_LINES = 10


def public(folder):
    """The text of each public header, by its path below the source's folder."""
    return {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
            for library in LIBRARIES for path in sorted((folder / f"lib{library}/include").rglob("*.h"))}


def example(text):
    """(kind, code, line of the code) of a header's example; the reason in place of the code where there is none."""
    found = MARK.search(text)
    if not found:
        return None
    if found.group(1) == "No example":
        return found.group(1), found.group(2).strip(), 0
    return found.group(1), re.sub(r"^//   ", "", found.group(3), flags=re.M), text.count("\n", 0, found.start(3)) + 1


def faults(path, text):
    """What is wrong with the beginning or the example of a header, a line each."""
    beginning = BEGINNING.match(text)
    if not beginning:
        yield f"{path}: expected a comment below #pragma once"
        return
    lines = beginning.group(1).splitlines()
    if not re.fullmatch(r"// [A-Z`.0-9].*[.:]", lines[0]) or len(lines) > 1 and lines[1] != "//":
        yield f"{path}: expected a first comment that is one sentence on one line, found {lines[0]!r}"
    if len(MARK.findall(text)) != 1:
        yield f"{path}: expected one \"// Example:\" or \"// No example:\" with the reason, found {len(MARK.findall(text))}"
        return
    kind, code, _ = example(text)
    if not code:
        yield f"{path}: expected {'a reason' if kind == 'No example' else 'code'} after \"{kind}:\""
    if code.count("\n") > MOST_LINES:
        yield f"{path}: expected an example of at most {MOST_LINES} lines, found {code.count(chr(10))}"


def unlisted(headers, page):
    """Headers that the page's table has not, or twice, and rows' names that are none, a line each."""
    named = []
    for room, names in re.findall(r"^\| ((?:geom|plan|traj)/\w+) \|(.*)", page, re.M):
        named += [f"{room}/{name}" for name in re.findall(r"`([\w/]+\.h)`", names)]
    there = [path.split("/include/")[1] for path in headers]
    for header in sorted(set(there) - set(named)):
        yield f"docs/library.md: {header} is not in the list of headers"
    for header in sorted(set(named) - set(there)):
        yield f"docs/library.md: {header} is no public header"
    for header in sorted({name for name in named if named.count(name) > 1}):
        yield f"docs/library.md: {header} is listed twice"


GOOD = """#pragma once

// Counts of sheep.
//
// Example:
//   geom::Flock flock;
//   flock.add(2);
// More.

#include <cstddef>
"""


def self_test():
    """What of this file does not do what it says."""
    def found(text, expected):
        told = list(faults("sheep.h", text))
        if len(told) != 1 or expected not in told[0]:
            yield f"a fault {expected!r} was expected, found {told}"

    if list(faults("sheep.h", GOOD)) or example(GOOD) != ("Example", "geom::Flock flock;\nflock.add(2);\n", 6):
        yield f"no fault and two lines of code were expected, found {list(faults('sheep.h', GOOD))}, {example(GOOD)}"
    if list(faults("sheep.h", "#pragma once\n\n// Sheep.\n//\n// No example: an enum.\n")):
        yield "a reason was expected to do"
    yield from found(GOOD.replace("// Counts", "struct"), "a comment below")
    yield from found(GOOD.replace("sheep.\n", "sheep"), "one sentence")
    yield from found(GOOD.replace("sheep.\n//", "sheep.\n// Black ones too."), "one sentence")
    yield from found(GOOD.replace("// Example:", "// So:"), "found 0")
    yield from found(GOOD.replace("// More", "// No example: none"), "found 2")
    yield from found("#pragma once\n\n// Sheep.\n//\n// No example:\n", "a reason")
    yield from found(GOOD.replace("//   flock.add(2);\n", "//   flock.add(2);\n" * 10), "at most")
    headers = {"libgeom/include/geom/shape/aabb.h": GOOD}
    row = "| geom/shape | `aabb.h` | "
    for page, expected in (("", "is not in"), (row + "`box.h` |", "box.h is no"), (row + "`aabb.h` |", "twice")):
        if [expected in line for line in unlisted(headers, page)] != [True]:
            yield f"a fault {expected!r} was expected, found {list(unlisted(headers, page))}"


def write(unit, name, headers):
    """The unit: every example in a function of its own; errors in it name the header's line."""
    included, functions, calls = [], [], []
    for header in headers:
        text = header.read_text(encoding="utf-8")
        kind, code, line = example(text) or ("No example", "", 0)
        if kind == "No example":
            continue
        included += [line for line in code.splitlines() if line.startswith("#include")]
        code = "".join("\n" if line.startswith("#include") else line + "\n" for line in code.splitlines())
        function = "example_" + re.sub(r"\W", "_", str(header).split("/include/")[1].removesuffix(".h"))
        functions.append(f"[[maybe_unused]] void {function}(Given& given) {{\n  {NAMES}\n  {{\n"
                         f"#line {line} \"{header}\"\n{code}  }}\n}}\n")
        if kind == "Example":
            calls.append(f"  {function}(given);\n")
    included += [f"#include \"{str(header).split('/include/')[1]}\"" for header in headers]
    lines = "\n".join(included)
    unit.write_text(f"#undef NDEBUG\n{lines}\n#include \"headers/given.h\"\n{QUIET}\n{''.join(functions)}\n"
                    f"void run_{name}(Given& given) {{\n{''.join(calls)}}}\n", encoding="utf-8")


def included_first(folder):
    """The headers that a source of the repository includes before all others."""
    sources = [path for room in (*(f"lib{library}" for library in LIBRARIES), "tests", "tools")
               for path in (folder / room).rglob("*.cpp")]
    firsts = (re.search(r"^#include [<\"](.+)[>\"]", path.read_text(encoding="utf-8"), re.M) for path in sources)
    return {first.group(1) for first in firsts if first}


def incomplete(folder, compiler):
    """What the compiler says of each header that stands first in no source and cannot stand alone."""
    names = {path.split("/include/")[1] for path in public(folder)}
    if not names & included_first(folder):
        yield f"{folder}: no source was found that includes a public header first"
    for name in sorted(names - included_first(folder)):
        told = subprocess.run([*compiler, "-x", "c++", "-fsyntax-only", "-"], input=f'#include "{name}"\n', text=True, capture_output=True, check=False)
        if told.returncode:
            yield f"{name} does not compile alone:\n{told.stderr}"


NAMES = "auto& [map, vehicle, limits, scene, path, trajectory] = given;"
QUIET = "\n".join(f'#pragma GCC diagnostic ignored "-W{name}"' for name in ("unused-variable", "unused-but-set-variable", "unused-parameter", "shadow"))


def main():
    if sys.argv[1] == "write":
        write(pathlib.Path(sys.argv[2]), sys.argv[3], [pathlib.Path(name) for name in sys.argv[4:]])
        return
    if sys.argv[1] == "alone":
        found = list(incomplete(pathlib.Path(sys.argv[2]), sys.argv[3:]))
        print(*found, sep="\n")
        sys.exit(bool(found))
    folder = pathlib.Path(sys.argv[1])
    headers = public(folder)
    found = list(self_test()) + [fault for path, text in headers.items() for fault in faults(path, text)]
    found += unlisted(headers, (folder / "docs/library.md").read_text(encoding="utf-8"))
    if not headers:
        found.append(f"{folder}: no public header was found")
    for line in found:
        print(line)
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
