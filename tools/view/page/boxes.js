// The city: all boxes in one draw call, coloured by height or label, the buildings outlined. Of each
// box only the three faces that can be seen are drawn: on every axis the one on the camera's side.

// A box is drawn a little larger than it is, less than can be seen, so that nothing shines through between neighbours;
// and each building is a hair nearer or farther than others, so that where they overlap one hides the other; walls are farther than roofs.
// Walls inside a building are left out.
const boxVertex = `
attribute vec3 low; attribute vec3 high; attribute vec3 tint; attribute vec4 building;
uniform vec3 sun; uniform float perPixel;
varying vec3 vLocal; varying vec3 vSize; varying vec3 vNormal; varying vec3 vTint; varying vec3 vBuilding;
varying float vTop; varying float vAway; varying float vWallLight; varying float vZone;
// Of a room's outer wall: whether the camera is on its outer side.
bool cut(float side) {
  if (side < 0.5) return false;
  if (side < 1.5) return cameraPosition.x < high.x;
  if (side < 2.5) return cameraPosition.x > low.x;
  if (side < 3.5) return cameraPosition.y < high.y;
  if (side < 4.5) return cameraPosition.y > low.y;
  return cameraPosition.z > low.z;
}
float lightOf(float along) { return 0.66 + 0.34 * clamp(along, -0.4, 1.0); }
void main() {
  float traits = floor(building.w * 255.0 + 0.5), wall = mod(floor(traits / 16.0), 8.0);
  vZone = step(128.0, traits);
  vec3 top = high;
  if (cut(wall)) top.z = mix(low.z, high.z, wall > 4.5 ? 0.0 : 0.05);  // a stub says where the wall is
  vSize = top - low;
  vec3 side = step(0.5 * (low + top), cameraPosition);
  vec3 towards = 2.0 * side - 1.0, corner = mix(1.0 - position, position, side);
  vNormal = normal * towards; vTint = tint; vBuilding = building.xyz; vTop = high.z;
  vWallLight = 0.5 * (lightOf(sun.x * towards.x) + lightOf(sun.y * towards.y));
  vLocal = corner * vSize;
  vec3 at = mix(low, top, corner);
  at += (2.0 * corner - 1.0) * 0.12 * perPixel * distance(at, cameraPosition);
  vec4 eye = modelViewMatrix * vec4(at, 1.0);
  vAway = -eye.z;
  float hair = mod(building.z * 255.0 + 7.0 * building.y * 255.0, 16.0) + (normal.z > 0.5 ? 0.0 : 16.0);
  gl_Position = projectionMatrix * vec4(eye.xyz * (1.0 + 1.5e-5 * hair), 1.0);
  vec2 bit = normal.x > 0.5 ? vec2(1.0, side.x) : vec2(4.0, side.y);
  float covered = mod(floor(mod(traits, 16.0) / (bit.x * (1.0 + bit.y))), 2.0);
  if ((normal.z < 0.5 && covered > 0.5) || (wall > 4.5 && cut(wall))) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
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
varying float vTop; varying float vAway; varying float vWallLight; varying float vZone;
uniform vec3 zone;
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
  // Air that is kept out of is a fine mesh: what flies in it is seen.
  if (vZone > 0.5 && mod(floor(gl_FragCoord.x) + 3.0 * floor(gl_FragCoord.y), 7.0) > 0.5) discard;
  if (vZone > 0.5) { gl_FragColor = vec4(zone, 1.0); return; }
  vec3 base = mix(texture2D(ramp, vec2(clamp((vTop - lowest) / span, 0.002, 0.998), 0.5)).rgb, vTint, byLabel);
  vec3 colour = mix(base * light(), edge, outline() * edgeShare);
  float haze = clamp((vAway - reach) / (3.0 * reach), 0.0, 0.6);
  gl_FragColor = vec4(mix(colour, sky, haze), 1.0);
}`;

// A colour that the source wrote, lighter in the dark where it would not be seen against the ground.
function seenColour(css) {
  const colour = new THREE.Color(css), ground = theme.colour("ground"), white = new THREE.Color("#ffffff");
  for (let i = 0; theme.current() === "dark" && i < 20 && contrastOf(colour, ground) < leastContrast; ++i) colour.lerp(white, 0.1);
  return colour;
}

class Boxes {
  constructor(map) {
    this.map = map;
    this.count = map.boxes;
    this.labels = map.labels;
    this.written = map.colours || [];  // of labels that are colours
    this.buildings = map.buildings;
    this.typical = map.typical;
    this.ramp = rampTexture(heightStops());
    this.heights();
    this.levels = map.far ? new BoxLevels(map) : null;
    this.tints = null;  // of each box its own colour, where one is asked for
    const material = this.material();
    this.parts = Array.from({ length: this.levels ? 2 : 1 }, () => {
      const part = new THREE.Mesh(new THREE.BufferGeometry(), material);
      part.frustumCulled = false;
      return part;
    });
    this.mesh = new THREE.Group();
    this.mesh.add(...this.parts);
    if (!this.levels) this.gather();
    theme.follow(() => this.recolour());
  }

  get uniforms() { return this.parts[0].material.uniforms; }

  // Arrays of all boxes, unpacked when they are first needed.
  once(name, make) {
    const value = make();
    Object.defineProperty(this, name, { value });
    return value;
  }
  get corners() {
    return this.once("corners", () => (this.levels ? cornersOf(this.map.corners, this.map.step) : arrayOf(this.map.corners)));
  }
  get label() { return this.once("label", () => arrayOf(this.map.label)); }
  get ids() { return this.once("ids", () => arrayOf(this.map.ids)); }
  get building() { return this.once("building", () => arrayOf(this.map.building)); }
  // Bits 0 to 3: the walls to the west, east, south and north stand inside the building; 4 to 6: the side of a room that
  // the box closes, 1 to 4 in that order or 5, the top; 7: it is air to keep out of.
  get traits() { return this.once("traits", () => arrayOf(this.map.traits)); }

  // Few towers must not take the scale from all others: it ends where 98 of 100 tops are, and says so.
  heights() {
    const [lowest, usual, most] = this.map.tops;
    this.lowest = lowest;
    this.cut = most - lowest > 1.5 * (usual - lowest) && usual > lowest;
    this.highest = this.cut ? usual : most;
  }

  // What is seen from the camera: boxes near it, blocks far away.
  look(camera, perPixel) {
    if (!this.levels || (!this.levels.look(camera, perPixel) && !this.stale)) return;
    this.stale = false;
    this.gather();
  }

  gather() {
    const near = this.levels ? this.levels.nearStretches() : [[0, this.count]];
    this.fill(this.parts[0], instancedBoxes, near.map(([from, to]) => [this, from, to]));
    if (this.levels) this.fill(this.parts[1], plainBoxes, this.levels.farStretches());
  }

  // `stretches`: [[what has corners, building and traits, from, to], …]
  fill(part, geometryOf, stretches) {
    const count = stretches.reduce((sum, [, from, to]) => sum + to - from, 0);
    const arrays = { corners: new Float32Array(6 * count), numbers: new Uint8Array(4 * Math.max(count, 1)),
      tints: new Uint8Array(this.tints ? 3 * Math.max(count, 1) : 3) };
    let at = 0;
    for (const [source, from, to] of stretches) {
      arrays.corners.set(source.corners.subarray(6 * from, 6 * to), 6 * at);
      for (let i = from; i < to; ++i, ++at) this.describe(source, i, arrays, at);
    }
    part.geometry.dispose();
    part.geometry = geometryOf(arrays);
    part.visible = count > 0;
    part.count = count;
  }

  // The number of the box's building in three bytes, its traits, and its colour: of a block that of one of its boxes.
  describe(source, i, { numbers, tints }, at) {
    const n = source.building[i], box = source.of ? source.of[i] : i;
    numbers[4 * at] = n >> 16 & 255;
    numbers[4 * at + 1] = n >> 8 & 255;
    numbers[4 * at + 2] = n & 255;
    numbers[4 * at + 3] = source.traits[i];
    if (this.tints) for (let k = 0; k < 3; ++k) tints[3 * at + k] = this.tints[3 * box + k];
  }

  material() {
    const material = new THREE.ShaderMaterial({
      vertexShader: boxVertex, fragmentShader: boxFragment, side: THREE.DoubleSide,
      uniforms: { ramp: { value: this.ramp }, lowest: { value: this.lowest },
        span: { value: Math.max(this.highest - this.lowest, 1e-3) }, byLabel: { value: 0 },
        edge: { value: new THREE.Color() }, sky: { value: new THREE.Color() },
        focus: { value: new THREE.Vector3() }, hole: { value: 0 }, reach: { value: 1e9 }, edgeShare: { value: 0.3 },
        shown: { value: null }, pixel: { value: new THREE.Vector2(1, 1) }, perPixel: { value: 1 }, typical: { value: this.typical },
        sun: { value: new THREE.Vector3(-0.45, -0.3, 0.84).normalize() }, zone: { value: new THREE.Color() } } });
    material.extensions.derivatives = true;
    return material;
  }

  // A label that is a colour has that; of the others the most frequent get one each, the rest share the last.
  labelLegend() {
    if (!this.map.label) return [];
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
    const byLabel = what === "label" && Boolean(this.map.label);
    if (byLabel) {
      const rest = new THREE.Color(labelColours[labelColours.length - 1]);
      const colours = new Map(this.labelLegend().map(l => [l.label, seenColour(l.colour)]));
      this.tints = this.tints || new Uint8Array(3 * this.count);
      for (let i = 0; i < this.count; ++i) {
        const c = colours.get(this.label[i]) || rest;
        this.tints.set([c.r * 255, c.g * 255, c.b * 255], i * 3);
      }
      if (this.levels) this.stale = true; else this.gather();
    }
    this.byLabel = byLabel;
    this.uniforms.byLabel.value = byLabel ? 1 : 0;
  }

  get hasZones() { return this.labels.some(label => label === "fence" || label === "keep-out" || label.startsWith("keep-out: ")); }

  recolour() {
    const { uniforms } = this;
    fillRamp(this.ramp, heightStops());
    uniforms.edge.value.copy(theme.colour("edge"));
    uniforms.sky.value.copy(theme.colour("sky"));
    uniforms.zone.value.copy(theme.colour("zone"));
    uniforms.edgeShare.value = theme.current() === "dark" ? 0.8 : 0.62;
  }

  // The first box of that id in the source; null where there is none.
  withId(id) {
    const index = this.ids && id !== undefined ? this.ids.indexOf(id) : -1;
    return index < 0 ? null : index;
  }

  // Leaves out what is nearer than `depth` metres within `radius` of (x, y), in pixels; 0: nothing.
  setHole(x, y, depth, radius) {
    const { focus, hole } = this.uniforms;
    focus.value.set(x, y, depth);
    hole.value = radius;
  }

  // Colours that the source wrote are shown unasked.
  usualColour() { return this.map.label && this.written.some(Boolean) ? "label" : "height"; }

  // `perPixel`: how much of the view, one metre away, a pixel is.
  setScale(perPixel) { this.uniforms.perPixel.value = perPixel; }

  setHaze(reach) { this.uniforms.reach.value = reach; }
}
