// Lines of a width in pixels with a thin casing, plain or broken, in one colour or by a value along them; what is
// hidden shines through.

const ribbonVertex = `
attribute vec3 from; attribute vec3 to; attribute float valueFrom; attribute float valueTo; attribute float alongFrom; attribute float alongTo;
uniform vec2 pixels; uniform float width; uniform float casing; uniform float nearest;
varying float vValue; varying float vAlong; varying vec2 vAcross;
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
  vec2 shift = (vec2(-along.y, along.x) * position.y + along * (position.x - 0.5) * 0.8) * (width + 2.0 * casing) / pixels;
  vec4 at = position.x < 0.5 ? p : q;
  vValue = mix(valueFrom, valueTo, position.x);
  vAlong = mix(alongFrom, alongTo, position.x);
  vAcross = vec2(position.y, 1.0) * at.w;  // linear on the screen once divided
  gl_Position = at + vec4(shift * at.w, 0.0, 0.0);
}`;

const ribbonFragment = `
uniform vec3 colour; uniform vec3 around; uniform sampler2D ramp; uniform float byValue; uniform float low; uniform float span;
uniform float opacity; uniform float width; uniform float casing; uniform float pattern; uniform float period;
varying float vValue; varying float vAlong; varying vec2 vAcross;
bool gap(float at) {
  if (pattern < 0.5) return false;
  if (pattern < 1.5) return at > 0.62;
  if (pattern < 2.5) return mod(2.0 * at, 1.0) > 0.5;
  return (at > 0.5 && at < 0.67) || at > 0.84;
}
void main() {
  if (gap(fract(vAlong / period))) discard;
  vec3 scaled = texture2D(ramp, vec2(clamp((vValue - low) / span, 0.002, 0.998), 0.5)).rgb;
  bool inside = abs(vAcross.x / vAcross.y) * (width + 2.0 * casing) <= width;
  gl_FragColor = vec4(inside ? mix(colour, scaled, byValue) : around, opacity);
}`;

const valueRamp = rampTexture(valueStops);

let ribbonsMade = 0;

class Ribbon {
  // `points`: x, y, z after one another, of at least two points. `style`: { colour, width, pattern, towards, share }:
  // `colour` names one of the theme, which is mixed with a `share` of the one that `towards` names.
  constructor(points, style) {
    this.points = points;
    this.style = { pattern: 0, share: 0, towards: "ink", ...style };
    this.object = new THREE.Group();
    this.mark = 1 + ribbonsMade++ % 255;
    const geometry = this.geometry();
    this.materials = [this.material(1), this.through()];
    this.materials.forEach((material, i) => {
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = i ? 4 : 5;  // first what shines through, then what is seen
      this.object.add(mesh);
    });
    this.setWidth(this.style.width);
    theme.follow(() => this.recolour());
  }

  recolour() {
    const { colour, towards, share } = this.style;
    for (const { uniforms } of this.materials) {
      uniforms.colour.value.copy(theme.colour(colour)).lerp(theme.colour(towards), share);
      uniforms.around.value.copy(theme.colour("casing"));
    }
  }

  setWidth(width) {
    for (const { uniforms } of this.materials) {
      uniforms.width.value = width;
      uniforms.casing.value = width >= 2 ? 1 : 0;
    }
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
    const lengths = new THREE.InstancedInterleavedBuffer(this.lengths(), 1);
    geometry.setAttribute("alongFrom", new THREE.InterleavedBufferAttribute(lengths, 1, 0));
    geometry.setAttribute("alongTo", new THREE.InterleavedBufferAttribute(lengths, 1, 1));
    geometry.maxInstancedCount = Math.max(n - 1, 0);
    this.ends = ends;
    this.along = lengths;
    return geometry;
  }

  // How far each point is from the first, along the line.
  lengths() {
    const p = this.points, out = new Float32Array(p.length / 3);
    for (let i = 1; i < out.length; ++i) {
      out[i] = out[i - 1] + Math.hypot(p[3 * i] - p[3 * i - 3], p[3 * i + 1] - p[3 * i - 2], p[3 * i + 2] - p[3 * i - 1]);
    }
    return out;
  }

  // To be called after `points` were changed in place.
  moved() {
    this.along.array.set(this.lengths());
    this.ends.needsUpdate = this.along.needsUpdate = true;
  }

  // Faint, whatever stands before it; each pixel once, however many segments meet there.
  through() {
    const material = this.material(0.38);
    material.depthTest = false;
    material.stencilWrite = true;
    material.stencilRef = this.mark;
    material.stencilFunc = THREE.NotEqualStencilFunc;
    material.stencilZPass = THREE.ReplaceStencilOp;
    return material;
  }

  material(opacity) {
    return new THREE.ShaderMaterial({
      vertexShader: ribbonVertex, fragmentShader: ribbonFragment, side: THREE.DoubleSide,
      transparent: true, depthWrite: false,
      uniforms: { pixels: { value: stagePixels }, width: { value: 1 }, casing: { value: 0 }, nearest: { value: 0.05 },
        pattern: { value: this.style.pattern }, period: patternPeriod,
        colour: { value: new THREE.Color() }, around: { value: new THREE.Color() }, ramp: { value: valueRamp }, byValue: { value: 0 },
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

// Size of the picture in pixels, and how long a period of a broken line is in metres; shared by all ribbons.
const stagePixels = new THREE.Vector2(1, 1);
const patternPeriod = { value: 1 };
