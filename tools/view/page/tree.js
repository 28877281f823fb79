// A search tree that grows in the order its nodes were put in; once whole, as it was left.

class SearchTree {
  constructor(data) {
    this.data = data;
    this.count = data.nodes;
    this.which = arrayOf(data.tree);
    this.shown = this.count;
    const points = new THREE.BufferAttribute(arrayOf(data.points), 3);
    this.colours = new THREE.BufferAttribute(new Uint8Array(this.count * 3), 3, true);
    this.grown = this.lines(points, arrayOf(data.first_parent));
    this.left = this.lines(points, arrayOf(data.parent));
    this.object = new THREE.Group();
    this.object.add(this.grown, this.left);
    theme.follow(() => this.recolour());
    this.show(this.count);
  }

  // An edge a node, from its parent; that of a root has no length.
  lines(points, parent) {
    const ends = new Uint32Array(this.count * 2);
    for (let i = 0; i < this.count; ++i) {
      ends[2 * i] = parent[i];
      ends[2 * i + 1] = i;
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", points);
    geometry.setAttribute("color", this.colours);
    geometry.setIndex(new THREE.BufferAttribute(ends, 1));
    const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial(
      { vertexColors: THREE.VertexColors, transparent: true, opacity: Math.min(Math.max(1600 / this.count, 0.3), 0.85) }));
    lines.frustumCulled = false;
    lines.renderOrder = 2;
    return lines;
  }

  recolour() {
    const colours = ["tree-0", "tree-1"].map(name => theme.colour(name));
    for (let i = 0; i < this.count; ++i) {
      const c = colours[this.which[i]];
      this.colours.array.set([c.r * 255, c.g * 255, c.b * 255], i * 3);
    }
    this.colours.needsUpdate = true;
  }

  show(nodes) {
    this.shown = Math.round(Math.min(Math.max(nodes, 0), this.count));
    const whole = this.shown === this.count;
    this.left.visible = whole;
    this.grown.visible = !whole;
    this.grown.geometry.setDrawRange(0, 2 * this.shown);
  }

  goalTree() { return this.which.includes(1); }
}
