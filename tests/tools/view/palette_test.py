"""palette_test.py SOURCE_DIR: colours of the page, of plots and of renders stand out from what is behind them, and can be told apart
by eyes that lack a kind of cone. Contrasts are those of WCAG 2.1 (4.5 for words, 3 for lines and marks)."""

import itertools
import pathlib
import re
import sys

from colour_vision import EYES, contrast, distance

source = pathlib.Path(sys.argv[1])
WORDS, MARKS, APART = 4.5, 3, 25
faults = []


def require(holds, words):
    if not holds:
        faults.append(words)


def stands_out(colour, behind, least, name):
    found = contrast(colour, behind)
    require(found >= least, f"{name}: {colour} on {behind} has a contrast of {found:.2f}, not {least}")


def told_apart(colours, least, name):
    for (i, one), (j, other) in itertools.combinations(enumerate(colours), 2):
        for eye in EYES:
            apart = distance(one, other, eye)
            require(apart >= least, f"{name}: {i} {one} and {j} {other} are {apart:.1f} apart ({eye}), not {least}")


def check_plots():
    """The palette of plots, which is that of ways in renders too: both are drawn on white."""
    text = (source / "libgeom/include/geom/figure/palette.h").read_text()
    palette = re.findall('"(#[0-9a-f]{6})"', re.search(r"kPalette = \{(.*?)\}", text, re.S).group(1))
    require(len(palette) >= 8, f"only {len(palette)} colours")
    told_apart(palette, APART, "plot")
    for colour in palette:
        stands_out(colour, "#ffffff", MARKS, "plot")
    named = dict(re.findall(r'(k\w+) = "(#[0-9a-f]{6})"', text))
    for name in ("kInk", "kWarning", "kLimit"):
        stands_out(named[name], "#ffffff", WORDS, name)
    bands = dict(re.findall(r'(k\w+Fill) = "(#[0-9a-f]{6})"', (source / "libtraj/src/figure/home_band.h").read_text()))
    require(len(bands) == 2, f"bands of ways home: {bands}")
    told_apart([*bands.values(), named["kWarning"]], APART, "bands of ways home")
    for name, colour in bands.items():
        stands_out(colour, "#ffffff", MARKS, name)
    require("figure::colour(" in (source / "libgeom/src/picture/line.cpp").read_text(), "renders have a palette of their own")


def themes():
    """{theme: {name: colour}} of the page."""
    text = (source / "tools/view/page/theme.css").read_text()
    light, dark = re.findall(r"\{([^{}]*--paper: [^{}]*)\}", text)
    of = lambda block: dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6});", block))
    return {"light": of(light), "dark": {**of(light), **of(dark)}}


def check_page():
    for theme, colour in themes().items():
        for word, behind in itertools.product(("ink", "soft", "good", "bad", "accent"), ("panel", "paper")):
            stands_out(colour[word], colour[behind], WORDS, f"{theme} --{word} on --{behind}")
        stands_out(colour["accent-ink"], colour["accent"], WORDS, f"{theme} --accent-ink")
        for mark, behind in itertools.product(("zone", "vehicle", "bad", "good", "planned"), ("sky", "ground")):
            stands_out(colour[mark], colour[behind], MARKS, f"{theme} --{mark} on --{behind}")
        for curve in ("east", "north", "up", "fourth", "limit"):
            stands_out(colour[curve], colour["panel"], MARKS, f"{theme} --{curve} in plots")
        told_apart([colour[f"mission-{i}"] for i in range(8)], 15, f"{theme} missions")
        told_apart([colour["good"], colour["planned"], colour["bad"]], 15, f"{theme} verdicts and planned ways")


check_plots()
check_page()
if faults:
    sys.exit("\n".join(faults))
