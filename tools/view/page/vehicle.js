// A quadrotor where a motion is, with a line to the floor; drawn larger than it is where it would be too small to see,
// and through walls.

const vehiclePixels = 36;  // at least, from tip to tip

function merged(parts) {
  const positions = [], normals = [];
  for (const part of parts) {
    const flat = part.toNonIndexed();
    positions.push(...flat.attributes.position.array);
    normals.push(...flat.attributes.normal.array);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new THREE.Float32BufferAttribute(normals, 3));
  return geometry;
}

// About 1 from the middle to a rotor's outer edge: x ahead, z up. `sides` of a rotor.
function quadrotor(sides) {
  const parts = [new THREE.BoxBufferGeometry(0.62, 0.3, 0.18)];
  const nose = new THREE.ConeBufferGeometry(0.12, 0.3, 12);
  nose.rotateZ(-Math.PI / 2);
  nose.translate(0.45, 0, 0);
  parts.push(nose);
  for (const turn of [1, 3, 5, 7]) {
    const angle = turn * Math.PI / 4;
    const arm = new THREE.BoxBufferGeometry(0.7, 0.07, 0.06);
    arm.translate(0.35, 0, 0);
    arm.rotateZ(angle);
    const rotor = new THREE.CylinderBufferGeometry(0.33, 0.33, 0.03, sides);
    rotor.rotateX(Math.PI / 2);
    rotor.translate(0.68 * Math.cos(angle), 0.68 * Math.sin(angle), 0.1);
    parts.push(arm, rotor);
  }
  return merged(parts);
}

const vehicleShape = quadrotor(28);

class Vehicle {
  // Over the floor of the map, in metres.
  constructor(motion, floor) {
    this.motion = motion;
    this.colour = manyMissions ? motion.mission.colour : "vehicle";
    const half = motion.data.vehicle ? motion.data.vehicle.half : [0.25, 0.25, 0.1];
    this.radius = Math.max(half[0], half[1], 0.05);
    this.seen = new THREE.MeshLambertMaterial();
    this.hidden = new THREE.MeshLambertMaterial({ transparent: true, opacity: 0.5, depthTest: false, depthWrite: false });
    this.body = new THREE.Group();
    this.body.add(this.part(this.hidden, 5.5), this.part(this.seen, 6));
    this.drop = new DropLine(this.colour, floor);
    this.object = new THREE.Group();
    this.object.add(this.body, this.drop.object);
    theme.follow(() => this.recolour());
  }

  // The whole is drawn twice: faintly through what hides it, then where it is seen.
  part(material, order) {
    const mesh = new THREE.Mesh(vehicleShape, material);
    mesh.renderOrder = order;
    return mesh;
  }

  recolour() {
    for (const material of [this.seen, this.hidden]) {
      material.color.copy(theme.colour(this.colour));
      material.emissive.copy(theme.colour(this.colour)).multiplyScalar(manyMissions ? 0.1 : 0.3);
    }
  }

  update(time, eye, perPixel) {
    const t = this.motion.local(time);
    this.motion.place(time, this.body.position);
    this.motion.orientation(t, this.body.quaternion);
    const seen = this.body.position.distanceTo(eye) * perPixel * vehiclePixels / 2;
    this.enlarged = seen > this.radius;
    this.body.scale.setScalar(Math.max(this.radius, seen));
    if (this.drop.object.visible) this.drop.hang(this.body.position, perPixel);
  }
}
