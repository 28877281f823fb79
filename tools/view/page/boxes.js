// The city: all boxes in one draw call, coloured by height or label, with hairline edges. Of each
// box only the three faces that can be seen are drawn: on every axis the one on the camera's side.

const boxVertex = `
attribute vec3 low; attribute vec3 high; attribute vec3 tint;
varying vec3 vLocal; varying vec3 vSize; varying vec3 vNormal; varying vec3 vTint; varying float vTop; varying float vAway;
void main() {
  vSize = high - low;
  vec3 side = step(0.5 * (low + high), cameraPosition);
  vLocal = mix(1.0 - position, position, side) * vSize;
  vNormal = normal * (2.0 * side - 1.0); vTint = tint; vTop = high.z;
  vec4 eye = modelViewMatrix * vec4(low + vLocal, 1.0);
  vAway = -eye.z;
  gl_Position = projectionMatrix * eye;
}`;

const boxFragment = `
uniform sampler2D ramp; uniform float lowest; uniform float span; uniform float byLabel;
uniform vec3 focus; uniform float hole; uniform vec3 edge; uniform vec3 sky; uniform float reach; uniform vec3 sun; uniform float edgeShare;
varying vec3 vLocal; varying vec3 vSize; varying vec3 vNormal; varying vec3 vTint; varying float vTop; varying float vAway;
float edgeOf(float at, float size) {
  float w = fwidth(at);
  float away = min(at, size - at) / max(w, 1e-6);
  return (1.0 - smoothstep(0.5, 1.5, away)) * clamp(size / w / 14.0 - 0.15, 0.0, 1.0);
}
// What hides the followed vehicle is left out around it, with a half-open rim.
void cutAway() {
  float away = distance(gl_FragCoord.xy, focus.xy) / hole;
  if (vAway > focus.z || away > 1.0) return;
  if (away < 0.8 || mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 2.0) < 0.5) discard;
}
void main() {
  if (hole > 0.0) cutAway();
  vec3 n = normalize(vNormal);
  vec3 base = mix(texture2D(ramp, vec2(clamp((vTop - lowest) / span, 0.002, 0.998), 0.5)).rgb, vTint, byLabel);
  float light = 0.70 + 0.30 * clamp(dot(n, sun), -0.4, 1.0);
  vec3 a = abs(n);
  vec3 line = vec3(edgeOf(vLocal.x, vSize.x), edgeOf(vLocal.y, vSize.y), edgeOf(vLocal.z, vSize.z)) * (1.0 - a);
  float drawn = max(line.x, max(line.y, line.z));
  vec3 colour = mix(base * light, edge, drawn * edgeShare);
  float haze = clamp((vAway - reach) / (3.0 * reach), 0.0, 0.6);
  gl_FragColor = vec4(mix(colour, sky, haze), 1.0);
}`;

class Boxes {
  constructor(map) {
    this.corners = arrayOf(map.corners);
    this.label = arrayOf(map.label);
    this.ids = arrayOf(map.ids);
    this.count = this.corners.length / 6;
    this.labels = map.labels;
    this.ramp = rampTexture(heightStops());
    this.heights();
    this.mesh = new THREE.Mesh(this.geometry(), this.material());
    this.mesh.frustumCulled = false;
    theme.follow(() => this.recolour());
  }

  heights() {
    let low = Infinity, high = -Infinity;
    for (let i = 5; i < this.corners.length; i += 6) {
      if (this.corners[i] < low) low = this.corners[i];
      if (this.corners[i] > high) high = this.corners[i];
    }
    this.lowest = this.count ? low : 0;
    this.highest = this.count ? high : 1;
  }

  geometry() {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(
      [1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1], 3));
    geometry.setAttribute("normal", new THREE.Float32BufferAttribute(
      [[1, 0, 0], [0, 1, 0], [0, 0, 1]].flatMap(n => [n, n, n, n].flat()), 3));
    geometry.setIndex([0, 4, 8].flatMap(k => [k, k + 1, k + 2, k, k + 2, k + 3]));
    const corners = new THREE.InstancedInterleavedBuffer(this.corners, 6);
    geometry.setAttribute("low", new THREE.InterleavedBufferAttribute(corners, 3, 0));
    geometry.setAttribute("high", new THREE.InterleavedBufferAttribute(corners, 3, 3));
    this.tint = new THREE.InstancedBufferAttribute(new Uint8Array(this.label ? this.count * 3 : 3), 3, true,
      this.label ? 1 : Math.max(this.count, 1));
    geometry.setAttribute("tint", this.tint);
    geometry.maxInstancedCount = this.count;
    return geometry;
  }

  material() {
    const material = new THREE.ShaderMaterial({
      vertexShader: boxVertex, fragmentShader: boxFragment, side: THREE.DoubleSide,
      uniforms: { ramp: { value: this.ramp }, lowest: { value: this.lowest },
        span: { value: Math.max(this.highest - this.lowest, 1e-3) }, byLabel: { value: 0 },
        edge: { value: new THREE.Color() }, sky: { value: new THREE.Color() },
        focus: { value: new THREE.Vector3() }, hole: { value: 0 }, reach: { value: 1e9 }, edgeShare: { value: 0.3 },
        sun: { value: new THREE.Vector3(-0.45, -0.3, 0.84).normalize() } } });
    material.extensions.derivatives = true;
    return material;
  }

  // The most frequent labels get a colour each; all others share the last.
  labelLegend() {
    if (!this.label) return [];
    const counts = new Map();
    for (const l of this.label) counts.set(l, (counts.get(l) || 0) + 1);
    const order = [...counts].sort((a, b) => b[1] - a[1] || a[0] - b[0]);
    const own = order.length > labelColours.length ? labelColours.length - 1 : order.length;
    const legend = order.slice(0, own).map(([label, boxes], i) => (
      { label, name: this.labels[label] || "no label", boxes, colour: labelColours[i] }));
    const rest = order.slice(own).reduce((sum, [, boxes]) => sum + boxes, 0);
    if (rest) legend.push({ label: null, name: "others", boxes: rest, colour: labelColours[labelColours.length - 1] });
    return legend;
  }

  colourBy(what) {
    if (what === "label" && this.label) {
      const rest = new THREE.Color(labelColours[labelColours.length - 1]);
      const colours = new Map(this.labelLegend().map(l => [l.label, new THREE.Color(l.colour)]));
      for (let i = 0; i < this.count; ++i) {
        const c = colours.get(this.label[i]) || rest;
        this.tint.array.set([c.r * 255, c.g * 255, c.b * 255], i * 3);
      }
      this.tint.needsUpdate = true;
    }
    this.mesh.material.uniforms.byLabel.value = what === "label" && this.label ? 1 : 0;
  }

  recolour() {
    const { uniforms } = this.mesh.material;
    fillRamp(this.ramp, heightStops());
    uniforms.edge.value.copy(theme.colour("edge"));
    uniforms.sky.value.copy(theme.colour("sky"));
    uniforms.edgeShare.value = theme.current() === "dark" ? 0.55 : 0.3;
  }

  // The first box of that id in the source; null where there is none.
  withId(id) {
    const index = this.ids && id !== undefined ? this.ids.indexOf(id) : -1;
    return index < 0 ? null : index;
  }

  // Leaves out what is nearer than `depth` metres within `radius` of (x, y), in pixels; 0: nothing.
  setHole(x, y, depth, radius) {
    const { focus, hole } = this.mesh.material.uniforms;
    focus.value.set(x, y, depth);
    hole.value = radius;
  }

  setHaze(reach) { this.mesh.material.uniforms.reach.value = reach; }
}
