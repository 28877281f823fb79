// The city: all boxes in one draw call, coloured by height or label, the buildings outlined. Of each
// box only the three faces that can be seen are drawn: on every axis the one on the camera's side.

// A box is drawn a little larger than it is, less than can be seen, so that nothing shines through between neighbours;
// and each building is a hair nearer or farther than others, so that where they overlap one hides the other; walls are farther than roofs.
// Walls inside a building are left out.
const boxVertex = `
attribute vec3 low; attribute vec3 high; attribute vec3 tint; attribute vec4 building;
uniform vec3 sun; uniform float perPixel;
varying vec3 vLocal; varying vec3 vSize; varying vec3 vNormal; varying vec3 vTint; varying vec3 vBuilding;
varying float vTop; varying float vAway; varying float vWallLight;
float lightOf(float along) { return 0.66 + 0.34 * clamp(along, -0.4, 1.0); }
void main() {
  vSize = high - low;
  vec3 side = step(0.5 * (low + high), cameraPosition);
  vec3 towards = 2.0 * side - 1.0, corner = mix(1.0 - position, position, side);
  vNormal = normal * towards; vTint = tint; vBuilding = building.xyz; vTop = high.z;
  vWallLight = 0.5 * (lightOf(sun.x * towards.x) + lightOf(sun.y * towards.y));
  vLocal = corner * vSize;
  vec3 at = mix(low, high, corner);
  at += (2.0 * corner - 1.0) * 0.12 * perPixel * distance(at, cameraPosition);
  vec4 eye = modelViewMatrix * vec4(at, 1.0);
  vAway = -eye.z;
  float hair = mod(building.z * 255.0 + 7.0 * building.y * 255.0, 16.0) + (normal.z > 0.5 ? 0.0 : 16.0);
  gl_Position = projectionMatrix * vec4(eye.xyz * (1.0 + 1.5e-5 * hair), 1.0);
  vec2 bit = normal.x > 0.5 ? vec2(1.0, side.x) : vec2(4.0, side.y);
  float covered = mod(floor((building.w * 255.0 + 0.5) / (bit.x * (1.0 + bit.y))), 2.0);
  if (normal.z < 0.5 && covered > 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

// What hides the followed vehicle is left out around it, with a half-open rim.
const cutAwayShader = `
void cutAway() {
  float away = distance(gl_FragCoord.xy, focus.xy) / hole;
  if (vAway > focus.z || away > 1.0) return;
  if (away < 0.8 || mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 2.0) < 0.5) discard;
}`;

const boxFragment = `
uniform sampler2D ramp; uniform sampler2D shown; uniform float lowest; uniform float span; uniform float byLabel;
uniform vec3 focus; uniform float hole; uniform vec3 edge; uniform vec3 sky; uniform float reach; uniform vec3 sun; uniform float edgeShare;
uniform vec2 pixel; uniform float perPixel; uniform float typical;
varying vec3 vLocal; varying vec3 vSize; varying vec3 vNormal; varying vec3 vTint; varying vec3 vBuilding;
varying float vTop; varying float vAway; varying float vWallLight;
${cutAwayShader}
float numberOf(vec3 building) { return dot(floor(building * 255.0 + 0.5), vec3(65536.0, 256.0, 1.0)); }
// 1 at the rim of a building, less at that of its roof; once, on the side of the larger number.
float outlineTowards(vec2 step, float mine, bool roof) {
  vec2 here = gl_FragCoord.xy * pixel;
  vec4 there = texture2D(shown, here + step * pixel);
  if (there.a < 0.25) return 1.0;
  float other = numberOf(there.rgb);
  if (other != mine) return other < mine ? 1.0 : 0.0;
  if (!roof || there.a > 0.75) return 0.0;
  vec4 beyond = texture2D(shown, here + 7.0 * step * pixel);  // the riser of a stair is no rim
  return beyond.a < 0.75 && beyond.a > 0.25 && numberOf(beyond.rgb) == mine ? 0.6 : 0.0;
}
float outline() {
  float mine = numberOf(vBuilding);
  bool roof = abs(vNormal.z) > 0.5;
  float drawn = max(max(outlineTowards(vec2(1.0, 0.0), mine, roof), outlineTowards(vec2(-1.0, 0.0), mine, roof)),
    max(outlineTowards(vec2(0.0, 1.0), mine, roof), outlineTowards(vec2(0.0, -1.0), mine, roof)));
  return drawn * clamp((typical / (vAway * perPixel) - 4.0) / 16.0, 0.12, 1.0);
}
// Ends of strips too narrow to be seen alone have the mean light of both walls.
float light() {
  vec3 n = normalize(vNormal), a = abs(n);
  float own = 0.66 + 0.34 * clamp(dot(n, sun), -0.4, 1.0);
  if (a.z > 0.5) return own;
  float across = a.x > 0.5 ? vSize.y / max(fwidth(vLocal.y), 1e-6) : vSize.x / max(fwidth(vLocal.x), 1e-6);
  return mix(vWallLight, own, smoothstep(3.0, 12.0, across));
}
void main() {
  if (hole > 0.0) cutAway();
  vec3 base = mix(texture2D(ramp, vec2(clamp((vTop - lowest) / span, 0.002, 0.998), 0.5)).rgb, vTint, byLabel);
  vec3 colour = mix(base * light(), edge, outline() * edgeShare);
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
    this.written = map.colours || [];  // of labels that are colours
    this.ramp = rampTexture(heightStops());
    this.heights();
    Object.assign(this, buildingsOf(this));
    this.mesh = new THREE.Mesh(this.geometry(), this.material());
    this.mesh.frustumCulled = false;
    theme.follow(() => this.recolour());
  }

  // Few towers must not take the scale from all others: it ends where 98 of 100 tops are, and says so.
  heights() {
    const tops = new Float32Array(this.count);
    for (let i = 0; i < this.count; ++i) tops[i] = this.corners[6 * i + 5];
    tops.sort();
    const most = tops[this.count - 1], usual = tops[Math.floor(this.count * 0.98)];
    this.lowest = this.count ? tops[0] : 0;
    this.cut = most - this.lowest > 1.5 * (usual - this.lowest) && usual > this.lowest;
    this.highest = this.count ? (this.cut ? usual : most) : 1;
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
    geometry.setAttribute("building", new THREE.InstancedBufferAttribute(this.numbers(), 4, true));
    geometry.maxInstancedCount = this.count;
    return geometry;
  }

  // The number of each box's building in three bytes, and its covered walls.
  numbers() {
    const bytes = new Uint8Array(Math.max(this.count, 1) * 4);
    for (let i = 0; i < this.count; ++i) {
      const n = this.building[i];
      bytes.set([n >> 16 & 255, n >> 8 & 255, n & 255, this.covered[i]], 4 * i);
    }
    return bytes;
  }

  material() {
    const material = new THREE.ShaderMaterial({
      vertexShader: boxVertex, fragmentShader: boxFragment, side: THREE.DoubleSide,
      uniforms: { ramp: { value: this.ramp }, lowest: { value: this.lowest },
        span: { value: Math.max(this.highest - this.lowest, 1e-3) }, byLabel: { value: 0 },
        edge: { value: new THREE.Color() }, sky: { value: new THREE.Color() },
        focus: { value: new THREE.Vector3() }, hole: { value: 0 }, reach: { value: 1e9 }, edgeShare: { value: 0.3 },
        shown: { value: null }, pixel: { value: new THREE.Vector2(1, 1) }, perPixel: { value: 1 }, typical: { value: this.typical },
        sun: { value: new THREE.Vector3(-0.45, -0.3, 0.84).normalize() } } });
    material.extensions.derivatives = true;
    return material;
  }

  // A label that is a colour has that; of the others the most frequent get one each, the rest share the last.
  labelLegend() {
    if (!this.label) return [];
    const counts = new Map();
    for (const l of this.label) counts.set(l, (counts.get(l) || 0) + 1);
    const order = [...counts].sort((a, b) => b[1] - a[1] || a[0] - b[0]);
    const written = order.filter(([label]) => this.written[label]);
    const named = order.filter(([label]) => !this.written[label]);
    const own = named.length > labelColours.length ? labelColours.length - 1 : named.length;
    const key = ([label, boxes], colour) => ({ label, name: this.labels[label] || "no label", boxes, colour });
    const legend = [...written.map(l => key(l, this.written[l[0]])), ...named.slice(0, own).map((l, i) => key(l, labelColours[i]))];
    const rest = named.slice(own).reduce((sum, [, boxes]) => sum + boxes, 0);
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
    uniforms.edgeShare.value = theme.current() === "dark" ? 0.8 : 0.62;
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

  // Colours that the source wrote are shown unasked.
  usualColour() { return this.label && this.written.some(Boolean) ? "label" : "height"; }

  // `perPixel`: how much of the view, one metre away, a pixel is.
  setScale(perPixel) { this.mesh.material.uniforms.perPixel.value = perPixel; }

  setHaze(reach) { this.mesh.material.uniforms.reach.value = reach; }
}
