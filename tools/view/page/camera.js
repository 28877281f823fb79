// Ways to look: free, from above, beside the vehicle, along with it, and between two vehicles.

const cameraModes = [["free", "Free", "turn, move and zoom freely (1)"], ["top", "Top", "from above, north up (2)"],
  ["follow", "Follow", "keeps the vehicle in the middle (3)"], ["ride", "Ride", "flies along behind it (4)"],
  ["pair", "Pair", "keeps both vehicles of a pair in the middle (5)"]];
const cameraFollows = mode => mode === "follow" || mode === "ride" || mode === "pair";

const usualPitch = 0.62;

class View {
  constructor() {
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1e5);
    this.orbit = new Orbit();
    this.mode = "free";
    this.home();
  }

  extent() {
    const [w, d, h] = [0, 1, 2].map(k => meta.max[k] - meta.min[k]);
    return { w, d, h, across: Math.max(Math.hypot(w, d), h, 5) };
  }

  home() {
    const { h, across } = this.extent();
    this.orbit.target.set((meta.min[0] + meta.max[0]) / 2 - origin[0], (meta.min[1] + meta.max[1]) / 2 - origin[1],
      meta.min[2] - origin[2] + Math.min(h / 4, across / 10));
    this.orbit.heading = -0.45;
    this.orbit.elevation = usualPitch;
    const box = byId("view").getBoundingClientRect();
    const free = box.width - this.covered(box.width);
    const narrow = free > 0 ? Math.max(1, box.height / free) : 1;
    this.orbit.distance = (across * 1.02 + 0.6 * h) * narrow;
  }

  // `sight`: the motion to follow, the time, and what tells whether it is hidden from a place.
  set(mode, sight) {
    const followed = cameraFollows(this.mode);
    if ((mode === "free" || mode === "top") && followed) this.home();
    if (mode === "top") {
      this.orbit.heading = 0;
      this.orbit.elevation = tallest;
    } else if (this.mode === "top") this.orbit.elevation = usualPitch;
    if (mode === "follow" && this.mode !== "follow") this.lookAfter(sight);
    if (mode === "ride") {
      this.orbit.distance = Math.min(followed ? this.orbit.distance : 30, 16);
      this.orbit.elevation = 0.28;
    }
    if (mode === "pair") this.lookBetween(sight);
    this.mode = mode;
  }

  // From where both of the pair are seen well.
  lookBetween({ pair, time }) {
    const [a, b] = pair.of.map(i => motions[i].place(time));
    const size = Math.max(...pair.of.map(i => (motions[i].data.vehicle || { half: [0.25] }).half[0]));
    this.orbit.distance = Math.min(Math.max(6 * a.distanceTo(b), 8 * size, 0.5), this.extent().across);
    this.orbit.elevation = 0.45;
    if (Math.hypot(b.x - a.x, b.y - a.y) > 0.01) this.orbit.heading = -Math.atan2(b.y - a.y, b.x - a.x);  // across the line
  }

  // From behind the vehicle and above it, or the nearest such place that it is not hidden from.
  lookAfter({ motion, time, hidden }) {
    const { orbit } = this;
    orbit.distance = Math.min(this.extent().across / 6, 90);
    orbit.elevation = usualPitch;
    if (!motion) return;
    const t = motion.local(time), east = motion.heading(t, 1.2);
    const behind = east === null ? orbit.heading : Math.PI / 2 - east;
    motion.place(time, orbit.target);
    for (const steeper of [0, 0.2, 0.4]) {
      for (const turn of [0.5, -0.5, 0, 1, -1, 1.6, -1.6, 2.3, -2.3, Math.PI]) {
        orbit.heading = behind + turn;
        orbit.elevation = usualPitch + steeper;
        orbit.place(this.camera);
        if (!hidden(this.camera.position, orbit.target)) return;
      }
    }
    orbit.heading = behind + 0.5;
    orbit.elevation = usualPitch + 0.2;
  }

  // Where the motion is at the time, for the modes that go with it.
  track(motion, time, pair) {
    if (this.mode === "pair" && pair) {
      const [a, b] = pair.of.map(i => motions[i].place(time));
      this.orbit.target.copy(a).lerp(b, 0.5);
      return;
    }
    if (!motion || !cameraFollows(this.mode)) return;
    motion.place(time, this.orbit.target);
    if (this.mode !== "ride") return;
    const east = motion.heading(motion.local(time), 1.2);
    if (east !== null) this.orbit.heading = Math.PI / 2 - east;
  }

  // How much of the view, one metre away, a pixel is.
  perPixel(height) { return 2 * Math.tan(this.camera.fov * Math.PI / 360) / height; }

  // Pixels at the left that the card of the layers hides, where it leaves enough.
  covered(width) {
    const card = byId("layers").offsetWidth;
    return card < width / 3 ? card : 0;
  }

  apply(width, height) {
    const { camera, orbit } = this;
    camera.aspect = width / height;
    camera.near = Math.max(orbit.distance * 0.02, 0.02);
    camera.far = orbit.distance + this.extent().across * 6 + 100;
    // The middle of the picture is that of what the card leaves.
    camera.setViewOffset(width, height, -this.covered(width) / 2, 0, width, height);
    camera.updateProjectionMatrix();
    orbit.place(camera);
    camera.updateMatrixWorld();
  }
}
