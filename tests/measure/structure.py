"""structure.py [TREE]: figures of how the sources are laid out, of the tracked files of a checkout."""

import collections
import pathlib
import re
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import layers

TREE = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
LIMITS = {
    "vmax": ("vmax", "speed"), "vmax_h": ("vmax_h", "horizontal_speed"), "vmax_v": ("vmax_v", "vertical_speed"),
    "amax": ("amax", "acceleration"), "jmax": ("jmax", "jerk"), "tilt": ("tilt",), "thrust": ("thrust",),
    "body_rate": ("body_rate",), "yaw_rate": ("yaw_rate",),
}
STATES = r"(?:status|reason|rung|route|method|step)"


def tracked():
    names = subprocess.run(["git", "-C", TREE, "ls-files", "libgeom", "libplan", "libtraj", "tools", "tests"],
                           check=True, capture_output=True, text=True).stdout.split()
    return [pathlib.Path(name) for name in names if name.endswith((".h", ".cpp")) and "corpus" not in name]


def plain(text):
    """Without comments; strings and characters stay, but for what is in them."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
    return token.sub(lambda m: '""' if m.group(0)[0] in "\"R" else "0" if m.group(0)[0] == "'" else " ", text)


def matching(text, at, opening, closing):
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == opening) - (text[i] == closing)
        if depth == 0:
            return i
    return len(text)


def functions(text):
    """(name, parameters, lines) of what looks like a function's definition."""
    for found in re.finditer(r"^(?:[A-Za-z_][\w:<>,*&\s\[\]]*?[\s*&])?([A-Za-z_~][\w:~]*)\(", text, re.M):
        if found.group(1) in ("if", "for", "while", "switch", "return", "catch", "static_assert"):
            continue
        end = matching(text, found.end() - 1, "(", ")")
        body = re.match(r"\)\s*(?:const|noexcept|override|final|\s)*(?:->[^{;]+)?(?::[^;{]*)?\{", text[end:end + 400])
        if not body:
            continue
        parameters = text[found.end():end]
        while True:  # commas within templates and calls are no separators
            inner = re.sub(r"<[^<>]*>|\([^()]*\)|\{[^{}]*\}", "", parameters)
            if inner == parameters:
                break
            parameters = inner
        count = parameters.count(",") + 1 if parameters.strip() else 0
        opened = end + body.end() - 1
        last = matching(text, opened, "{", "}")
        yield found.group(1), count, text.count("\n", found.start(), last) + 1


def main():
    files = tracked()
    texts = {file: (TREE / file).read_text() for file in files}
    product = [file for file in files if file.parts[0] != "tests"]

    folders = collections.Counter(file.parent for file in files)
    largest = folders.most_common(3)
    print(f"folders with sources: {len(folders)}; files in one: median {statistics.median(folders.values()):g}, "
          f"largest {', '.join(f'{count} ({folder})' for folder, count in largest)}")

    rooms = layers.uses(layers.sources(TREE))
    cycles = layers.cycles(rooms)
    public = [file for file in files if file.parts[1] == "include"]
    print(f"cycles of rooms: {len(cycles)}, which hold {sum(map(len, cycles))} of {len(rooms)} rooms")
    print(f"public headers: {len(public)}; lines of product: {sum(texts[file].count(chr(10)) for file in product)}, "
          f"of tests: {sum(texts[file].count(chr(10)) for file in files if file.parts[0] == 'tests')}")

    climbing = sum(len(re.findall(r'#include "\.\./', text)) for text in texts.values())
    print(f"includes that climb (\"../\"): {climbing}")

    compared = {file: len(re.findall(rf'\b{STATES}(?:\(\))?\s*[!=]=\s*"', texts[file])) for file in product}
    print(f"comparisons of a state with a string: {sum(compared.values())} in {sum(map(bool, compared.values()))} files")

    for limit, names in LIMITS.items():
        word = re.compile(rf"\b(?:{'|'.join(names)})\b")
        places = {file: len(word.findall(re.sub(r"//[^\n]*", "", texts[file]))) for file in product}
        print(f"limit {limit}: {sum(places.values())} places in {sum(map(bool, places.values()))} files")

    mains, wide, count = [], [], 0
    for file in product:
        for name, parameters, lines in functions(plain(texts[file])):
            count += 1
            if name == "main":
                mains.append(lines)
            if parameters >= 5:
                wide.append(f"{file}: {name}({parameters})")
    print(f"main: {len(mains)}; lines: median {statistics.median(mains):g}, most {max(mains)}, sum {sum(mains)}")
    print(f"functions with five and more parameters: {len(wide)} of {count}")
    if "-v" in sys.argv:
        print("\n".join(wide))


main()
