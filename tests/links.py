"""links.py SOURCE_DIR: every link of a page to a file of the project leads somewhere, and to a heading that is there."""

import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1]).resolve()
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```$", "", text, flags=re.S | re.M))


def anchors(page):
    """As GitHub makes them of headings."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.S | re.M)
    headings = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def faults(page):
    for target in LINK.findall(without_code(page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        to = (page.parent / path) if path else page
        if not to.exists():
            yield f"{page.relative_to(source)}: no {target}"
        elif anchor and anchor not in anchors(to):
            yield f"{page.relative_to(source)}: {target}: no such heading"


tops = [page for page in source.glob("*.md")]
rooms = [page for folder in ("data", "docs", "libgeom", "libplan", "libtraj", "packaging", "tests", "tools")
         for page in sorted((source / folder).rglob("*.md"))]
found = [fault for page in tops + rooms for fault in faults(page)]
print("\n".join(found) or f"the links of {len(tops + rooms)} pages")
sys.exit(bool(found))
