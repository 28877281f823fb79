"""skyway-view's page, as tests and measurements drive it."""

import os


class Viewer:
    """A page in the browser, and what its window.skyway says."""

    pictures = None  # the folder in which they are left

    def __init__(self, browser, page, scheme="light", size=(1440, 900)):
        self.browser = browser
        browser.prefer(scheme)
        browser.resize(*size)
        browser.open(page)
        browser.until("window.skyway && skyway.frames > 0")
        assert self.get("theme") == scheme

    def get(self, name):
        return self.browser.run(f"return skyway.{name}")

    def until(self, condition, seconds=180):
        self.browser.until(condition, seconds)

    def picture(self, name):
        if self.pictures:
            self.pictures.mkdir(parents=True, exist_ok=True)
            frames = self.get("frames")
            self.browser.run("dispatchEvent(new Event('resize'))")
            self.browser.screenshot(self.pictures / f"{name}.png")
            assert self.get("frames") >= frames
        self.quiet()

    def quiet(self):
        assert self.get("problems") == [], self.get("problems")
        said = self.browser.console()
        assert not said, said

    def frame_time(self):
        """Milliseconds a frame takes while the view turns, the pixels read back."""
        return self.browser.run("""
          return (async () => {
            const view = document.getElementById("view"), gl = view.querySelector("canvas").getContext("webgl");
            const frame = () => new Promise(requestAnimationFrame), pixel = new Uint8Array(4);
            await frame();
            const begin = performance.now();
            let turns = 0;
            for (; turns < 3 || (turns < 30 && performance.now() < begin + 4000); ++turns) {
              view.dispatchEvent(new KeyboardEvent("keydown", {key: "ArrowLeft", bubbles: true}));
              await frame();
              gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            }
            return (performance.now() - begin) / turns;
          })()""")

    def figures(self, name):
        print(f"{name}: {self.get('boxes')} boxes, {self.get('drawCalls')} draw calls, {self.get('triangles')} triangles")
        if os.environ.get("SKYWAY_TIME_FRAMES"):
            print(f"{name}: {self.frame_time():.1f} ms a frame in software")
