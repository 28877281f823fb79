// The floor of the map: a plane with a grid of 10 m and 100 m, and the edge of the bounds.

const groundVertex = `
varying vec2 vAt; varying float vAway;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  vAt = world.xy;
  vec4 eye = viewMatrix * world;
  vAway = -eye.z;
  gl_Position = projectionMatrix * eye;
}`;

const groundFragment = `
uniform vec3 ground; uniform vec3 grid; uniform vec3 sky; uniform vec2 origin; uniform vec2 low; uniform vec2 high; uniform float reach;
varying vec2 vAt; varying float vAway;
float lines(vec2 at, float step) {
  vec2 w = fwidth(at) / step;
  vec2 away = abs(fract(at / step - 0.5) - 0.5) / max(w, vec2(1e-6));
  vec2 seen = (1.0 - smoothstep(0.2, 1.0, away)) * clamp(0.12 / max(w, vec2(1e-6)) - 0.6, 0.0, 1.0);
  return max(seen.x, seen.y);
}
void main() {
  vec2 at = vAt + origin;
  vec2 both = step(low, vAt) * step(vAt, high);
  float inside = both.x * both.y;
  float line = max(0.28 * lines(at, 10.0), 0.6 * lines(at, 100.0)) * mix(0.35, 1.0, inside);
  vec3 floor = mix(mix(sky, ground, 0.3), ground, inside);
  float haze = clamp((vAway - reach) / (2.0 * reach), 0.0, 1.0);
  gl_FragColor = vec4(mix(mix(floor, grid, line), sky, haze), 1.0);
}`;

class Ground {
  constructor() {
    const [low, high] = [meta.min, meta.max].map(p => p.map((x, i) => x - origin[i]));
    const size = Math.max(high[0] - low[0], high[1] - low[1], 20) * 8;
    const material = new THREE.ShaderMaterial({
      vertexShader: groundVertex, fragmentShader: groundFragment, depthWrite: true,
      polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 4,
      uniforms: { ground: { value: new THREE.Color() }, grid: { value: new THREE.Color() },
        sky: { value: new THREE.Color() }, reach: { value: 1e9 },
        origin: { value: new THREE.Vector2(origin[0], origin[1]) },
        low: { value: new THREE.Vector2(low[0], low[1]) }, high: { value: new THREE.Vector2(high[0], high[1]) } } });
    material.extensions.derivatives = true;
    this.mesh = new THREE.Mesh(new THREE.PlaneBufferGeometry(size, size), material);
    this.mesh.position.set((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]);
    this.height = low[2];
    theme.follow(() => {
      for (const name of ["ground", "grid", "sky"]) material.uniforms[name].value.copy(theme.colour(name));
    });
  }
  setHaze(reach) { this.mesh.material.uniforms.reach.value = reach; }
}
