// Straight down from a vehicle to the floor of the map, so that its place can be read.

class DropLine {
  constructor(colour, floor) {
    this.floor = floor;
    this.points = new Float32Array(6);
    this.ribbon = new Ribbon(this.points, { colour, width: 2, pattern: 2 });
    this.foot = new Marker([0, 0, 0], "foot", colour, 9);
    this.object = new THREE.Group();
    this.object.add(this.ribbon.object, this.foot.object);
  }

  hang(from, perPixel) {
    this.points.set([from.x, from.y, from.z, from.x, from.y, Math.min(this.floor, from.z)]);
    this.ribbon.moved();
    this.foot.object.position.set(from.x, from.y, this.points[5]);
    this.foot.resize(perPixel);
  }
}
