"""make.py BIN_DIR [--check]: makes the README's pictures anew from the demo (tools/demo.sh); the page's needs chromium.

With --check it makes none, and fails where they are not those of the demo as it is now: demo.svg byte for byte, view.png by what
can be read in it, which view.json keeps.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BIN = pathlib.Path(sys.argv[1]).resolve()
CHECK = "--check" in sys.argv


def facts(page):
    """What a reader sees as numbers in the picture of the page."""
    meta = json.loads(re.search(r'<script id="skyway-meta"[^>]*>(.*?)</script>', page, re.S).group(1))
    motion = meta["motions"][0]
    return {"boxes": meta["map"]["boxes"], "tree": meta["trees"][0]["nodes"], "path_m": round(meta["paths"][0]["length"], 1),
            "duration_s": round(motion["duration"], 2), "segments": motion["segments"], "rung": motion["rung"],
            "checks": [check["ok"] for check in meta["reports"]]}


def make_page_without_frames(demo, page):
    files = [demo / name for name in ("city.boxmap", "city.lattice", "path.jsonl", "tree.jsonl", "trajectory.jsonl", "report.jsonl")]
    subprocess.run([BIN / "skyway-view", "-q", *files, "--title", "Skyway demo", "-o", page], check=True)


def photograph(page, picture):
    sys.path.insert(0, str(ROOT / "tests/tools/view"))
    from viewer import Viewer
    from webdriver import Browser
    with Browser() as browser:
        viewer = Viewer(browser, page, "light", (1280, 760))
        browser.run("const s = [...document.querySelectorAll('#layers select')].find(e => [...e.options].some(o => o.value === "
                    "'clearance')); s.value = 'clearance'; s.dispatchEvent(new Event('change'))")
        browser.pointer(("move", *browser.centre("#scrub", 0.5)), ("down",), ("up",))
        browser.run("dispatchEvent(new Event('resize'))")
        frames = viewer.get("frames")
        viewer.until(f"skyway.frames > {frames}")
        browser.screenshot(picture)


with tempfile.TemporaryDirectory() as name:
    demo = pathlib.Path(name)
    subprocess.run(["bash", ROOT / "tools/demo.sh", BIN, demo], check=True, stdout=subprocess.DEVNULL)
    page = demo / "page.html"
    make_page_without_frames(demo, page)
    plan, now = (demo / "plan.svg").read_bytes(), facts(page.read_text())
    if CHECK:
        kept = json.loads((HERE / "view.json").read_text())
        stale = [f"view.png shows {key} {kept.get(key)}, the demo has {value}" for key, value in now.items() if kept.get(key) != value]
        if plan != (HERE / "demo.svg").read_bytes():
            stale.append("demo.svg is not the demo's plan")
        if stale:
            sys.exit("\n".join([*stale, f"make the pictures anew: python3 docs/images/make.py {sys.argv[1]}"]))
    else:
        (HERE / "demo.svg").write_bytes(plan)
        photograph(page, HERE / "view.png")
        (HERE / "view.json").write_text(json.dumps(now) + "\n")
