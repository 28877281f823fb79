"""slips_page.py PAGE: the table in PAGE is what slips.txt says; UPDATE_GOLDEN=1 rewrites it.

Each case of slips.txt is a row: the slip, the command, and what is said on stderr. Behind the first heading that
begins with "## " the page is made; what stands above it is written by hand.
"""

import os
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # nothing is written beside the sources
import transcript

HERE = pathlib.Path(__file__).resolve().parent
LEAST = 100
# How libraries speak.
FOREIGN = re.compile(r"json\.exception|CLI::|terminate called|std::|GDAL|ERROR [0-9]|Could not convert|not in range")
HINT = re.compile(r"^Try '.*'\.\n", re.M)


def cell(text, code=False):
    text = text.replace("|", "\\|")
    return f"`{text}`" if code else re.sub(r"([<>*_`\[\]])", r"\\\1", text)


def rows(cases):
    """By group, the rows of the table."""
    groups = {}
    for title, case in cases.items():
        group, colon, slip = title.partition(": ")
        if not colon:
            sys.exit(f'{case.place}: a title is "group: slip"')
        command = case.commands[-1]
        said = HINT.sub("", command.expected.stderr.decode()).strip()
        if not said or not command.expected.exit:
            sys.exit(f"{case.place}: {title}: a slip is refused with a message")
        if FOREIGN.search(said):
            sys.exit(f"{case.place}: {title}: a library speaks: {said}")
        lines = "<br>".join(cell(line) for line in said.splitlines())
        groups.setdefault(group, []).append(f"| {cell(slip)} | {cell(command.text, True)} | {lines} |")
    return groups


def table(cases):
    lines = []
    for group, found in rows(cases).items():
        lines += [f"## {group[:1].upper()}{group[1:]}", "", "| slip | command | what is said |", "|---|---|---|", *found, ""]
    return "\n".join(lines)


def main():
    page = pathlib.Path(sys.argv[1])
    setups = transcript.read(HERE / "setups.txt").setups
    cases = transcript.read(HERE / "slips.txt", setups).cases
    if len(cases) < LEAST:
        sys.exit(f"slips.txt has {len(cases)} cases, fewer than {LEAST}")
    text = page.read_text(encoding="utf-8")
    begin = text.find("\n## ") + 1
    made = text[:begin or len(text)] + table(cases)
    if os.environ.get("UPDATE_GOLDEN") == "1":
        page.write_text(made, encoding="utf-8", newline="\n")
    elif made != text:
        sys.exit(f"{page.name} is not what slips.txt says: UPDATE_GOLDEN=1 writes it")
    print(f"{len(cases)} slips")


if __name__ == "__main__":
    main()
