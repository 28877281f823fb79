// The bounds of the map as faint walls and edges, seen from inside, where somebody set them.

class Room {
  constructor() {
    const [low, high] = [meta.min, meta.max].map(p => p.map((x, i) => x - origin[i]));
    const box = new THREE.BoxBufferGeometry(...[0, 1, 2].map(k => Math.max(high[k] - low[k], 1e-3)));
    this.walls = new THREE.Mesh(box, new THREE.MeshBasicMaterial(
      { transparent: true, side: THREE.BackSide, depthWrite: false }));
    this.edges = new THREE.LineSegments(new THREE.EdgesGeometry(box), new THREE.LineBasicMaterial({ transparent: true }));
    this.object = new THREE.Group();
    for (const part of [this.walls, this.edges]) {
      part.renderOrder = 1;
      part.position.set(...[0, 1, 2].map(k => (low[k] + high[k]) / 2));
      this.object.add(part);
    }
    theme.follow(() => {
      for (const part of [this.walls, this.edges]) part.material.color.copy(theme.colour("wall"));
      this.walls.material.opacity = theme.current() === "dark" ? 0.12 : 0.1;
      this.edges.material.opacity = 0.55;
    });
  }
}

// Bounds that only surround the obstacles are no walls.
function hasWalls() { return Boolean(meta.map && meta.map.bounds_from && meta.map.bounds_from !== "obstacles"); }
