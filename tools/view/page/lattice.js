// One level of a lattice at a time: its free nodes and the free edges within the level.

const latticeSteps = [[1, 0], [0, 1], null, [1, 1], [1, -1]];  // of bits 1 to 5; bit 3 goes up

class LatticeLevel {
  constructor(data) {
    this.data = data;
    this.mask = arrayOf(data.mask);
    this.levels = data.dims[2];
    this.object = new THREE.Group();
    this.nodes = new THREE.Points(new THREE.BufferGeometry(),
      new THREE.PointsMaterial({ size: 3, sizeAttenuation: false }));
    this.edges = new THREE.LineSegments(new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ transparent: true, opacity: 0.35 }));
    this.object.add(this.nodes, this.edges);
    this.object.visible = false;
    theme.follow(() => {
      for (const part of [this.nodes, this.edges]) part.material.color.copy(theme.colour("lattice"));
    });
    this.show(0);
  }

  heightOf(level) { return this.data.first[2] + origin[2] + level * this.data.spacing; }

  show(level) {
    const { first, spacing, dims } = this.data;
    const nodes = [], edges = [];
    const at = (i, j) => [first[0] + i * spacing, first[1] + j * spacing, first[2] + level * spacing];
    for (let j = 0; j < dims[1]; ++j) {
      for (let i = 0; i < dims[0]; ++i) {
        const mask = this.mask[i + dims[0] * (j + dims[1] * level)];
        if (!(mask & 1)) continue;
        nodes.push(...at(i, j));
        latticeSteps.forEach((step, bit) => {
          if (step && mask >> (bit + 1) & 1) edges.push(...at(i, j), ...at(i + step[0], j + step[1]));
        });
      }
    }
    this.level = level;
    this.replace(this.nodes, nodes);
    this.replace(this.edges, edges);
  }

  replace(part, positions) {
    part.geometry.dispose();
    part.geometry = new THREE.BufferGeometry();
    part.geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
    part.frustumCulled = false;
  }
}
