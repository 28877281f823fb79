// The convex regions that a trajectory was optimised in: all of them, or one.

class Corridor {
  constructor(data) {
    this.data = data;
    this.pieces = data.pieces;
    const points = new THREE.BufferAttribute(arrayOf(data.points), 3);
    this.ends = { faces: arrayOf(data.triangle_end), edges: arrayOf(data.edge_end) };
    this.faces = new THREE.Mesh(this.geometry(points, data.triangles), new THREE.MeshBasicMaterial(
      { transparent: true, opacity: 0.07, side: THREE.DoubleSide, depthWrite: false }));
    this.edges = new THREE.LineSegments(this.geometry(points, data.edges),
      new THREE.LineBasicMaterial({ transparent: true, opacity: 0.55 }));
    this.object = new THREE.Group();
    for (const part of [this.faces, this.edges]) {
      part.frustumCulled = false;
      part.renderOrder = 3;
      this.object.add(part);
    }
    theme.follow(() => {
      for (const part of [this.faces, this.edges]) part.material.color.copy(theme.colour("corridor"));
    });
  }

  geometry(points, indices) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", points);
    geometry.setIndex(new THREE.BufferAttribute(arrayOf(indices), 1));
    return geometry;
  }

  // A piece counted from 1; 0: all.
  show(piece) {
    for (const name of ["faces", "edges"]) {
      const ends = this.ends[name], part = this[name];
      const from = piece > 1 ? ends[piece - 2] : 0;
      const to = piece ? ends[piece - 1] : ends[this.pieces - 1];
      part.geometry.setDrawRange(from, to - from);
    }
    this.faces.material.opacity = piece ? 0.16 : 0.05;
  }
}
