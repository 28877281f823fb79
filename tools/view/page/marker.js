// Signs of one size on the screen: where a path starts and ends, what a vehicle is above,
// where a way home ends, where a check failed.

const markerShapes = {
  start(c, colour) { ring(c, colour, false); },
  goal(c, colour) { ring(c, colour, true); },
  foot(c, colour) { ring(c, colour, false); },
  site(c, colour) {
    disc(c, colour);
    c.fillStyle = theme.css("panel");
    c.font = "bold 34px sans-serif";
    c.textAlign = "center";
    c.textBaseline = "middle";
    c.fillText("H", 32, 34);
  },
  failed(c, colour) {
    disc(c, colour);
    c.strokeStyle = theme.css("panel");
    c.lineWidth = 7;
    c.lineCap = "round";
    c.beginPath();
    c.moveTo(22, 22); c.lineTo(42, 42); c.moveTo(42, 22); c.lineTo(22, 42);
    c.stroke();
  },
};

function disc(c, colour) {
  c.fillStyle = theme.css("panel");
  c.beginPath(); c.arc(32, 32, 29, 0, 7); c.fill();
  c.fillStyle = colour;
  c.beginPath(); c.arc(32, 32, 24, 0, 7); c.fill();
}

function ring(c, colour, filled) {
  disc(c, colour);
  if (filled) return;
  c.fillStyle = theme.css("panel");
  c.beginPath(); c.arc(32, 32, 13, 0, 7); c.fill();
}

class Marker {
  // At `point` [x, y, z]; `pixels` across.
  constructor(point, shape, colour, pixels) {
    const canvas = element("canvas", { width: 64, height: 64 });
    const texture = new THREE.CanvasTexture(canvas);
    this.pixels = pixels;
    this.object = new THREE.Sprite(new THREE.SpriteMaterial(
      { map: texture, sizeAttenuation: false, depthTest: false, transparent: true }));
    this.object.position.fromArray(point);
    this.object.renderOrder = 8;
    theme.follow(() => {
      const c = canvas.getContext("2d");
      c.clearRect(0, 0, 64, 64);
      markerShapes[shape](c, theme.css(colour));
      texture.needsUpdate = true;
    });
  }
  // `perPixel`: how much of the view, one metre away, a pixel is.
  resize(perPixel) { this.object.scale.setScalar(this.pixels * perPixel); }
}
