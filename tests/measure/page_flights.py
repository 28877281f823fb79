"""page_flights.py PAGE.html [PICTURE.png]: how a page of many flights opens and plays, in headless Chromium.

Pixels are drawn in software, so they take longer than on any graphics card; what the page's own script takes a frame is
told apart. The picture is of the middle of the hour.
"""

import pathlib
import statistics
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tools" / "view"))
from viewer import Viewer
from webdriver import Browser

PLAYED = """
  return (async () => {
    const frame = () => new Promise(requestAnimationFrame), out = [];
    const end = performance.now() + 10000;
    while (out.length < 60 && performance.now() < end) {
      const drawn = skyway.frames;
      await frame();
      if (skyway.frames > drawn) out.push([performance.now(), skyway.frameMs, skyway.fleet.airborne]);
    }
    return out;
  })()"""

page = pathlib.Path(sys.argv[1]).resolve()
with Browser() as browser:
    began = time.monotonic()
    viewer = Viewer(browser, page)
    print(f"{page.stat().st_size / 1e6:.1f} MB, opened and drawn after {time.monotonic() - began:.1f} s")
    viewer.figures(f"{viewer.get('fleet')['flights']} flights")
    print(f"{viewer.frame_time():.0f} ms a frame with its pixels while the view turns")
    browser.pointer(("move", *browser.centre("#scrub", 0.5)), ("down",), ("up",))
    browser.click("#play")
    viewer.until("skyway.playing")
    frames = browser.run(PLAYED)
    apart = [(b[0] - a[0]) for a, b in zip(frames, frames[1:])]
    print(f"playing, {max(f[2] for f in frames)} in the air at once: {statistics.median(apart):.0f} ms from frame to frame, "
          f"{statistics.median(f[1] for f in frames):.1f} ms of it the page's script (most {max(f[1] for f in frames):.1f})")
    browser.click("#play")
    if len(sys.argv) > 2:
        browser.screenshot(sys.argv[2])
    viewer.quiet()
