// Many boxes in levels: from afar few blocks stand for them, tile by tile, and near the camera they are drawn themselves.
// Blocks hold every box (geom/map/far_blocks.h), so nothing that could be hit is left out at any level.

const blockPixels = 2.2;  // a block's cell is no larger in the picture
const boxItself = -1, unseen = -2;  // levels of a tile, beside those of blocks

class BoxLevels {
  constructor(map) {
    this.step = map.step;
    this.tiles = arrayOf(map.tiles);
    this.count = this.tiles.length - 1;
    this.far = map.far.map(level => ({ cell: level.cell, first: arrayOf(level.first), reference: level }));
    this.bounds = this.boundsOf(this.blocks(this.far.length - 1));
    this.chosen = new Int8Array(this.count).fill(unseen);
    this.frustum = new THREE.Frustum();
    this.turn = new THREE.Matrix4();
  }

  // Blocks of a level, unpacked when they are first drawn.
  blocks(level) {
    const far = this.far[level];
    if (!far.corners) {
      const [of, building, traits] = columnsOf(far.reference.look);
      Object.assign(far, { corners: cornersOf(far.reference.corners, this.step), of, building, traits });
    }
    return far;
  }

  boundsOf({ corners, first }) {
    return Array.from({ length: this.count }, (_, t) => {
      const box = new THREE.Box3();
      for (let i = first[t]; i < first[t + 1]; ++i) {
        box.expandByPoint(new THREE.Vector3().fromArray(corners, 6 * i)).expandByPoint(new THREE.Vector3().fromArray(corners, 6 * i + 3));
      }
      return box;
    });
  }

  // Whether other levels are seen from here than before. `perPixel`: how much of the view, one metre away, a pixel is.
  look(camera, perPixel) {
    this.frustum.setFromMatrix(this.turn.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    let changed = false;
    this.bounds.forEach((box, t) => {
      const level = this.frustum.intersectsBox(box) ? this.levelFor(box.distanceToPoint(camera.position) * perPixel * blockPixels) : unseen;
      changed = changed || level !== this.chosen[t];
      this.chosen[t] = level;
    });
    return changed;
  }

  // The coarsest whose cell is not larger than `size`, in metres.
  levelFor(size) {
    let level = boxItself;
    while (level + 1 < this.far.length && this.far[level + 1].cell <= size) ++level;
    return level;
  }

  // Stretches [from, to) of the boxes themselves that are seen.
  nearStretches() {
    const out = [];
    this.chosen.forEach((level, t) => { if (level === boxItself) out.push([this.tiles[t], this.tiles[t + 1]]); });
    return out;
  }

  // The same of the blocks: [[blocks of the level, from, to], …].
  farStretches() {
    const out = [];
    this.chosen.forEach((level, t) => {
      if (level >= 0) out.push([this.blocks(level), this.far[level].first[t], this.far[level].first[t + 1]]);
    });
    return out;
  }
}

const faceCorners = [1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1];
const faceNormals = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].flatMap(n => [n, n, n, n].flat());
const faceIndices = [0, 4, 8].flatMap(k => [k, k + 1, k + 2, k, k + 2, k + 3]);

// Boxes as instances: { corners, numbers (building and covered walls), tints }.
function instancedBoxes({ corners, numbers, tints }) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(faceCorners, 3));
  geometry.setAttribute("normal", new THREE.Float32BufferAttribute(faceNormals, 3));
  geometry.setIndex(faceIndices);
  const both = new THREE.InstancedInterleavedBuffer(corners, 6);
  geometry.setAttribute("low", new THREE.InterleavedBufferAttribute(both, 3, 0));
  geometry.setAttribute("high", new THREE.InterleavedBufferAttribute(both, 3, 3));
  geometry.setAttribute("tint", new THREE.InstancedBufferAttribute(tints, 3, true, tints.length > 3 ? 1 : Math.max(corners.length / 6, 1)));
  geometry.setAttribute("building", new THREE.InstancedBufferAttribute(numbers, 4, true));
  geometry.maxInstancedCount = corners.length / 6;
  return geometry;
}

// The same as plain corners, which software draws several times as fast.
function plainBoxes({ corners, numbers, tints }) {
  const count = corners.length / 6, geometry = new THREE.BufferGeometry(), indices = new Uint32Array(18 * count);
  const parts = { position: new Uint8Array(36 * count), normal: new Uint8Array(36 * count), low: new Float32Array(36 * count),
    high: new Float32Array(36 * count), tint: new Uint8Array(36 * count), building: new Uint8Array(48 * count) };
  for (let i = 0; i < count; ++i) {
    parts.position.set(faceCorners, 36 * i);
    parts.normal.set(faceNormals, 36 * i);
    for (let v = 12 * i; v < 12 * i + 12; ++v) {
      for (let k = 0; k < 3; ++k) {
        parts.low[3 * v + k] = corners[6 * i + k];
        parts.high[3 * v + k] = corners[6 * i + 3 + k];
        parts.tint[3 * v + k] = tints.length > 3 ? tints[3 * i + k] : 0;
        parts.building[4 * v + k] = numbers[4 * i + k];
      }
      parts.building[4 * v + 3] = numbers[4 * i + 3];
    }
    for (let k = 0; k < 18; ++k) indices[18 * i + k] = 12 * i + faceIndices[k];
  }
  for (const name of ["position", "normal", "low", "high"]) geometry.setAttribute(name, new THREE.BufferAttribute(parts[name], 3));
  geometry.setAttribute("tint", new THREE.BufferAttribute(parts.tint, 3, true));
  geometry.setAttribute("building", new THREE.BufferAttribute(parts.building, 4, true));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  return geometry;
}
