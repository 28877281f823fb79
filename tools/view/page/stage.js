// The scene and its picture: drawn only when something changed.

class Stage {
  constructor() {
    this.scene = new THREE.Scene();
    this.view = new View();
    this.parts = { paths: [], trees: [], lattices: [], ribbons: [], vehicles: [], markers: [] };
    this.selected = motions.length ? 0 : -1;
    this.due = true;
    this.frames = 0;
    this.frameMs = 0;
    this.surface = byId("view");
    this.renderer = this.makeRenderer();
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 0.75));
    const sun = new THREE.DirectionalLight(0xffffff, 0.55);
    sun.position.set(-0.45, -0.3, 0.84);
    this.scene.add(sun);
    this.fill();
    new ResizeObserver(() => this.redraw()).observe(this.surface);
    theme.follow(() => {
      this.scene.background = theme.colour("sky");
      this.redraw();
    });
    this.listen();
  }

  makeRenderer() {
    try {
      const renderer = new THREE.WebGLRenderer({ antialias: true, powerPreference: "high-performance" });
      renderer.info.autoReset = true;
      this.surface.append(renderer.domElement);
      renderer.domElement.setAttribute("aria-hidden", "true");
      return renderer;
    } catch (error) {
      tellProblem("This browser cannot draw in three dimensions (WebGL is off); plots and numbers are here all the same.");
      return null;
    }
  }

  add(object) { this.scene.add(object); return object; }

  fill() {
    const { parts } = this;
    this.ground = new Ground();
    this.add(this.ground.mesh);
    if (meta.map) {
      this.boxes = new Boxes(meta.map);
      this.picked = new PickedBox(this.boxes);
      this.add(this.boxes.mesh);
      this.add(this.picked.object);
    }
    parts.lattices = meta.lattices.map(data => new LatticeLevel(data));
    parts.trees = meta.trees.map(data => new SearchTree(data));
    parts.corridors = meta.corridors.filter(data => data.pieces).map(data => new Corridor(data));
    for (const part of [...parts.lattices, ...parts.trees, ...parts.corridors]) this.add(part.object);
    this.pathGroup = this.add(new THREE.Group());
    for (const data of meta.paths) this.addPath(data);
    this.motionGroup = this.add(new THREE.Group());
    for (const motion of motions) this.addMotion(motion);
    this.checkGroup = this.add(new THREE.Group());
    for (const check of meta.reports) {
      if (!check.ok && check.place) this.addMarker(this.checkGroup, check.place, "failed", "bad", 26);
    }
  }

  addMarker(group, point, shape, colour, pixels) {
    const marker = new Marker(point, shape, colour, pixels);
    this.parts.markers.push(marker);
    group.add(marker.object);
  }

  addPath(data) {
    const points = arrayOf(data.points);
    if (!points) return;
    if (points.length >= 6) {
      const ribbon = new Ribbon(points, "path", 2);
      this.parts.paths.push(ribbon);
      this.pathGroup.add(ribbon.object);
    }
    if (meta.paths.length <= 50) {
      this.addMarker(this.pathGroup, points.subarray(0, 3), "start", "path", 15);
      this.addMarker(this.pathGroup, points.subarray(points.length - 3), "goal", "path", 15);
    }
  }

  addMotion(motion) {
    const colour = motion.isFlight ? "flown" : "motion";
    if (motion.samples >= 2) {
      const ribbon = new Ribbon(motion.position, colour, 3);
      ribbon.motion = motion;
      this.parts.ribbons.push(ribbon);
      this.motionGroup.add(ribbon.object);
    }
    const vehicle = new Vehicle(motion);
    this.parts.vehicles.push(vehicle);
    this.motionGroup.add(vehicle.object);
  }

  motion() { return motions[this.selected] || null; }

  redraw() { this.due = true; }

  // Metres of the scene that a pixel at the target is.
  metresPerPixel() {
    return this.view.orbit.distance * this.view.perPixel(Math.max(this.surface.clientHeight, 1));
  }

  // The ray through a point of the surface.
  ray(x, y) {
    const caster = new THREE.Raycaster();
    caster.setFromCamera({ x: 2 * x / this.surface.clientWidth - 1, y: 1 - 2 * y / this.surface.clientHeight },
      this.view.camera);
    return caster.ray;
  }

  listen() {
    const { orbit } = this.view;
    const free = () => this.view.mode === "free" || this.view.mode === "top";
    listenToPointers(this.surface, {
      turn: (dx, dy) => {
        if (this.view.mode === "top") return this.drag(dx, dy);
        orbit.turn(dx * 0.006, dy * 0.006);
        this.redraw();
      },
      move: (dx, dy) => this.drag(dx, dy),
      zoom: (factor, x, y) => {
        if (free()) this.zoomTowards(factor, x, y); else orbit.zoom(factor);
        this.redraw();
      },
      click: (x, y) => this.pick(x, y),
    });
  }

  drag(dx, dy) {
    const scale = this.metresPerPixel();
    const steep = Math.max(Math.sin(Math.abs(this.view.orbit.elevation)), 0.25);
    this.view.orbit.move(-dx * scale, dy * scale / steep);
    this.redraw();
  }

  // Zooms so that the ground under the pointer stays there.
  zoomTowards(factor, x, y) {
    const { orbit } = this.view;
    const ray = this.ray(x, y);
    const away = (this.ground.height - ray.origin.z) / ray.direction.z;
    const before = orbit.distance;
    orbit.zoom(factor);
    if (!(away > 0) || away > before * 4) return;
    const share = 1 - orbit.distance / before;
    orbit.target.x += (ray.origin.x + ray.direction.x * away - orbit.target.x) * share;
    orbit.target.y += (ray.origin.y + ray.direction.y * away - orbit.target.y) * share;
  }

  pick(x, y) {
    if (!this.picked) return;
    const ray = this.ray(x, y);
    this.picked.choose(this.boxes.mesh.visible ? pickBox(this.boxes.corners, ray.origin, ray.direction) : null);
    this.redraw();
  }

  goTo(point, distance) {
    this.view.set("free");
    this.view.orbit.target.fromArray(point);
    this.view.orbit.distance = distance;
    this.view.orbit.elevation = 0.75;
    this.redraw();
  }

  draw() {
    if (!this.due || !this.renderer) return;
    this.due = false;
    const begin = performance.now();
    const width = this.surface.clientWidth, height = this.surface.clientHeight;
    if (!width || !height) return;
    this.fit(width, height);
    this.view.track(this.motion(), clock.time);
    this.view.apply(width, height);
    const perPixel = this.view.perPixel(height);
    for (const marker of this.parts.markers) marker.resize(perPixel);
    for (const vehicle of this.parts.vehicles) vehicle.update(clock.time, this.view.camera.position, perPixel);
    const reach = this.view.orbit.distance + this.view.extent().across * 0.6;
    if (this.boxes) {
      this.boxes.setHaze(reach);
      this.cutAway(width, height);
    }
    this.ground.setHaze(reach);
    this.renderer.render(this.scene, this.view.camera);
    this.frames += 1;
    this.frameMs = performance.now() - begin;
    showCompass(this.view.orbit.heading);
    showScale(this.metresPerPixel());
  }

  // Opens the view onto the followed vehicle where boxes stand before it.
  cutAway(width, height) {
    const { camera, orbit, mode } = this.view;
    if (mode !== "follow" && mode !== "ride") return this.boxes.setHole(0, 0, 0, 0);
    const along = orbit.target.clone().sub(camera.position).normalize();
    const hidden = pickBox(this.boxes.corners, camera.position, along, orbit.distance * 0.97) !== null;
    if (!hidden) return this.boxes.setHole(0, 0, 0, 0);
    const at = orbit.target.clone().project(camera);
    const half = (v, size) => (v + 1) / 2 * size * this.ratio;
    this.boxes.setHole(half(at.x, width), half(at.y, height), orbit.distance * 0.97, 0.15 * height * this.ratio);
  }

  fit(width, height) {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    if (this.width === width && this.height === height && this.ratio === ratio) return;
    Object.assign(this, { width, height, ratio });
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    stagePixels.set(width, height);
  }
}

function showCompass(heading) {
  const compass = byId("compass");
  if (!compass.firstChild) {
    compass.innerHTML = '<svg viewBox="-22 -22 44 44" width="44" height="44"><circle r="20" fill="var(--panel)" ' +
      'stroke="var(--line)"/><g><path d="M0-13 4 0-4 0Z" fill="var(--bad)"/><path d="M0 13 4 0-4 0Z" fill="var(--soft)"/>' +
      '</g><text y="3.5" text-anchor="middle" font-size="0"></text></svg>';
  }
  compass.querySelector("g").setAttribute("transform", `rotate(${(-heading * 180 / Math.PI).toFixed(1)})`);
  const degree = ((heading * 180 / Math.PI) % 360 + 360) % 360;
  compass.setAttribute("aria-label", `Compass: looking towards ${decimals(degree, 0)} degrees from north`);
}

function showScale(perPixel) {
  const round = roundDown(perPixel * 120);
  const bar = byId("scale");
  const text = withUnit(round, round < 1 ? 2 : 0, "m");
  bar.style.width = `${round / perPixel}px`;
  if (!bar.firstChild) bar.append(element("span"));
  bar.firstChild.textContent = text;
  bar.setAttribute("aria-label", `Scale at the middle of the view: ${text}`);
}
