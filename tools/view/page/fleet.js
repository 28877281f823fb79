// All flights that share one time: their vehicles in one draw call, and their ways in another.

const fleetPixels = 15;  // at least, of a vehicle in the air, from tip to tip
const restShare = 0.55;  // of that, of one that stands
const fleetShape = quadrotor(6);

const fleetVertex = `
attribute vec4 place; attribute vec3 look;
uniform float perPixel; uniform float pixels; uniform float rest;
varying vec3 vNormal; varying float vValue; varying float vFlies;
void main() {
  float c = cos(place.w), s = sin(place.w), away = distance(place.xyz, cameraPosition);
  float size = max(look.z, away * perPixel * pixels * 0.5) * mix(rest, 1.0, look.y);
  mat3 turn = mat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);
  vNormal = turn * normal; vValue = look.x; vFlies = look.y;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place.xyz + size * (turn * position), 1.0);
}`;

const fleetFragment = `
uniform sampler2D ramp; uniform float low; uniform float span; uniform vec3 unknown; uniform vec3 resting; uniform vec3 sun;
varying vec3 vNormal; varying float vValue; varying float vFlies;
void main() {
  vec3 known = texture2D(ramp, vec2(clamp((vValue - low) / span, 0.002, 0.998), 0.5)).rgb;
  vec3 colour = vFlies < 0.5 ? resting : vValue < -1e29 ? unknown : known;
  gl_FragColor = vec4(colour * (0.78 + 0.3 * clamp(dot(normalize(vNormal), sun), -0.4, 1.0)), 1.0);
}`;

class Fleet {
  constructor(list) {
    this.motions = list;
    this.places = new Float32Array(4 * list.length);  // x, y, z, where the nose points
    this.looks = new Float32Array(3 * list.length);   // value, in the air or not, metres from the middle to a tip
    this.values = null;
    list.forEach((motion, i) => {
      const half = motion.data.vehicle ? motion.data.vehicle.half : [0.25, 0.25, 0.1];
      this.looks[3 * i + 2] = Math.max(half[0], half[1], 0.05);
    });
    this.ways = new Ways(list.map(motion => ({ motion, mission: motion.mission, points: motion.position,
      time: i => motion.begin + motion.time[i] })));
    this.trail = list.length > 100 ? 20 : 0;
    this.material = this.makeMaterial();
    this.vehicles = new THREE.Mesh(this.geometry(), this.material);
    this.vehicles.frustumCulled = false;
    this.vehicles.renderOrder = 6;
    this.object = new THREE.Group();
    this.object.add(this.ways.object, this.vehicles);
    this.airborne = 0;
    this.colourBy(null);
    theme.follow(() => {
      this.material.uniforms.unknown.value.copy(theme.colour("soft"));
      this.material.uniforms.resting.value.copy(theme.colour("rest"));
    });
  }

  geometry() {
    const geometry = new THREE.InstancedBufferGeometry();
    for (const name of ["position", "normal"]) geometry.setAttribute(name, fleetShape.attributes[name]);
    this.placeBuffer = new THREE.InstancedBufferAttribute(this.places, 4);
    this.lookBuffer = new THREE.InstancedBufferAttribute(this.looks, 3);
    geometry.setAttribute("place", this.placeBuffer);
    geometry.setAttribute("look", this.lookBuffer);
    geometry.maxInstancedCount = this.motions.length;
    return geometry;
  }

  makeMaterial() {
    return new THREE.ShaderMaterial({ vertexShader: fleetVertex, fragmentShader: fleetFragment,
      uniforms: { perPixel: { value: 1 }, pixels: { value: fleetPixels }, rest: { value: restShare }, ramp: { value: missionRamp },
        low: { value: 0 }, span: { value: 1 }, unknown: { value: new THREE.Color() }, resting: { value: new THREE.Color() },
        sun: { value: new THREE.Vector3(-0.45, -0.3, 0.84).normalize() } } });
  }

  // Where all are; `hidden`: those that are drawn by themselves.
  update(time, perPixel, hidden) {
    const at = new Float64Array(3);
    this.airborne = 0;
    this.motions.forEach((motion, i) => {
      const flies = motion.flies(time);
      this.airborne += flies;
      this.looks[3 * i + 1] = flies ? 1 : 0;
      this.put(motion, i, motion.local(time), at);
      if (hidden.has(motion)) this.places[4 * i + 2] = -1e9;
    });
    this.placeBuffer.needsUpdate = this.lookBuffer.needsUpdate = true;
    this.material.uniforms.perPixel.value = perPixel;
    this.ways.show(time, this.trail);
  }

  // The nose goes ahead; at rest it stays where it was.
  put(motion, i, t, at) {
    if (motion.knots) motion.knots.evaluate(t, 0, at); else motion.vector(motion.position, t).toArray(at);
    this.places.set(at, 4 * i);
    const yaw = motion.yawAt(t);
    if (yaw !== null) { this.places[4 * i + 3] = yaw; return; }
    if (motion.knots) motion.knots.evaluate(t, 1, at); else if (motion.velocity) motion.vector(motion.velocity, t).toArray(at);
    if (Math.hypot(at[0], at[1]) > 0.1) this.places[4 * i + 3] = Math.atan2(at[1], at[0]);
  }

  // `value(motion)`, NaN where it is not known, in `range`; null: the colours of missions.
  colourBy(value, range) {
    this.motions.forEach((motion, i) => {
      const v = value ? value(motion) : motion.mission.index % missionColours + 0.5;
      this.looks[3 * i] = Number.isFinite(v) ? v : unknownValue;
    });
    setScale(this.material.uniforms, value ? range : null);
    this.ways.colourBy(value && (line => value(line.motion)), range);
  }

  // The vehicle under a point of the picture, of those in the air first.
  at(x, y, camera, width, height) {
    let best = 12, hit = null;
    const p = new THREE.Vector3();
    this.motions.forEach((motion, i) => {
      p.fromArray(this.places, 4 * i).project(camera);
      if (p.z >= 1) return;
      const away = Math.hypot((p.x + 1) / 2 * width - x, (1 - p.y) / 2 * height - y) + (this.looks[3 * i + 1] ? 0 : 4);
      if (away < best) { best = away; hit = motion; }
    });
    return hit;
  }

  state() { return { flights: this.motions.length, airborne: this.airborne, trail: this.trail }; }
}
