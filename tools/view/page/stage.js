// The scene and its picture: drawn only when something changed.

const mostDrops = 24, mostAlone = 32;

class Stage {
  constructor() {
    this.scene = new THREE.Scene();
    this.view = new View();
    this.parts = { trees: [], lattices: [], ribbons: [], vehicles: [], markers: [], lines: [] };
    this.stood = new Map();  // what was made of motions that stood out
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
    this.labels = new MissionLabels(this);
    selection.follow(() => this.showChosen());
    this.listen();
  }

  makeRenderer() {
    try {
      const renderer = new THREE.WebGLRenderer({ antialias: true, powerPreference: "high-performance" });
      renderer.info.autoReset = false;  // a picture is drawn in two passes
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
      this.outlines = new Outlines(this.boxes);
      this.picked = new PickedBox(this.boxes);
      this.add(this.boxes.mesh);
      this.add(this.picked.object);
    }
    if (hasWalls()) {
      this.room = new Room();
      this.add(this.room.object);
    }
    parts.lattices = meta.lattices.map(data => new LatticeLevel(data));
    parts.trees = meta.trees.map(data => new SearchTree(data));
    parts.corridors = meta.corridors.filter(data => data.pieces).map(data => new Corridor(data));
    for (const part of [...parts.lattices, ...parts.trees, ...parts.corridors]) this.add(part.object);
    this.pathGroup = this.add(new THREE.Group());
    if (together && meta.paths.length > mostAlone) this.addPaths(); else for (const data of meta.paths) this.addPath(data);
    this.motionGroup = this.add(new THREE.Group());
    if (together) {
      this.fleet = new Fleet(motions);
      this.motionGroup.add(this.fleet.object);
    } else for (const motion of motions) this.addMotion(motion);
    this.tubeGroup = this.add(new THREE.Group());
    parts.tubes = together ? [] : motions.filter(m => m.data.tube).map(m => new Tube(m));
    for (const tube of parts.tubes) this.tubeGroup.add(tube.object);
    if (homes.size) {
      this.homeLines = new HomeLines();
      this.motionGroup.add(this.homeLines.object);
      this.homeWay = new HomeWay(this.ground.height);
      this.add(this.homeWay.object);
    }
    this.pairLine = new PairLine();
    this.add(this.pairLine.object);
    this.checkGroup = this.add(new THREE.Group());
    for (const check of meta.reports) {
      if (check.ok || !check.place) continue;
      this.addFailedLeg(check);
      this.addMarker(this.checkGroup, check.place, "failed", "bad", 26);
    }
  }

  // Of a path, the leg that its check counts.
  addFailedLeg(check) {
    const data = check.checked === "path" && check.time !== undefined && meta.paths.find(p => p.id === check.id && p.points);
    if (!data) return;
    const points = arrayOf(data.points), from = 3 * Math.floor(check.time);
    if (from + 6 > points.length) return;
    this.addLine(this.checkGroup, points.subarray(from, from + 6), missionOfPath.get(data), { colour: "bad", pattern: 0, width: 5 });
  }

  addMarker(group, point, shape, colour, pixels) {
    const marker = new Marker(point, shape, colour, pixels);
    this.parts.markers.push(marker);
    group.add(marker.object);
  }

  addPath(data) {
    const points = arrayOf(data.points);
    if (!points) return;
    const mission = missionOfPath.get(data);
    const style = lineStyle(mission, "path", manyMissions && mission.motions.length ? 1.25 : 2);
    if (points.length >= 6) this.addLine(this.pathGroup, points, mission, style);
    if (meta.paths.length <= 50) {
      this.addMarker(this.pathGroup, points.subarray(0, 3), "start", style.colour, 15);
      this.addMarker(this.pathGroup, points.subarray(points.length - 3), "goal", style.colour, 15);
    }
  }

  // Many of them as one.
  addPaths() {
    const found = meta.paths.filter(data => data.points);
    const ways = new Ways(found.map(data => ({ points: arrayOf(data.points), mission: missionOfPath.get(data), time: null })));
    ways.show(0, 0);
    this.pathGroup.add(ways.object);
  }

  // Of a fleet the motions that are looked at stand out: those before are taken away.
  standOut(chosen) {
    const { parts } = this;
    for (const vehicle of parts.vehicles) this.motionGroup.remove(vehicle.object);
    for (const line of parts.lines.filter(l => l.group === this.motionGroup)) this.motionGroup.remove(line.ribbon.object);
    parts.lines = parts.lines.filter(l => l.group !== this.motionGroup);
    parts.vehicles = [];
    parts.ribbons = [];
    for (const motion of chosen) {
      const key = `${motion.isFlight} ${motions.indexOf(motion)}`;
      if (!this.stood.has(key)) {
        this.addMotion(motion);
        this.stood.set(key, { vehicle: parts.vehicles.pop(), line: motion.samples >= 2 ? parts.lines.pop() : null });
        if (motion.samples >= 2) parts.ribbons.pop();
      }
      const { vehicle, line } = this.stood.get(key);
      parts.vehicles.push(vehicle);
      this.motionGroup.add(vehicle.object);
      if (!line) continue;
      parts.lines.push(line);
      parts.ribbons.push(line.ribbon);
      this.motionGroup.add(line.ribbon.object);
    }
  }

  // What the fleet has drawn by itself: the pair that is looked at, or the motion.
  chosenMotions() {
    if (selection.pair) return selection.pair.of.map(i => motions[i]);
    return selection.motion ? [selection.motion] : [];
  }

  addMotion(motion) {
    if (motion.samples >= 2) {
      const style = lineStyle(motion.mission, motion.isFlight ? "flown" : "motion", 3);
      // Of many missions what was flown has the mission's colour, nearer to that of ink.
      const share = manyMissions && motion.isFlight ? 0.25 : 0;
      const line = this.addLine(this.motionGroup, motion.position, motion.mission, { ...style, share });
      line.ribbon.motion = motion;
      this.parts.ribbons.push(line.ribbon);
    }
    const vehicle = new Vehicle(motion, this.ground.height);
    this.parts.vehicles.push(vehicle);
    this.motionGroup.add(vehicle.object);
  }

  addLine(group, points, mission, style) {
    const line = { group, points, mission, width: style.width, ribbon: new Ribbon(points, style) };
    this.parts.lines.push(line);
    group.add(line.ribbon.object);
    return line;
  }

  // The chosen mission is drawn bolder, and has its line down to the floor.
  showChosen() {
    if (this.fleet) this.standOut(this.chosenMotions());
    if (this.homeLines) {
      this.homeLines.show(this.parts.ribbons);
      this.homeWay.choose(homeOf(selection.mission));
    }
    const bold = manyMissions ? 1.6 : 1;
    for (const line of this.parts.lines) line.ribbon.setWidth(line.width * (line.mission === selection.mission ? bold : 1));
    for (const vehicle of this.parts.vehicles) {
      vehicle.drop.object.visible = Boolean(this.fleet) || vehicle.motion === selection.motion || motions.length <= mostDrops;
    }
    this.redraw();
  }

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
    this.surface.addEventListener("pointermove", e => {
      if (e.buttons || !manyMissions) return;
      const box = this.surface.getBoundingClientRect();
      const at = [e.clientX - box.left, e.clientY - box.top];
      this.surface.classList.toggle("on-line", Boolean(this.vehicleAt(...at) || this.lineAt(...at)));
    });
  }

  vehicleAt(x, y) {
    if (!this.fleet || !this.motionGroup.visible) return null;
    return this.fleet.at(x, y, this.view.camera, this.surface.clientWidth, this.surface.clientHeight);
  }

  lineAt(x, y) {
    const lines = this.parts.lines.filter(line => line.group.visible);
    return pickLine(lines, this.view.camera, x, y, this.surface.clientWidth, this.surface.clientHeight);
  }

  // Whether a box stands between two points.
  hidden(from, to) {
    const along = to.clone().sub(from);
    return Boolean(this.boxes) && pickBox(this.boxes.corners, from, along, 0.97) !== null;
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

  // A click means a vehicle of the fleet or a line where one is near, else a box.
  pick(x, y) {
    const motion = this.vehicleAt(x, y);
    if (motion) {
      selection.chooseMotion(motion);
      return this.redraw();
    }
    const line = manyMissions ? this.lineAt(x, y) : null;
    if (line) selection.choose(line.mission);
    if (this.picked) {
      const ray = this.ray(x, y);
      this.picked.choose(!line && this.boxes.mesh.visible ? pickBox(this.boxes.corners, ray.origin, ray.direction) : null);
    }
    this.redraw();
  }

  look(mode) {
    this.view.set(mode, { motion: selection.motion, pair: selection.pair, time: clock.time, hidden: (from, to) => this.hidden(from, to) });
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
    this.view.track(selection.motion, clock.time, selection.pair);
    this.view.apply(width, height);
    const perPixel = this.view.perPixel(height);
    patternPeriod.value = roundUp(this.metresPerPixel() * 12);
    for (const marker of this.parts.markers) marker.resize(perPixel);
    for (const vehicle of this.parts.vehicles) vehicle.update(clock.time, this.view.camera.position, perPixel);
    if (this.fleet) this.fleet.update(clock.time, perPixel, new Set(this.chosenMotions()));
    if (this.homeWay) this.homeWay.update(perPixel);
    this.pairLine.update(selection.pair, clock.time, this.view.camera, width, height);
    const reach = this.view.orbit.distance + this.view.extent().across * 0.6;
    if (this.boxes) {
      this.boxes.setHaze(reach);
      this.boxes.setScale(perPixel / this.ratio);
      if (this.boxes.mesh.visible) this.boxes.look(this.view.camera, perPixel);
      this.cutAway(width, height);
    }
    this.ground.setHaze(reach);
    this.renderer.info.reset();
    if (this.boxes && this.boxes.mesh.visible) {
      this.outlines.draw(this.renderer, this.view.camera, Math.round(width * this.ratio), Math.round(height * this.ratio));
    }
    this.renderer.render(this.scene, this.view.camera);
    this.labels.update(this.view.camera, width, height);
    this.frames += 1;
    this.frameMs = performance.now() - begin;
    showCompass(this.view.orbit.heading);
    showScale(this.metresPerPixel());
  }

  // Opens the view onto the followed vehicle where boxes stand before it.
  cutAway(width, height) {
    const { camera, orbit, mode } = this.view;
    const hidden = (mode === "follow" || mode === "ride") && this.hidden(camera.position, orbit.target);
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
