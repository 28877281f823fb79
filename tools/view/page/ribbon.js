// Lines of a width in pixels, in one colour or by a value along them; what is hidden shines through.

const ribbonVertex = `
attribute vec3 from; attribute vec3 to; attribute float valueFrom; attribute float valueTo;
uniform vec2 pixels; uniform float width; uniform float nearest;
varying float vValue;
void main() {
  vec4 a = modelViewMatrix * vec4(from, 1.0);
  vec4 b = modelViewMatrix * vec4(to, 1.0);
  if (a.z > -nearest && b.z < -nearest) a = mix(a, b, (a.z + nearest) / (a.z - b.z));
  else if (b.z > -nearest && a.z < -nearest) b = mix(b, a, (b.z + nearest) / (b.z - a.z));
  vec4 p = projectionMatrix * a;
  vec4 q = projectionMatrix * b;
  vec2 along = (q.xy / q.w - p.xy / p.w) * pixels;
  float size = length(along);
  along = size > 1e-4 ? along / size : vec2(1.0, 0.0);
  vec2 shift = (vec2(-along.y, along.x) * position.y + along * (position.x - 0.5) * 0.8) * width / pixels;
  vec4 at = position.x < 0.5 ? p : q;
  vValue = mix(valueFrom, valueTo, position.x);
  gl_Position = at + vec4(shift * at.w, 0.0, 0.0);
}`;

const ribbonFragment = `
uniform vec3 colour; uniform sampler2D ramp; uniform float byValue; uniform float low; uniform float span; uniform float opacity;
varying float vValue;
void main() {
  vec3 scaled = texture2D(ramp, vec2(clamp((vValue - low) / span, 0.002, 0.998), 0.5)).rgb;
  gl_FragColor = vec4(mix(colour, scaled, byValue), opacity);
}`;

const valueRamp = rampTexture(valueStops);

class Ribbon {
  // `points`: x, y, z after one another, of at least two points; `colour` names one of the theme.
  constructor(points, colour, width) {
    this.points = points;
    this.colour = colour;
    this.object = new THREE.Group();
    const geometry = this.geometry();
    this.materials = [1, 0.28].map(opacity => this.material(opacity, width));
    this.materials.forEach((material, i) => {
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = i ? 4 : 5;  // first what shines through, then what is seen
      this.object.add(mesh);
    });
    theme.follow(() => {
      for (const m of this.materials) m.uniforms.colour.value.copy(theme.colour(this.colour));
    });
  }

  geometry() {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(
      new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const n = this.points.length / 3;
    // Both ends of segment i from the same array, one point apart.
    const ends = new THREE.InstancedInterleavedBuffer(this.points, 3);
    geometry.setAttribute("from", new THREE.InterleavedBufferAttribute(ends, 3, 0));
    geometry.setAttribute("to", new THREE.InterleavedBufferAttribute(ends, 3, 3));
    this.values = new THREE.InstancedInterleavedBuffer(new Float32Array(n), 1);
    geometry.setAttribute("valueFrom", new THREE.InterleavedBufferAttribute(this.values, 1, 0));
    geometry.setAttribute("valueTo", new THREE.InterleavedBufferAttribute(this.values, 1, 1));
    geometry.maxInstancedCount = Math.max(n - 1, 0);
    return geometry;
  }

  material(opacity, width) {
    return new THREE.ShaderMaterial({
      vertexShader: ribbonVertex, fragmentShader: ribbonFragment, side: THREE.DoubleSide,
      transparent: true, depthTest: opacity === 1, depthWrite: false,
      uniforms: { pixels: { value: stagePixels }, width: { value: width }, nearest: { value: 0.05 },
        colour: { value: new THREE.Color() }, ramp: { value: valueRamp }, byValue: { value: 0 },
        low: { value: 0 }, span: { value: 1 }, opacity: { value: opacity } } });
  }

  // A value a point, from low to high of the scale; null for one colour.
  colourBy(values, low, high) {
    if (values) {
      this.values.array.set(values);
      this.values.needsUpdate = true;
    }
    for (const m of this.materials) {
      m.uniforms.byValue.value = values ? 1 : 0;
      m.uniforms.low.value = low || 0;
      m.uniforms.span.value = Math.max((high || 0) - (low || 0), 1e-9);
    }
  }
}

// Size of the picture in pixels, shared by all ribbons.
const stagePixels = new THREE.Vector2(1, 1);
