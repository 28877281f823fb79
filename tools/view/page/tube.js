// The tube around a trajectory: where the reference point of the simulated vehicle may be, to scale.

const tubeSides = 16, mostTubeRings = 600;

class Tube {
  constructor(motion) {
    this.motion = motion;
    this.data = motion.data.tube;
    this.radius = arrayOf(this.data.radius);
    this.object = new THREE.Mesh(this.geometry(), new THREE.MeshBasicMaterial(
      { transparent: true, opacity: 0.22, side: THREE.DoubleSide, depthWrite: false }));
    this.object.frustumCulled = false;
    this.object.renderOrder = 3;
    theme.follow(() => this.object.material.color.copy(theme.colour(this.proved ? "good" : "fourth")));
  }

  get proved() { return this.data.kind === "proved"; }
  get largest() { return this.radius.reduce((a, b) => Math.max(a, b), 0); }

  // The largest of the periods that [from, to] touches; seconds of the flight.
  widest(from, to) {
    const last = this.radius.length - 1, at = t => Math.min(Math.max(Math.floor(t / this.data.period), 0), last);
    let widest = 0;
    for (let k = at(from); k <= at(to); ++k) widest = Math.max(widest, this.radius[k]);
    return widest;
  }

  geometry() {
    const { motion } = this, n = Math.min(Math.max(Math.ceil(motion.duration / this.data.period) + 1, 2), mostTubeRings);
    const step = motion.duration / (n - 1), points = new Float32Array(3 * n * tubeSides), at = new THREE.Vector3();
    const before = new THREE.Vector3(), after = new THREE.Vector3(), along = new THREE.Vector3(1, 0, 0);
    const across = new THREE.Vector3(), up = new THREE.Vector3();
    for (let i = 0; i < n; ++i) {
      const t = i * step, clockTime = motion.begin + t;
      motion.place(clockTime - step / 2, before);
      motion.place(clockTime + step / 2, after);
      if (after.distanceToSquared(before) > 1e-12) along.subVectors(after, before).normalize();
      across.set(0, 0, 1).cross(along);
      if (across.lengthSq() < 1e-6) across.set(0, 1, 0);
      across.normalize();
      up.crossVectors(along, across);
      motion.place(clockTime, at);
      const r = this.widest(t - step, t + step);
      for (let k = 0; k < tubeSides; ++k) {
        const c = r * Math.cos(2 * Math.PI * k / tubeSides), s = r * Math.sin(2 * Math.PI * k / tubeSides);
        for (const [axis, key] of ["x", "y", "z"].entries()) {
          points[3 * (i * tubeSides + k) + axis] = at[key] + c * across[key] + s * up[key];
        }
      }
    }
    const geometry = new THREE.BufferGeometry(), sides = [];
    for (let i = 0; i + 1 < n; ++i) {
      for (let k = 0; k < tubeSides; ++k) {
        const a = i * tubeSides + k, b = i * tubeSides + (k + 1) % tubeSides;
        sides.push(a, b, a + tubeSides, b, b + tubeSides, a + tubeSides);
      }
    }
    geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(sides), 1));
    return geometry;
  }
}
