// What the camera saw at the time: pictures of skyway-render along one of the motions.

class FrameView {
  constructor(data) {
    this.motion = data.motion;
    this.time = arrayOf(data.time);
    this.ends = arrayOf(data.end);
    this.webp = arrayOf(data.webp);
    this.urls = new Array(this.time.length);
    this.index = null;
    this.image = element("img", { width: data.width, height: data.height });
    this.caption = element("figcaption", { class: "soft" });
    this.element = element("figure", { class: "frame" }, this.image, this.caption);
  }

  url(index) {
    if (!this.urls[index]) {
      const bytes = this.webp.subarray(index ? this.ends[index - 1] : 0, this.ends[index]);
      this.urls[index] = URL.createObjectURL(new Blob([bytes], { type: "image/webp" }));
    }
    return this.urls[index];
  }

  // The last frame up to the time, or the first where there is none yet.
  at(time) {
    let low = 0, high = this.time.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.time[middle] <= time) low = middle; else high = middle - 1;
    }
    return low;
  }

  show(motion, time) {
    this.element.hidden = motion !== this.motion;
    const index = this.at(time);
    if (this.element.hidden || index === this.index) return;
    this.index = index;
    const words = `Camera at ${withUnit(this.time[index], 2, "s")}`;
    this.image.src = this.url(index);
    this.image.alt = words;
    this.caption.textContent = words;
  }
}
