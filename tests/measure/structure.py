"""structure.py [TREE] [-v]: figures of how the sources and pages of a checkout are laid out, of its tracked files.

It reads text, so that it gives the same figures of every checkout, old or new. -v lists what it counted.
"""

import collections
import pathlib
import re
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import layers

TREE = pathlib.Path(next((name for name in sys.argv[1:] if name != "-v"), "."))
LIMITS = {
    "vmax": ("vmax", "speed"), "vmax_h": ("vmax_h", "horizontal_speed"), "vmax_v": ("vmax_v", "vertical_speed"),
    "amax": ("amax", "acceleration"), "jmax": ("jmax", "jerk"), "tilt": ("tilt",), "thrust": ("thrust",),
    "body_rate": ("body_rate",), "yaw_rate": ("yaw_rate",),
}
STATES = r"(?:status|reason|rung|route|method|step)"
# A format's word beside a text: `format == "wpl"`, `"wpl" != source.format`; and `word == "ply"`, where the text is a
# format's word, as other comparisons or a table of formats show.
FORMAT_WORD = re.compile(r'\b(?P<name>format|word)\b(?:\(\))?\s*[!=]=\s*"(?P<text>[^"]+)"|'
                         r'"(?P<before>[^"]+)"\s*[!=]=\s*(?:\w+(?:\.|->))*(?P<after>format|word)\b')
OTHER_FORMATS = ("euler_rpy", "quat_xyzw")  # values of an attribute of SDFormat that is called a format
# A place that makes a format a value, with its word: such a file is part of the table.
FORMAT_TABLE = re.compile(r"\bconstexpr (?:geom::)?Format \w+")
# An error's text that is searched, compared or cut: of what(), or of a parameter or variable named message.
SEARCHED = r"(?:starts_with|ends_with|r?find\w*|contains|substr|compare)\("
ERROR_READ = re.compile(rf"(?:what\(\)\)?|\bmessage)\.{SEARCHED}|(?:what\(\)\)?|\bmessage) == |"
                        rf"\bregex_\w+\([^;]*?(?:what\(\)|\bmessage\b)|\bInputError\((?:\w+\.)+substr\(")
EXAMPLE = re.compile(r"^// Example\b.*:$|^ *//   +[^\n]*;$", re.M)


def tracked():
    names = subprocess.run(["git", "-C", TREE, "ls-files", "libgeom", "libplan", "libtraj", "tools", "tests"],
                           check=True, capture_output=True, text=True).stdout.split()
    return [pathlib.Path(name) for name in names if name.endswith((".h", ".cpp")) and "corpus" not in name]


def pages(folder):
    """Of each manual page of a tool the words before its section OPTIONS."""
    for page in sorted((TREE / folder).glob("*.1.md")):
        text = re.sub(r"^%[^\n]*\n", "", page.read_text())
        if found := re.search(r"^#+ OPTIONS\b", text, re.M):
            yield page.name.removesuffix(".1.md"), len(text[:found.start()].split())


def count_lines(texts):
    return sum(text.count("\n") for text in texts)


def format_words(texts):
    """A test of a found FORMAT_WORD: whether its text is a format's word."""
    words = {word for text in texts for word in re.findall(r'\.word = "([^"]+)"', text)}
    words |= {found["text"] for text in texts for found in FORMAT_WORD.finditer(text) if found["name"] == "format"}
    words -= {*OTHER_FORMATS, "auto"}
    return lambda found: (found["text"] or found["before"]) not in OTHER_FORMATS and (
        "format" in (found["name"], found["after"]) or (found["text"] or found["before"]) in words)


def counted(name, pattern, texts, counts=lambda found: True):
    """Prints how often the pattern is in how many of the texts."""
    places = [(file, text.count("\n", 0, found.start()) + 1, found.group(0))
              for file, text in texts.items() for found in pattern.finditer(text) if counts(found)]
    print(f"{name}: {len(places)} in {len({file for file, _, _ in places})} files")
    if "-v" in sys.argv:
        print("".join(f"  {file}:{line}: {found!r}\n" for file, line, found in places), end="")


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
    shown = [file for file in public if EXAMPLE.search(texts[file])]
    reasons = [file for file in public if "\n// No example: " in texts[file]]
    print(f"public headers: {len(public)}; with an example: {len(shown)}, with a reason for none: {len(reasons)}")
    parts = {name: count_lines(texts[file] for file in files if file.parts[0] == name)
             for name in ("libgeom", "libplan", "libtraj", "tools", "tests")}
    print(f"lines: {', '.join(f'{name} {lines}' for name, lines in parts.items())}; "
          f"product {sum(parts.values()) - parts['tests']}, all {sum(parts.values())}")
    words = dict(pages("docs/man"))
    most = max(words, key=words.get)
    print(f"words before OPTIONS of {len(words)} manual pages: median {statistics.median(words.values()):g}, "
          f"most {words[most]} ({most})")
    print(f"lines of benchmarks.md: {count_lines([(TREE / 'docs/benchmarks.md').read_text()])}")
    code = {file: re.sub(r"(?m)^ *//.*", "", texts[file]) for file in product}
    counted("comparisons with a format's word outside the table", FORMAT_WORD,
            {file: text for file, text in code.items() if not FORMAT_TABLE.search(text)}, format_words(code.values()))
    counted("reads of an error's text", ERROR_READ, code)

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
