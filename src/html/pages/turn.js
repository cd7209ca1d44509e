// Models to turn by hand: a film becomes one when its reader asks for it. The model is glTF as `polhode export` writes it,
// in a block of data of the page; three.js draws it, in the colours and the light of the film.
"use strict";
{
  const ownNonce = document.currentScript.nonce;
  const barClass = document.querySelector(".reveal") ? "turn-bar" : "controls"; // slides have controls of their own
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  // ---- what the page brings -------------------------------------------------------------------------------------

  // three.js is text until it is needed
  const drawing = () => {
    if (!globalThis.THREE) {
      globalThis.THREE = {};
      const script = document.createElement("script");
      script.nonce = ownNonce;
      script.textContent = "(function (exports) {" + document.querySelector("script[data-three]").textContent + "\n})(globalThis.THREE);";
      document.head.append(script);
      script.remove();
    }
    return globalThis.THREE;
  };

  // what draws here: the words of WebGL, null without it
  const graphics = () => {
    try {
      const gl = document.createElement("canvas").getContext("webgl2");
      const more = gl?.getExtension("WEBGL_debug_renderer_info");
      const words = gl && String(gl.getParameter(more ? more.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
      gl?.getExtension("WEBGL_lose_context")?.loseContext();
      return words;
    } catch {
      return null;
    }
  };
  const drawnBy = document.querySelector("script[data-three]") && document.querySelector("figure[data-turn]") ? graphics() : null;
  // without a graphics card, several samples of a pixel cost more than all else: only pictures that rest get them
  const bySoftware = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(drawnBy ?? "");

  const blockOf = (name) => [...document.querySelectorAll("script[data-viewer]")].find((one) => one.dataset.viewer === name);

  // binary glTF: a header, a piece of JSON, a piece of numbers
  const bytesOf = (base64) => Uint8Array.from(atob(base64), (one) => one.charCodeAt(0));
  const readGlb = (bytes) => {
    const size = new DataView(bytes.buffer).getUint32(12, true);
    const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + size)));
    const kinds = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
    const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
    const kept = new Map();
    const numbers = (index) => {
      if (kept.has(index)) return kept.get(index);
      const accessor = json.accessors[index];
      const start = 28 + size + (json.bufferViews[accessor.bufferView].byteOffset ?? 0) + (accessor.byteOffset ?? 0);
      const found = new kinds[accessor.componentType](bytes.buffer, start, accessor.count * widths[accessor.type]);
      kept.set(index, found);
      return found;
    };
    return { json, numbers };
  };

  // ---- surfaces, as shaders/scene.frag lights them: the numbers are in the files of shaders/ ----------------------

  const corners = `
    attribute float density;
    varying vec3 v_normal, v_world, v_mesh;
    varying float v_density;
    void main() {
      vec4 world = modelMatrix * vec4(position, 1.0);
      v_world = world.xyz;
      v_mesh = position;
      v_density = density;
      v_normal = normalize((vec4(normalMatrix * normal, 0.0) * viewMatrix).xyz);
      gl_Position = projectionMatrix * viewMatrix * world;
    }`;
  const points = `
    uniform vec3 color, mark, key, fill;
    uniform float alpha, gloss, strip, grain, dashes;
    varying vec3 v_normal, v_world, v_mesh;
    varying float v_density;
    #include "light.glsl"
    #include "surface.glsl"
    void main() {
      vec3 painted = color;
    #if MARKED
      float front = clamp(v_mesh.x / (fwidth(v_mesh.x) + 1e-9 * strip) + 0.5, 0.0, 1.0);
      float on = clamp((strip - abs(v_mesh.y)) / (fwidth(v_mesh.y) + 1e-9 * strip) + 0.5, 0.0, 1.0) * front;
      painted = mix(halved(color, front), mark, on);
    #endif
    #if FINISH == 1
      painted = grained(painted, v_mesh / grain);
    #elif FINISH == 2
      float across = TURNED == 1 ? brushed(length(v_mesh.xy) / grain) : brushed(v_mesh.y / grain);
      painted = stroked(painted, across, brushed(v_mesh.z / grain));
    #endif
    #if FLAT
      gl_FragColor = vec4(color, 1.0) * alpha;
    #if SOFT
      gl_FragColor *= v_density;
    #endif
    #else
      vec3 normal = normalize(v_normal) * (gl_FrontFacing ? 1.0 : -1.0);
      vec3 to_eye = normalize(cameraPosition - v_world);
      float facing = abs(dot(normal, to_eye));
      // the vertical of glTF is y
      vec3 light = light_on(vec2(dot(normal, key), dot(normal, fill)), normal.y, facing);
    #if VIVID
      light = vivid(light);
    #endif
      vec3 lit = painted * painted * light;
      vec3 halfway = normalize(key + to_eye);
      float glance = dot(normal, halfway);
    #if FINISH < 2
      lit = glossy(lit, gloss, glance);
    #elif FINISH == 2
      lit = mirroring(painted, lit, 2.0 * dot(normal, to_eye) * normal.y - to_eye.y, glance);
    #else
      vec3 across = normalize(cross(halfway, to_eye));
      lit = glazed(lit, vec2(dot(normal, across), dot(normal, cross(across, halfway))), glance, facing);
    #endif
      vec3 shown = toned(lit);
    #if SHELL
      gl_FragColor = shell(painted, shown, alpha, facing);
    #elif HIDDEN
      float gap = dashes > 0.0 ? dashed(v_mesh.z * dashes) : 1.0;
      gl_FragColor = vec4(dashes > 0.0 ? painted : shown, 1.0) * alpha * gap;
    #else
      gl_FragColor = vec4(shown, 1.0);
    #endif
    #endif
    }`;

  // the passes in which a surface is drawn: those that cover, what they hide, the rest, what is seen through; and where a
  // table is in front, which covers though it is seen through, what that hides
  const isTable = (look) => look.soft && look.covers;
  const passesOf = (look, lights, withTable) => {
    const THREE = drawing();
    const shell = look.alpha < 1;
    const make = (order, side, settings, alpha, hidden) => {
      const material = new THREE.ShaderMaterial({
        uniforms: {
          color: { value: new THREE.Vector3(...look.color) }, mark: { value: new THREE.Vector3(...look.mark_color) },
          key: lights.key, fill: lights.fill, alpha: { value: alpha }, gloss: { value: look.gloss }, strip: { value: look.mark_width },
          grain: { value: Math.max(look.grain, 1e-9) }, dashes: { value: 0 },
        },
        defines: {
          MARKED: Number(look.mark_width > 0), FINISH: look.finish, TURNED: Number(look.turned), FLAT: Number(look.flat), SOFT: Number(look.soft),
          VIVID: Number(look.vivid), LIGHT_GROUND: Number(Boolean(lights.lightGround)), SHELL: Number(shell), HIDDEN: Number(hidden),
        },
        vertexShader: corners, fragmentShader: points, side, ...settings,
      });
      return { order, material, dashed: hidden && look.dashes > 0 };
    };
    const blended = { blending: THREE.CustomBlending, blendSrc: THREE.OneFactor, blendDst: THREE.OneMinusSrcAlphaFactor, depthWrite: false };
    const clear = { ...blended, transparent: true };
    // where it is in front of all else, its depth becomes that of the picture
    const marking = { stencilWrite: true, stencilRef: 1, stencilZPass: THREE.ReplaceStencilOp };
    const marked = { stencilWrite: true, stencilRef: 1, stencilFunc: THREE.EqualStencilFunc };
    if (look.soft) {
      const passes = [make(5, THREE.DoubleSide, clear, look.alpha, false)];
      if (isTable(look)) passes.push(make(12, THREE.FrontSide, { ...clear, ...marking, depthWrite: true, colorWrite: false }, look.alpha, false));
      return passes;
    }
    if (look.flat && shell) return [make(6, THREE.DoubleSide, clear, look.alpha, false)];
    if (shell) return [make(10, THREE.BackSide, clear, look.alpha, false), make(11, THREE.FrontSide, clear, look.alpha, false)];
    const passes = [make(look.covers && !look.thin ? 0 : 2, THREE.FrontSide, {}, 1, false)];
    if (look.hidden > 0) {
      const behind = { depthFunc: THREE.GreaterDepth };
      passes.push(make(1, THREE.FrontSide, { ...blended, ...behind }, look.hidden, true));
      if (withTable) passes.push(make(13, THREE.FrontSide, { ...clear, ...behind, ...marked }, look.hidden, true));
    }
    return passes;
  };

  // ---- the model ------------------------------------------------------------------------------------------------

  // the index of the last of these ascending times that is not after `time`, from `i` on
  const lastBefore = (times, time, i = 0) => {
    let high = times.length;
    while (high - i > 1) {
      const middle = (i + high) >> 1;
      if (times[middle] <= time) i = middle;
      else high = middle;
    }
    return i;
  };

  class Model {
    constructor(bytes) {
      const THREE = drawing();
      const { json, numbers } = readGlb(bytes);
      this.about = json.asset.extras;
      this.lights = { key: { value: new THREE.Vector3() }, fill: { value: new THREE.Vector3() }, lightGround: this.about.light_ground };
      this.scene = new THREE.Scene();
      this.elements = new Map(); // name -> { color, groups }
      this.labels = [];
      this.dashed = [];
      this.paths = []; // as joinedPath makes them
      const looks = (json.materials ?? []).map((one) => one.extras);
      const passes = looks.map((look) => passesOf(look, this.lights, looks.some(isTable)));
      const shapes = new Map();
      const shapeOf = (primitive) => {
        const key = JSON.stringify([primitive.attributes, primitive.indices]);
        if (!shapes.has(key)) {
          const shape = new THREE.BufferGeometry();
          shape.setAttribute("position", new THREE.BufferAttribute(numbers(primitive.attributes.POSITION), 3));
          shape.setAttribute("normal", new THREE.BufferAttribute(numbers(primitive.attributes.NORMAL), 3));
          if ("COLOR_0" in primitive.attributes) {
            const colors = numbers(primitive.attributes.COLOR_0);
            shape.setAttribute("density", new THREE.BufferAttribute(colors.filter((_, k) => k % 4 === 3), 1));
          }
          shape.setIndex(new THREE.BufferAttribute(numbers(primitive.indices), 1));
          shapes.set(key, shape);
        }
        return shapes.get(key);
      };
      // pieces of paths: leaves that are not moved, only come and go
      const moves = new Map();
      for (const { channels, samplers } of json.animations ?? []) {
        for (const { sampler, target } of channels) moves.set(target.node, moves.has(target.node) ? null : { path: target.path, ...samplers[sampler] });
      }
      const comesAndGoes = (node, i) => {
        const move = moves.get(i);
        return node.mesh !== undefined && !node.children && !node.extras && !node.translation && !node.rotation && move?.path === "scale" &&
          move.interpolation === "STEP" && numbers(move.output).every((value) => value === 0 || value === 1) && json.meshes[node.mesh].primitives.length === 1;
      };
      const inPath = new Set();
      const joined = []; // { parent, material, pieces }
      json.nodes.forEach(({ children = [] }, parent) => {
        const byMaterial = new Map();
        for (const child of children.filter((one) => comesAndGoes(json.nodes[one], one))) {
          const { material } = json.meshes[json.nodes[child].mesh].primitives[0];
          const { soft, flat, alpha, dashes } = json.materials[material].extras;
          if (soft || flat || alpha < 1 || dashes > 0) continue;
          if (!byMaterial.has(material)) byMaterial.set(material, []);
          byMaterial.get(material).push(child);
        }
        for (const [material, pieces] of byMaterial) {
          if (pieces.length < 2) continue;
          joined.push({ parent, material, pieces });
          for (const piece of pieces) inPath.add(piece);
        }
      });
      this.nodes = json.nodes.map((node, index) => {
        const made = new THREE.Object3D();
        made.name = node.name;
        if (node.translation) made.position.fromArray(node.translation);
        if (node.rotation) made.quaternion.fromArray(node.rotation);
        if (node.scale) made.scale.fromArray(node.scale);
        for (const primitive of node.mesh === undefined || inPath.has(index) ? [] : json.meshes[node.mesh].primitives) {
          for (const { order, material, dashed } of passes[primitive.material]) {
            const part = new THREE.Mesh(shapeOf(primitive), dashed ? material.clone() : material);
            if (dashed) Object.assign(part.material.uniforms, { key: this.lights.key, fill: this.lights.fill });
            part.renderOrder = order;
            part.frustumCulled = false;
            made.add(part);
            if (!dashed) continue;
            part.scale.set(this.about.dashes.breadth, this.about.dashes.breadth, 1);
            this.dashed.push(part);
          }
        }
        const extras = node.extras ?? {};
        if ("label" in extras) this.labels.push({ node: made, ...extras });
        if ("element" in extras) {
          if (!this.elements.has(extras.element)) this.elements.set(extras.element, { color: extras.color, groups: [] });
          this.elements.get(extras.element).groups.push(made);
        }
        return made;
      });
      json.nodes.forEach((node, i) => (node.children ?? []).forEach((child) => this.nodes[i].add(this.nodes[child])));
      for (const root of json.scenes[0].nodes) this.scene.add(this.nodes[root]);
      for (const { parent, material, pieces } of joined) {
        const parts = pieces.map((piece) => shapeOf(json.meshes[json.nodes[piece].mesh].primitives[0]));
        const path = this.joinedPath(parts, pieces.map((piece) => this.nodes[piece]));
        for (const { order, material: look } of passes[material]) {
          const part = new THREE.Mesh(path.shape, look);
          part.renderOrder = order;
          part.frustumCulled = false;
          this.nodes[parent].add(part);
        }
        this.paths.push(path);
      }
      this.tracks = (json.animations ?? []).flatMap((animation) =>
        animation.channels.map(({ sampler, target }) => {
          const { input, output, interpolation } = animation.samplers[sampler];
          return { node: this.nodes[target.node], path: target.path, times: numbers(input), values: numbers(output), steps: interpolation === "STEP", at: 0 };
        }));
      this.camera = json.cameras[0].perspective;
      this.turn = [new THREE.Quaternion(), new THREE.Quaternion()];
      this.show(0);
    }

    // One shape of many, for one call: of its triangles those are drawn whose pieces are there.
    joinedPath(parts, pieces) {
      const THREE = drawing();
      const all = (name) => {
        const lists = parts.map((one) => one.getAttribute(name).array);
        const together = new Float32Array(lists.reduce((sum, one) => sum + one.length, 0));
        let at = 0;
        for (const list of lists) {
          together.set(list, at);
          at += list.length;
        }
        return new THREE.BufferAttribute(together, 3);
      };
      const shape = new THREE.BufferGeometry();
      for (const name of ["position", "normal"]) shape.setAttribute(name, all(name));
      let before = 0;
      const triangles = parts.map((one) => {
        const list = Uint32Array.from(one.index.array, (corner) => corner + before);
        before += one.getAttribute("position").count;
        return list;
      });
      const index = new THREE.BufferAttribute(new Uint32Array(triangles.reduce((sum, one) => sum + one.length, 0)), 1);
      index.setUsage(THREE.DynamicDrawUsage);
      shape.setIndex(index);
      return { pieces, triangles, shape, shown: pieces.map(() => null) };
    }
    showPath({ pieces, triangles, shape, shown }) {
      if (pieces.every((piece, i) => piece.visible === shown[i])) return;
      let count = 0;
      pieces.forEach((piece, i) => {
        shown[i] = piece.visible;
        if (!piece.visible) return;
        shape.index.array.set(triangles[i], count);
        count += triangles[i].length;
      });
      shape.index.needsUpdate = true;
      shape.setDrawRange(0, count);
    }

    // frees what the graphics card holds of it
    close() {
      this.scene.traverse((part) => {
        part.geometry?.dispose();
        part.material?.dispose();
      });
    }

    node(name) {
      return this.nodes.find((one) => one.name === name);
    }

    // everything where it is at a time of the animation, s
    show(time) {
      for (const track of this.tracks) {
        const { node, path, times, values } = track;
        let i = track.at;
        if (i >= times.length || times[i] > time) i = 0;
        if (i + 64 < times.length && times[i + 64] < time) i = lastBefore(times, time, i);
        while (i + 1 < times.length && times[i + 1] <= time) ++i;
        track.at = i;
        const last = i + 1 >= times.length || time <= times[i];
        const part = last || track.steps ? 0 : (time - times[i]) / (times[i + 1] - times[i]);
        if (path === "rotation") {
          const [a, b] = this.turn;
          a.fromArray(values, 4 * i);
          if (part > 0) a.slerp(b.fromArray(values, 4 * i + 4), part);
          node.quaternion.copy(a);
        } else {
          const to = path === "scale" ? node.scale : node.position;
          to.fromArray(values, 3 * i);
          if (part > 0) {
            for (let k = 0; k < 3; ++k) to.setComponent(k, to.getComponent(k) + part * (values[3 * i + 3 + k] - values[3 * i + k]));
          }
          if (path === "scale") node.visible = node.scale.x !== 0 || node.scale.y !== 0 || node.scale.z !== 0;
        }
      }
      for (const path of this.paths) this.showPath(path);
      this.scene.updateMatrixWorld();
      for (const part of this.dashed) part.material.uniforms.dashes.value = part.parent.scale.z / this.about.dashes.length;
    }
  }

  // ---- time -----------------------------------------------------------------------------------------------------

  // One clock for all viewers of the same name. Times in s of it, each of which is `scale` s of motion: that of the
  // first viewer, so that motions side by side are at the same time.
  class Clock {
    constructor(scale) {
      Object.assign(this, { scale, duration: 0, pauses: [], time: 0, playing: false, speed: 1, loops: false, watchers: [], before: 0 });
    }
    join(duration, pauses, watcher) {
      this.duration = Math.max(this.duration, duration);
      this.pauses = [...new Set([...this.pauses, ...pauses])].sort((a, b) => a - b);
      this.watchers.push(watcher);
    }
    tell() {
      for (const watcher of this.watchers) watcher();
    }
    set(time) {
      this.time = Math.min(this.duration, Math.max(0, time));
      this.tell();
    }
    goAt(speed) {
      this.speed = speed;
      this.tell();
    }
    repeat(loops) {
      this.loops = loops;
      this.tell();
    }
    pause() {
      this.playing = false;
      this.tell();
    }
    play() {
      if (this.playing) return;
      if (this.time >= this.duration) this.time = 0;
      this.playing = true;
      this.before = performance.now();
      this.askNext();
      this.tell();
    }
    // once, even if it was paused and played again since the last one
    askNext() {
      cancelAnimationFrame(this.next);
      this.next = requestAnimationFrame((now) => this.tick(now));
    }
    // a hidden page gets no frames: time stands still there
    tick(now) {
      if (!this.playing) return;
      const passed = Math.min(0.25, Math.max(0, (now - this.before) / 1000)) * this.speed;
      this.before = now;
      const stop = this.pauses.find((one) => one > this.time + 1e-9 && one <= this.time + passed + 1e-9);
      let time = this.time + passed;
      if (stop !== undefined) {
        time = stop;
        this.playing = false;
      } else if (time >= this.duration) {
        time = this.loops ? time % this.duration : this.duration;
        this.playing = this.loops;
      }
      this.set(time);
      if (this.playing) this.askNext();
    }
  }
  const clocks = new Map();

  // ---- words ----------------------------------------------------------------------------------------------------

  const make = (tag, settings = {}, ...children) => {
    const made = document.createElement(tag);
    for (const [key, value] of Object.entries(settings)) {
      if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
      else made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
  };
  const press = (text, label, action) => make("button", { type: "button", "aria-label": label, title: label, onclick: action }, text);

  // the little markup of labels: bold, italic, raised and lowered; all else is text
  const setMarkup = (into, markup) => {
    const parsed = new DOMParser().parseFromString(`<label>${markup}</label>`, "application/xml");
    const copy = (from, to) => {
      for (const child of from.childNodes) {
        if (child.nodeType === Node.TEXT_NODE) {
          to.append(child.data);
        } else if (child.nodeType === Node.ELEMENT_NODE) {
          const known = ["b", "i", "sub", "sup"].includes(child.nodeName);
          const inner = known ? document.createElement(child.nodeName) : to;
          copy(child, inner);
          if (known) to.append(inner);
        }
      }
    };
    if (parsed.querySelector("parsererror")) into.textContent = markup;
    else copy(parsed.documentElement, into);
  };

  const readable = (name) => name.replaceAll("_", " ");
  const short = (value, digits = 4) => (value === 0 ? "0" : Number(value.toPrecision(digits)).toString());

  const svg = (tag, settings) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [key, value] of Object.entries(settings)) made.setAttribute(key, value);
    return made;
  };

  // ---- a viewer -------------------------------------------------------------------------------------------------

  const views = [["film", "As in the film"], ["along_momentum", "Along L"], ["along_omega", "Along Ω"], ["along_axis", "Along the axis"]];

  const NUMBERS_EVERY = 60; // ms, while it plays
  const SCREEN = 1000 / 60, SLOW = 18.5; // ms from picture to picture: of screens, and from where on fewer pixels are drawn by software
  const COARSEST = 0.6; // pixels of the picture for each of the page

  // a page is laid out anew only where something changes
  const say = (place, text) => {
    if (place.textContent !== text) place.textContent = text;
  };
  const setOn = (place, name, value) => {
    if (place.getAttribute(name) !== value) place.setAttribute(name, value);
  };

  class Viewer {
    constructor(figure, data) {
      const THREE = drawing();
      this.figure = figure;
      this.data = data;
      this.byHand = new Map(); // element -> whether it is shown, where its tick was used
      this.yaw = this.pitch = 0; // rad, by hand
      this.zoom = 1;
      this.coarse = 1; // of pixels drawn by software
      this.pace = SCREEN; // ms from picture to picture
      this.view = "film";
      this.frame = "space";
      this.renderer = new THREE.WebGLRenderer({ antialias: !bySoftware, alpha: false, stencil: true });
      this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // the shader writes what is shown
      this.camera = new THREE.PerspectiveCamera();
      this.past = []; // models that are no longer shown
      this.take(new Model(bytesOf(data.glb)));
      delete data.glb;
      this.temporary = { place: new THREE.Matrix4(), eye: new THREE.Vector3(), middle: new THREE.Vector3(), turn: new THREE.Quaternion(), other: new THREE.Quaternion(), axis: new THREE.Vector3(), up: new THREE.Vector3(), size: new THREE.Vector3() };
      this.renderer.setClearColor(new THREE.Color().setStyle(this.model.about.background, THREE.LinearSRGBColorSpace), 1);
      const name = figure.dataset.clock || ` ${figure.dataset.turn}`;
      if (!clocks.has(name)) clocks.set(name, new Clock(data.scale));
      this.clock = clocks.get(name);
      this.duration = (data.to - data.from) / this.clock.scale;
      const pauses = data.pauses.map((one) => (one.at - data.from) / this.clock.scale).filter((one) => one > 0 && one < this.duration);
      this.clock.join(this.duration, pauses, () => this.update());
      this.build();
      this.watch();
      this.update();
    }

    // shows this model from now on
    take(model) {
      if (this.model) this.past.push(this.model); // until the new one is drawn, so that its shaders are still there
      this.model = model;
      this.film = model.node("camera");
      this.body = model.node("body_frame");
      this.middle = model.node("along_axis");
      this.lightNodes = { key: model.node("key_light"), fill: model.node("fill_light") };
      this.start = { camera: this.film.matrixWorld.clone(), body: this.body.matrixWorld.clone() };
      this.startMiddle = undefined;
    }

    // motion time, s
    get t() {
      return Math.min(this.data.to, this.data.from + this.clock.time * this.clock.scale);
    }

    build() {
      const { data } = this;
      const video = this.figure.querySelector("video");
      this.canvas = this.renderer.domElement;
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute("role", "application");
      this.canvas.setAttribute("aria-label", `Model to turn: ${video.getAttribute("aria-label") || data.title}. Arrows turn it, plus and minus zoom, space plays, comma and full stop step.`);
      this.picture = make("div", { class: "turning" }, this.canvas);
      this.picture.style.aspectRatio = String(this.model.camera.aspectRatio);
      this.picture.style.background = this.model.about.background;
      this.setLabels();

      const step = (by) => {
        this.clock.pause();
        this.clock.set((Math.round(this.clock.time * data.fps) + by) / data.fps);
      };
      this.step = step;
      this.range = make("input", { type: "range", min: "0", max: String(this.duration), step: "any", "aria-label": "Time", oninput: () => {
        this.clock.pause();
        this.clock.set(Number(this.range.value));
      }, onkeydown: (event) => {
        // any step for the mouse, one frame for keys
        const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
        event.stopPropagation();
        if (!by) return;
        event.preventDefault();
        step(by);
      } });
      this.play = press("▶", "Play", () => this.toggle());
      this.speed = make("select", { "aria-label": "Speed", onchange: () => this.clock.goAt(Number(this.speed.value)) },
        ...[0.1, 0.25, 0.5, 1, 2].map((value) => new Option(`× ${value}`, String(value), value === 1, value === 1)));
      this.loop = press("⟳", "Repeat", () => this.clock.repeat(!this.clock.loops));
      this.viewList = make("select", { "aria-label": "View", onchange: () => this.look(this.viewList.value) }, ...views.map(([value, words]) => new Option(words, value)));
      this.frameList = make("select", { "aria-label": "Frame of reference", onchange: () => this.stand(this.frameList.value) }, new Option("Space stands still", "space"), new Option("The body stands still", "body"));
      const reset = press("⌂", "Turn back", () => {
        this.byHand.clear();
        for (const name of this.ticks.keys()) this.setShown(name, true);
        this.look(this.view);
      });
      const link = press("Link", "Link to this view and time: copy", () => {
        history.replaceState(null, "", this.link());
        if (navigator.clipboard) navigator.clipboard.writeText(location.href).catch(() => {});
        link.textContent = "Copied";
        setTimeout(() => (link.textContent = "Link"), 1500);
      });
      const large = press("⤢", "Full screen", () => {
        if (document.fullscreenElement) document.exitFullscreen();
        else if (this.figure.requestFullscreen) this.figure.requestFullscreen().catch(() => {});
      });
      const back = press("Film", "Back to the film", () => this.close());
      const stops = data.pauses.map((pause, i) => press(`❚❚ ${i + 1}`, `Pause point ${i + 1}, ${short(pause.at)} s${pause.caption ? ": " + pause.caption : ""}`, () => {
        this.clock.pause();
        this.clock.set((pause.at - data.from) / this.clock.scale);
      }));
      this.shown = make("fieldset");
      this.setTicks();
      this.numbers = Object.fromEntries(["t", "|Ω|", "|L|", "E", "θ"].map((name) => [name, make("dd")]));
      const words = { t: "Time", "|Ω|": "Angular velocity", "|L|": "Angular momentum", E: "Energy", θ: "Tilt of the axis" };
      this.said = make("p", { class: "said", "aria-live": "polite" });
      this.curves = make("div", { class: "curves" });
      this.setCurves();
      this.bar = make("div", { class: barClass, role: "group", "aria-label": "Model: " + (video.getAttribute("aria-label") || data.title) },
        this.range, this.play, press("−1", "−1 frame", () => step(-1)), press("+1", "+1 frame", () => step(1)), this.speed, this.loop, ...stops, this.viewList, this.frameList, reset, link, large, back,
        this.shown, ...this.sliders(),
        make("dl", { class: "numbers" }, ...Object.entries(this.numbers).map(([name, place]) => make("div", {}, make("dt", { title: words[name] }, name), place))),
        ...(data.captions.length > 0 ? [this.said] : []), ...(data.plots.length > 0 ? [this.curves] : []));
      this.hiddenParts = [...this.figure.querySelectorAll(".screen, .controls, .turn-bar")];
      for (const part of this.hiddenParts) part.hidden = true;
      for (const part of this.hiddenParts) part.style.display = "none";
      this.figure.classList.add("turn-figure");
      this.figure.querySelector(".screen").after(this.picture, this.bar);
      this.listen();
    }

    setLabels() {
      for (const { tip } of this.labels ?? []) tip.remove();
      this.labels = this.model.labels.map((label) => {
        const tip = make("span", { class: "tip", "aria-hidden": "true" });
        tip.style.color = label.color;
        tip.style.fontSize = `${1.15 * label.size}rem`;
        setMarkup(tip, label.label);
        this.picture.append(tip);
        let element = label.node;
        while (element && !this.isGroup(element)) element = element.parent;
        return { ...label, tip, group: element };
      });
    }

    setTicks() {
      this.ticks = new Map([...this.model.elements].map(([name, { color, groups }]) => {
        const tick = make("input", { type: "checkbox", onchange: () => this.show(name, tick.checked) });
        tick.checked = true;
        const swatch = make("span", { class: "swatch" });
        swatch.style.background = color;
        return [name, { tick, groups, label: make("label", { title: this.data.elements[name] ?? name }, tick, swatch, readable(name)) }];
      }));
      this.shown.replaceChildren(make("legend", {}, "Shown"), ...[...this.ticks.values()].map((one) => one.label));
    }

    setCurves() {
      this.cursors = [];
      this.curves.replaceChildren(...this.data.plots.map((plot) => this.curve(plot)));
    }

    // what the reader may change of the scene, if the page can compute it
    sliders() {
      const { sliders } = this.data;
      this.values = [];
      if (!sliders || !turnCore.here()) return [];
      this.told = make("output", { "aria-live": "polite" });
      const rows = sliders.map((slider, i) => {
        const number = make("output");
        const range = make("input", { type: "range", min: String(slider.from), max: String(slider.to), step: "any", "aria-label": slider.words, oninput: () => this.vary(i, Number(range.value)), onkeydown: (event) => {
          // any step for the mouse, a hundredth of the range for keys
          const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
          event.stopPropagation();
          if (!by) return;
          event.preventDefault();
          this.vary(i, this.values[i].value + (0.01 * by * (slider.to - slider.from)));
        } });
        this.values.push({ value: slider.value, range, number });
        return make("div", {}, make("span", {}, slider.words), range, number);
      });
      const back = press("As in the film", "Starting values as in the film", () => this.startAnew(sliders.map((one) => one.value)));
      this.values.forEach((_, i) => this.tellValue(i));
      return [make("fieldset", { class: "sliders" }, make("legend", {}, "Start"), ...rows, back, this.told)];
    }
    tellValue(i) {
      const { value, range, number } = this.values[i];
      range.value = String(value);
      number.textContent = short(value);
      range.setAttribute("aria-valuetext", short(value));
    }
    vary(i, value) {
      const rounded = Number(value.toPrecision(6)); // what nobody has touched stays as it is
      this.startAnew(this.values.map((one, k) => (k === i ? rounded : one.value)));
    }
    // the motion from other values on; nothing changes until it is there
    async startAnew(values) {
      const { sliders, request } = this.data;
      values.forEach((value, i) => {
        const { from, to } = sliders[i];
        this.values[i].value = Math.min(to, Math.max(from, value));
        this.tellValue(i);
      });
      this.told.textContent = "computing …";
      const settings = sliders.map(({ key }, i) => [key, String(this.values[i].value)]);
      const before = performance.now();
      const question = (this.question = (this.question ?? 0) + 1);
      const answer = await turnCore.ask({ ...request, settings });
      if (!answer) return;
      this.took = performance.now() - before;
      if (question === this.question) this.told.textContent = answer.about.error ?? answer.about.doubts.join("; ");
      if (answer.about.error) return;
      Object.assign(this.data, answer.about.viewer);
      this.take(new Model(answer.glb));
      this.setLabels();
      this.setTicks();
      this.setCurves();
      for (const [name, shown] of this.byHand) this.setShown(name, shown);
      this.update();
    }

    isGroup(node) {
      return [...this.model.elements.values()].some((one) => one.groups.includes(node));
    }

    // curves over the whole motion, with a cursor that shows the time and sets it
    curve({ title, unit, curves }) {
      const numbers = curves.flatMap((one) => one.values).filter((one) => one !== null);
      const low = Math.min(...numbers), high = Math.max(...numbers);
      const middle = 0.5 * (low + high), span = Math.max(high - low, 1e-9 * Math.abs(middle), 1e-300);
      const picture = svg("svg", { viewBox: "0 0 100 100", preserveAspectRatio: "none", role: "img", "aria-label": `${title} over time` });
      for (const { values } of curves) {
        let path = "", pen = "M";
        values.forEach((value, i) => {
          if (value === null) return (pen = "M");
          path += `${pen}${((100 * i) / (values.length - 1)).toFixed(2)} ${(50 - (88 * (value - middle)) / span).toFixed(2)}`;
          pen = "L";
        });
        picture.append(svg("path", { d: path }));
      }
      const cursor = svg("line", { y1: 0, y2: 100, x1: 0, x2: 0 });
      picture.append(cursor);
      this.cursors.push(cursor);
      const follow = (event) => {
        if (event.buttons === 0 && event.type === "pointermove") return;
        const box = picture.getBoundingClientRect();
        this.clock.pause();
        this.clock.set((((event.clientX - box.left) / box.width) * this.data.to - this.data.from) / this.clock.scale);
      };
      picture.addEventListener("pointerdown", follow);
      picture.addEventListener("pointermove", follow);
      const names = curves.length > 1 ? `: ${curves.map((one) => one.name).join(", ")}` : "";
      return make("div", {}, make("p", {}, `${title}${unit ? `, ${unit}` : ""}${names}`), picture);
    }

    toggle() {
      if (this.clock.playing) this.clock.pause();
      else this.clock.play();
    }

    // ---- turning ----

    listen() {
      const touches = new Map();
      const { canvas } = this;
      const apart = () => {
        const [a, b] = [...touches.values()];
        return Math.hypot(a.x - b.x, a.y - b.y);
      };
      canvas.addEventListener("pointerdown", (event) => {
        canvas.focus({ preventScroll: true });
        canvas.setPointerCapture(event.pointerId);
        touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
      });
      canvas.addEventListener("pointermove", (event) => {
        const last = touches.get(event.pointerId);
        if (!last) return;
        const before = touches.size === 2 ? apart() : 0;
        const moved = { x: event.clientX - last.x, y: event.clientY - last.y };
        touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
        // the height of the picture is half a turn
        if (touches.size === 1) this.turn((-Math.PI * moved.x) / canvas.clientHeight, (-Math.PI * moved.y) / canvas.clientHeight);
        else if (touches.size === 2 && before > 0) this.magnify(apart() / before);
      });
      for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => touches.delete(event.pointerId));
      canvas.addEventListener("wheel", (event) => {
        event.preventDefault();
        this.magnify(Math.exp(-0.0012 * event.deltaY));
      }, { passive: false });
      const angle = Math.PI / 36;
      const keys = {
        " ": () => this.toggle(), ",": () => this.step(-1), ".": () => this.step(1), Home: () => this.clock.set(0), End: () => this.clock.set(this.duration),
        ArrowLeft: () => this.turn(-angle, 0), ArrowRight: () => this.turn(angle, 0), ArrowUp: () => this.turn(0, -angle), ArrowDown: () => this.turn(0, angle),
        "+": () => this.magnify(1.1), "=": () => this.magnify(1.1), "-": () => this.magnify(1 / 1.1), 0: () => this.look(this.view),
      };
      canvas.addEventListener("keydown", (event) => {
        if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        event.stopPropagation();
        keys[event.key]();
      });
      // slides have keys of their own; of a button only these two do something here
      this.bar.addEventListener("keydown", (event) => {
        const passes = event.key === "Escape" || (event.target.closest("button") && event.key !== " " && event.key !== "Enter");
        if (!passes) event.stopPropagation();
      });
    }

    turn(yaw, pitch) {
      this.yaw += yaw;
      this.pitch += pitch;
      this.update();
    }
    magnify(factor) {
      this.zoom = Math.min(20, Math.max(0.05, this.zoom * factor));
      this.update();
    }
    look(view) {
      this.view = views.some(([known]) => known === view) ? view : "film";
      this.viewList.value = this.view;
      this.yaw = this.pitch = 0;
      this.zoom = 1;
      this.update();
    }
    stand(frame) {
      this.frame = frame === "body" ? "body" : "space";
      this.frameList.value = this.frame;
      this.update();
    }
    // by hand; what nobody touches is shown and hidden as the story says
    show(element, shown) {
      this.byHand.set(element, shown);
      this.setShown(element, shown);
      this.update();
    }
    setShown(element, shown) {
      if (!this.ticks.has(element)) return;
      const { tick, groups } = this.ticks.get(element);
      tick.checked = shown;
      for (const group of groups) group.visible = shown;
    }
    followStory() {
      for (const name of this.ticks.keys()) {
        if (this.byHand.has(name)) continue;
        const steps = this.data.story.filter(({ show, hide }) => show.includes(name) || hide.includes(name));
        if (steps.length === 0) continue;
        const last = steps.filter((one) => one.at <= this.t + 1e-9).pop();
        this.setShown(name, last ? last.show.includes(name) : steps[0].hide.includes(name));
      }
    }

    // The camera of the view, turned by hand about the reference point. A frame of reference in which the body
    // stands still takes the camera along.
    placeCamera() {
      const { place, eye, middle, turn, other, axis, up, size } = this.temporary;
      const { camera } = this;
      this.middle.getWorldPosition(middle);
      place.identity();
      if (this.frame === "body") place.copy(this.start.body).invert().premultiply(this.body.matrixWorld);
      up.set(0, 1, 0);
      if (this.view === "film") {
        place.multiply(this.frame === "body" ? this.start.camera : this.film.matrixWorld);
        place.decompose(eye, turn, size);
        if (this.frame === "body") up.set(0, 1, 0).transformDirection(this.temporaryBody());
      } else {
        const from = eye.setFromMatrixPosition(this.start.camera);
        const far = from.distanceTo(this.startMiddle ?? (this.startMiddle = middle.clone()));
        axis.set(0, 0, 1).transformDirection(this.model.node(this.view).matrixWorld);
        if (this.frame === "body") up.transformDirection(this.temporaryBody());
        if (Math.abs(axis.dot(up)) > 0.999) up.set(1, 0, 0).transformDirection(place);
        eye.copy(middle).addScaledVector(axis, far);
        place.lookAt(eye, middle, up);
        turn.setFromRotationMatrix(place);
        up.set(0, 1, 0).applyQuaternion(turn);
      }
      // about what is up, then about what is to the right
      axis.set(1, 0, 0).applyQuaternion(turn);
      other.setFromAxisAngle(up, this.yaw);
      turn.premultiply(this.pitchTurn.setFromAxisAngle(axis, this.pitch)).premultiply(other);
      eye.sub(middle).applyQuaternion(this.pitchTurn).applyQuaternion(other).divideScalar(this.zoom);
      const far = eye.length();
      camera.position.copy(eye.add(middle));
      camera.quaternion.copy(turn);
      const film = this.model.camera, aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
      const wide = Math.max(1, film.aspectRatio / aspect); // a narrow picture shows as much across
      camera.fov = (360 / Math.PI) * Math.atan(Math.tan(0.5 * film.yfov) * wide);
      camera.aspect = aspect;
      camera.near = Math.max(0.02 * far, 1e-4);
      camera.far = 50 * far + 10 * film.zfar;
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
      // lights travel with the camera
      for (const [name, node] of Object.entries(this.lightNodes)) this.model.lights[name].value.set(0, 0, 1).applyQuaternion(node.quaternion).applyQuaternion(turn);
    }
    get pitchTurn() {
      return this.ownPitch ?? (this.ownPitch = new (drawing().Quaternion)());
    }
    temporaryBody() {
      const THREE = drawing();
      const made = this.ownBody ?? (this.ownBody = new THREE.Matrix4());
      return made.copy(this.start.body).invert().premultiply(this.body.matrixWorld);
    }

    // ---- showing ----

    watch() {
      new ResizeObserver(() => this.update()).observe(this.picture);
      this.seen = true;
      new IntersectionObserver(([entry]) => {
        this.seen = entry.isIntersecting;
        if (this.seen) this.update();
        else if (this.clock.watchers.length === 1) this.clock.pause();
      }).observe(this.picture);
    }

    update() {
      if (bySoftware) {
        this.rests = false;
        clearTimeout(this.resting);
        this.resting = setTimeout(() => {
          this.rests = !this.clock.playing;
          this.ask();
        }, 250);
      }
      this.ask();
    }
    // at most one picture for each frame of the screen
    ask() {
      if (this.wanted) return;
      this.wanted = true;
      requestAnimationFrame(() => {
        this.wanted = false;
        this.draw();
      });
    }

    draw() {
      if (this.closed) return;
      // numbers and ticks are read also where the picture is not seen
      this.followStory();
      this.model.show((this.t - this.data.from) / this.data.scale); // s of its animation
      const width = this.picture.clientWidth, height = this.picture.clientHeight;
      if (width > 0 && height > 0 && this.seen) {
        const ratio = bySoftware ? this.softwareRatio() : Math.min(devicePixelRatio, 2);
        if (this.canvas.width !== Math.floor(width * ratio) || this.canvas.height !== Math.floor(height * ratio)) {
          this.renderer.setPixelRatio(ratio);
          this.renderer.setSize(width, height, false);
        }
        this.placeCamera();
        this.renderer.render(this.model.scene, this.camera);
        for (const model of this.past.splice(0)) model.close();
        this.placeLabels(width, height);
      }
      // nobody reads numbers that change with every frame
      const now = performance.now();
      if (this.clock.playing && this.toldNumbers?.playing && now - this.toldNumbers.at < NUMBERS_EVERY) return;
      this.toldNumbers = { at: now, playing: this.clock.playing };
      this.tellNumbers();
    }

    // Pixels of the picture for each of the page: by software fewer if it plays too slowly, and enough for smooth edges
    // when it rests.
    softwareRatio() {
      if (this.rests) return 2 * Math.min(devicePixelRatio, 1.5);
      const now = performance.now(), passed = now - (this.drawnAt ?? 0);
      this.drawnAt = now;
      if (this.clock.playing && passed < 500) this.pace += 0.05 * (passed - this.pace);
      if (this.pace > SLOW && this.coarse > COARSEST) {
        this.coarse = Math.max(COARSEST, 0.8 * this.coarse);
        this.pace = SCREEN;
      }
      return this.coarse * Math.min(devicePixelRatio, 1);
    }

    placeLabels(width, height) {
      const { eye, axis } = this.temporary;
      const placed = []; // where names stand: of two that would cover each other, the later one of the model stays
      for (const { node, tip, group } of [...this.labels].reverse()) {
        eye.setFromMatrixPosition(node.matrixWorld);
        axis.set(0, 0, 1).transformDirection(node.matrixWorld).multiplyScalar(0.05 * this.model.about.body_radius * this.model.about.units_per_metre).add(eye);
        eye.project(this.camera);
        axis.project(this.camera);
        let shown = node.visible && group.visible && Math.abs(eye.x) < 1 && Math.abs(eye.y) < 1 && eye.z < 1;
        const x = (0.5 + 0.5 * eye.x) * width, y = (0.5 - 0.5 * eye.y) * height;
        let dx = (axis.x - eye.x) * width, dy = -(axis.y - eye.y) * height;
        const length = Math.hypot(dx, dy) || 1;
        const off = 16;
        dx *= off / length;
        dy *= off / length;
        const inside = (at, size) => Math.min(size - off, Math.max(off, at));
        const [left, top] = [inside(x + dx, width), inside(y + dy, height)];
        shown &&= !placed.some((one) => Math.abs(one.left - left) < 0.75 * off && Math.abs(one.top - top) < 0.9 * off);
        tip.style.display = shown ? "" : "none";
        if (!shown) continue;
        placed.push({ left, top });
        tip.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px) translate(-50%, -50%)`;
      }
    }

    tellNumbers() {
      const { data, clock } = this;
      const { axis, up } = this.temporary;
      const { series } = data;
      // the readings around this time
      const before = Math.max(0, Math.min(lastBefore(series.times, this.t), series.times.length - 2));
      const after = Math.min(before + 1, series.times.length - 1);
      const part = Math.min(1, Math.max(0, (this.t - series.times[before]) / (series.times[after] - series.times[before] || 1)));
      const told = (list) => short(list[before] + part * (list[after] - list[before]), series.digits);
      axis.set(0, 0, 1).transformDirection(this.middle.matrixWorld);
      const { numbers } = this;
      say(numbers.t, `${this.t.toPrecision(5)} s`);
      say(numbers["|Ω|"], `${told(series.omega)} rad/s`);
      say(numbers["|L|"], `${told(series.momentum)} kg m²/s`);
      say(numbers.E, `${told(series.energy)} J`);
      say(numbers["θ"], `${((Math.acos(Math.max(-1, Math.min(1, axis.dot(up.fromArray(data.up))))) * 180) / Math.PI).toFixed(1)}°`);
      this.range.value = String(clock.time);
      setOn(this.range, "aria-valuetext", `${short(this.t)} s`);
      say(this.play, clock.playing ? "❚❚" : "▶");
      setOn(this.play, "aria-label", clock.playing ? "Pause" : "Play");
      setOn(this.play, "title", clock.playing ? "Pause (space)" : "Play (space)");
      this.speed.value = String(clock.speed);
      setOn(this.loop, "aria-pressed", String(clock.loops));
      say(this.said, data.captions.filter((one) => one.at <= this.t + 1e-9).pop()?.caption ?? "");
      for (const cursor of this.cursors) {
        const x = String((100 * this.t) / data.to);
        for (const end of ["x1", "x2"]) cursor.setAttribute(end, x);
      }
    }

    // ---- links ----

    link() {
      const words = new URLSearchParams({ turn: this.figure.dataset.turn, t: this.t.toPrecision(9), view: this.view, frame: this.frame, yaw: this.yaw.toFixed(4), pitch: this.pitch.toFixed(4), zoom: this.zoom.toFixed(4) });
      for (const [key, wanted] of [["show", true], ["hide", false]]) {
        const names = [...this.byHand].filter(([, shown]) => shown === wanted).map(([name]) => name);
        if (names.length > 0) words.set(key, names.join(" "));
      }
      if (this.values.some((one, i) => one.value !== this.data.sliders[i].value)) words.set("start", this.values.map((one) => one.value).join(" "));
      return "#" + words;
    }
    follow(words) {
      const number = (key, usual) => {
        const value = Number(words.get(key) ?? usual);
        return Number.isFinite(value) ? value : usual;
      };
      this.clock.pause();
      this.look(words.get("view"));
      this.stand(words.get("frame"));
      this.yaw = number("yaw", 0);
      this.pitch = number("pitch", 0);
      this.zoom = Math.min(20, Math.max(0.05, number("zoom", 1)));
      this.byHand.clear();
      for (const name of this.ticks.keys()) this.setShown(name, true);
      for (const [key, shown] of [["show", true], ["hide", false]]) {
        for (const name of (words.get(key) ?? "").split(" ")) if (this.ticks.has(name)) this.show(name, shown);
      }
      const values = (words.get("start") ?? "").split(" ").map(Number);
      if (this.values.length > 0 && values.length === this.values.length && values.every(Number.isFinite) && words.has("start")) this.startAnew(values);
      this.clock.set((number("t", this.data.from) - this.data.from) / this.clock.scale);
    }

    close() {
      this.clock.pause();
      this.picture.style.display = this.bar.style.display = "none";
      for (const part of this.hiddenParts) {
        part.hidden = false;
        part.style.display = "";
      }
      this.figure.classList.remove("turn-figure");
      this.opener.focus();
    }
    reopen() {
      this.picture.style.display = this.bar.style.display = "";
      for (const part of this.hiddenParts) {
        part.hidden = true;
        part.style.display = "none";
      }
      this.figure.classList.add("turn-figure");
      this.update();
    }
  }

  // ---- the page -------------------------------------------------------------------------------------------------

  const open = (figure) => {
    if (figure.viewer) {
      figure.viewer.reopen();
      return figure.viewer;
    }
    const block = blockOf(figure.dataset.turn);
    if (!block) return null;
    const data = JSON.parse(block.textContent);
    for (const video of figure.querySelectorAll("video")) video.pause();
    figure.viewer = new Viewer(figure, data);
    figure.viewer.opener = figure.opener;
    return figure.viewer;
  };

  const start = (figure) => {
    const viewer = open(figure);
    if (!viewer) return;
    viewer.canvas.focus({ preventScroll: true });
    if (!still.matches) viewer.clock.play();
  };

  if (drawnBy !== null) {
    for (const figure of document.querySelectorAll("figure[data-turn]")) {
      if (!blockOf(figure.dataset.turn)) continue;
      figure.opener = press("Turn it", "Turn it by hand", () => start(figure));
      figure.opener.classList.add("turn-start");
      const controls = figure.querySelector(".controls");
      if (controls) controls.append(figure.opener);
      else figure.querySelector(".screen").after(make("div", { class: barClass }, figure.opener));
    }
    // #turn=NAME&t=2.5&view=along_momentum
    const followTurn = () => {
      const words = new URLSearchParams(location.hash.slice(1));
      for (const figure of document.querySelectorAll("figure[data-turn]")) {
        if (!words.has("turn") || figure.dataset.turn !== words.get("turn")) continue;
        const viewer = open(figure);
        if (!viewer) continue;
        viewer.follow(words);
        figure.scrollIntoView({ block: "center" });
        viewer.canvas.focus({ preventScroll: true });
      }
    };
    addEventListener("hashchange", followTurn);
    followTurn();
  }
}
