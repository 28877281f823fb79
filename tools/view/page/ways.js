// Many lines in one draw call: whole, or as trails behind vehicles; each in its mission's colour or by a value.

const wayFragment = `
uniform sampler2D ramp; uniform float low; uniform float span; uniform float opacity; uniform float now; uniform float trail;
uniform vec3 unknown; varying float vValue; varying float vAlong;
void main() {
  float age = now - vAlong;
  if (trail > 0.0 && (age < 0.0 || age > trail)) discard;
  float faint = trail > 0.0 ? 1.0 - age / trail : 1.0;
  vec3 known = texture2D(ramp, vec2(clamp((vValue - low) / span, 0.002, 0.998), 0.5)).rgb;
  gl_FragColor = vec4(vValue < -1e29 ? unknown : known, opacity * faint);
}`;

const mostWaySteps = 120000;  // drawn at most, of all lines together

// The colours of missions side by side, for what is coloured by mission: value 0.5, 1.5, …
const missionRamp = (() => {
  const texture = new THREE.DataTexture(new Uint8Array(4 * missionColours), missionColours, 1, THREE.RGBAFormat);
  texture.minFilter = texture.magFilter = THREE.NearestFilter;
  theme.follow(() => {
    for (let i = 0; i < missionColours; ++i) {
      const c = theme.colour(`mission-${i}`);
      texture.image.data.set([c.r * 255, c.g * 255, c.b * 255, 255], 4 * i);
    }
    texture.needsUpdate = true;
  });
  return texture;
})();

const unknownValue = -1e30;

// A scale for a value of each mission: plain colours where `range` is null.
function setScale(uniforms, range) {
  uniforms.ramp.value = range ? valueRamp : missionRamp;
  uniforms.low.value = range ? range[0] : 0;
  uniforms.span.value = range ? Math.max(range[1] - range[0], 1e-9) : missionColours;
}

class Ways {
  // `lines`: [{ points, mission, time }], x, y, z after one another; `time`: of each point on the clock, or null.
  constructor(lines) {
    const total = lines.reduce((sum, l) => sum + l.points.length / 3, 0);
    this.every = Math.ceil(total / mostWaySteps);
    this.lines = lines.map(line => ({ ...line, kept: this.kept(line.points.length / 3) }));
    const steps = this.lines.reduce((sum, l) => sum + l.kept.length - 1, 0);
    this.ends = new Float32Array(6 * steps);
    this.along = new Float32Array(2 * steps);
    this.values = new Float32Array(2 * steps);
    this.steps = steps;
    this.material = this.makeMaterial();
    const mesh = new THREE.Mesh(this.geometry(), this.material);
    mesh.frustumCulled = false;
    mesh.renderOrder = 3;
    this.object = mesh;
    this.colourBy(null);
    theme.follow(() => this.material.uniforms.unknown.value.copy(theme.colour("soft")));
  }

  // Every so many points, and the last.
  kept(count) {
    const kept = [];
    for (let i = 0; i < count - 1; i += this.every) kept.push(i);
    if (count > 0) kept.push(count - 1);
    return kept;
  }

  // f(line, index of its point, number of the step, 0 for its begin and 1 for its end)
  each(f) {
    let step = 0;
    for (const line of this.lines) {
      for (let k = 1; k < line.kept.length; ++k, ++step) {
        f(line, line.kept[k - 1], step, 0);
        f(line, line.kept[k], step, 1);
      }
    }
  }

  geometry() {
    this.each((line, i, step, end) => {
      for (let axis = 0; axis < 3; ++axis) this.ends[6 * step + 3 * end + axis] = line.points[3 * i + axis];
      this.along[2 * step + end] = line.time ? line.time(i) : 0;
    });
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const set = (array, size, names) => {
      const buffer = new THREE.InstancedInterleavedBuffer(array, 2 * size);
      names.forEach((name, end) => geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(buffer, size, end * size)));
      return buffer;
    };
    set(this.ends, 3, ["from", "to"]);
    set(this.along, 1, ["alongFrom", "alongTo"]);
    this.valueBuffer = set(this.values, 1, ["valueFrom", "valueTo"]);
    geometry.maxInstancedCount = this.steps;
    return geometry;
  }

  makeMaterial() {
    return new THREE.ShaderMaterial({
      vertexShader: ribbonVertex, fragmentShader: wayFragment, side: THREE.DoubleSide, transparent: true, depthWrite: false,
      uniforms: { pixels: { value: stagePixels }, width: { value: 1 }, casing: { value: 0 }, nearest: { value: 0.05 },
        ramp: { value: missionRamp }, low: { value: 0 }, span: { value: missionColours }, unknown: { value: new THREE.Color() },
        opacity: { value: 0.6 }, now: { value: 0 }, trail: { value: 0 } } });
  }

  // `value(line, i)`: of its point i, or NaN where it is not known; null: the colours of missions. `range`: [low, high].
  colourBy(value, range) {
    this.each((line, i, step, end) => {
      const v = value ? value(line, i) : line.mission.index % missionColours + 0.5;
      this.values[2 * step + end] = Number.isFinite(v) ? v : unknownValue;
    });
    this.valueBuffer.needsUpdate = true;
    setScale(this.material.uniforms, value ? range : null);
  }

  // Trails of so many seconds before `now`; 0: whole lines.
  show(now, trail) {
    const { uniforms } = this.material;
    uniforms.now.value = now;
    uniforms.trail.value = trail;
    uniforms.opacity.value = trail ? 0.9 : this.lines.length > 200 ? 0.3 : 0.6;
    uniforms.width.value = trail ? 1.6 : 1;
  }
}
