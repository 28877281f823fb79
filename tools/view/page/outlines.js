// Which building each pixel shows, drawn before the picture: where neighbouring pixels differ runs an outline.

const outlineFragment = `
varying vec3 vNormal; varying vec3 vBuilding; varying float vAway; varying float vZone;
uniform vec3 focus; uniform float hole;
${cutAwayShader}
void main() {
  if (hole > 0.0) cutAway();
  if (vZone > 0.5) discard;
  gl_FragColor = vec4(vBuilding, abs(vNormal.z) > 0.5 ? 1.0 : 0.5);
}`;

class Outlines {
  constructor(boxes) {
    // With a stencil, because without one depths would have 16 bits, too few for neighbours.
    this.target = new THREE.WebGLRenderTarget(4, 4, { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
      stencilBuffer: true, generateMipmaps: false });
    const { uniforms } = boxes;
    uniforms.shown.value = this.target.texture;
    this.pixel = uniforms.pixel.value;
    const material = new THREE.ShaderMaterial({ vertexShader: boxVertex, fragmentShader: outlineFragment, side: THREE.DoubleSide,
      blending: THREE.NoBlending, uniforms });
    this.scene = new THREE.Scene();
    this.pairs = boxes.parts.map(part => [part, new THREE.Mesh(part.geometry, material)]);
    for (const [, mesh] of this.pairs) {
      mesh.frustumCulled = false;
      this.scene.add(mesh);
    }
  }

  // In a picture of this size, in pixels of the screen.
  draw(renderer, camera, width, height) {
    for (const [part, mesh] of this.pairs) {
      mesh.geometry = part.geometry;
      mesh.visible = part.visible;
    }
    this.target.setSize(width, height);
    this.pixel.set(1 / width, 1 / height);
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(this.scene, camera);
    renderer.setRenderTarget(null);
  }
}
