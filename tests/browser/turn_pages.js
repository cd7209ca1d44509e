// SPDX-License-Identifier: MIT
// Opens a lecture with viewers (`.turn`) in a real browser, with files and without a network, as a student does.
// usage: turn_pages.js POLHODE SCENES CHROMIUM [FOLDER for screenshots]
"use strict";
const assert = require("node:assert");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const { chromium } = require("playwright-core");
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const [polhode, scenes, browserPath, pictures] = process.argv.slice(2);

const check = async (name, work) => {
  const said = await work();
  console.log("ok", name, said ?? "");
};
const place = fs.mkdtempSync(`${os.tmpdir()}/polhode-turn-`);
const run = (...words) => execFileSync(polhode, words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

// SSIM of two pictures must be at least this; text and floor are left out. Measured: 0.994 and 0.982.
const LEAST_SSIM = 0.975;

const hostile = `</script><script>globalThis.hacked = 1</script><img src=x onerror="globalThis.hacked = 2">`;

const makeLecture = () => {
  for (const name of ["free_symmetric_top", "nutation_plots", "cones_explained", "heavy_top"]) fs.copyFileSync(`${scenes}/${name}.toml`, `${place}/${name}.toml`);
  const scene = fs.readFileSync(`${scenes}/free_symmetric_top.toml`, "utf8").replace(/^title = .*$/m, `title = '''${hostile}'''`);
  fs.writeFileSync(`${place}/hostile.toml`, `${scene}\n[show]\nnames = { omega = '''${hostile}''', momentum = "L\\u2028</script>" }\n[[story]]\nat = 1\nhold = 1\ncaption = '''${hostile}'''\n`);
  const small = "size=640x360 fps=10";
  // without text, for which films leave room, and without a floor, on which models have no shadow
  const bare = "labels = false\nclock = false\nfloor = false\n";
  fs.writeFileSync(`${place}/bare_free.toml`, `${fs.readFileSync(`${scenes}/free_symmetric_top.toml`, "utf8")}\n[show]\n${bare}`);
  fs.writeFileSync(`${place}/bare_waves.toml`, fs.readFileSync(`${scenes}/nutation_plots.toml`, "utf8").replace(/^plots = .*$/m, bare).replace(/^floor = true$/m, ""));
  fs.writeFileSync(`${place}/deck.md`, `---
title: "Turn it ${hostile.replaceAll('"', "'").replaceAll("<", "&lt;")}"
---

# Tops

## Three

![The free top](free_symmetric_top.toml){ .turn ${small} clock=both vary="motion.spin.rates_deg_per_s[2] 10 800 Spin, °/s; motion.attitude.zxz_deg[1] 5 85" }

## Waves

![Waves](nutation_plots.toml){ .turn ${small} clock=both }

## The story

![The story](cones_explained.toml){ .turn ${small} to=4 }

## Words that are code

![Hostile](hostile.toml){ #hostile .turn ${small} to=2 alt="</script><b>x" vary="motion.spin.rates_deg_per_s[2] 10 800 </script><img src=x onerror=hack()>" }

## Bare

![Bare](bare_free.toml){ .turn ${small} to=2 }

## Bare waves

![Bare waves](bare_waves.toml){ .turn ${small} to=0.2 }

## Core

![Both on one slide](bare_free.toml){ #left .turn ${small} to=2 clock=slide }

![Both on one slide](heavy_top.toml){ #right .turn ${small} to=2 clock=slide }
`);
  run("lecture", `${place}/deck.md`, "-o", `${place}/out`, "--to", "html,slides,pptx", "--quiet");
};

// rows of `simulate`: time, attitude
const attitudeAt = (scene, t, ...settings) => {
  const table = run("simulate", `${place}/${scene}.toml`, "-o", "-", "--rate", String(1 / t), ...settings.flatMap((one) => ["--set", one])).split("\n");
  const [time, ...q] = table[2].split(",").map(Number);
  assert.ok(Math.abs(time - t) < 1e-9);
  return q.slice(0, 4);
};

(async () => {
  makeLecture();
  // WebGL by software, as on a machine without a graphics card
  const gl = ["--enable-unsafe-swiftshader"];
  const sandbox = process.getuid() === 0 ? ["--no-sandbox"] : [];
  const browser = await chromium.launch({ executablePath: browserPath, args: [...gl, ...sandbox] });
  const problems = [];
  const newPage = async (settings = {}, from = browser) => {
    const context = await from.newContext({ viewport: { width: 1280, height: 900 }, offline: true, ...settings });
    const page = await context.newPage();
    page.on("pageerror", (error) => problems.push(error.message));
    page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
    page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || problems.push("asks for " + request.url()));
    return page;
  };
  const page = await newPage();
  const shot = async (name, on = page) => pictures && on.screenshot({ path: `${pictures}/turn-${name}.png` });
  const figure = (index) => page.locator("figure[data-turn]").nth(index);
  const until = async (what, work) => {
    for (let i = 0; i < 150; ++i) {
      if (await work()) return;
      await page.waitForTimeout(100);
    }
    assert.fail(what);
  };
  const settled = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const inPage = (index, body, argument) => page.evaluate(`(() => { const viewer = document.querySelectorAll("figure[data-turn]")[${index}].viewer; const given = ${JSON.stringify(argument ?? null)}; ${body} })()`);
  const accessible = async () => {
    await page.evaluate(axe);
    const found = await page.evaluate(async () => (await globalThis.axe.run()).violations.map((one) => `${one.id}: ${one.nodes[0].html.slice(0, 160)}`));
    assert.deepStrictEqual(found, []);
  };

  // from the address to a page with everything on it, and on to the first picture of a viewer; medians of three, ms
  await check("it loads in less than two seconds", async () => {
    const loads = [], opens = [];
    for (let i = 0; i < 3; ++i) {
      const fresh = await newPage();
      await fresh.goto(`file://${place}/out/index.html`);
      loads.push(await fresh.evaluate(() => performance.getEntriesByType("navigation")[0].loadEventEnd));
      opens.push(await fresh.evaluate(async () => {
        const before = performance.now();
        document.querySelector("button.turn-start").click();
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        document.querySelector("figure[data-turn]").viewer.renderer.getContext().finish();
        return performance.now() - before;
      }));
      await fresh.context().close();
    }
    const median = (list) => list.sort((a, b) => a - b)[1];
    assert.ok(median(loads) > 0 && median(loads) < 2000 && median(opens) < 2000, `${loads} and ${opens} ms`);
    return `page ${median(loads).toFixed(0)} ms, then viewer ${median(opens).toFixed(0)} ms`;
  });

  await check("the page is there without what viewers need", async () => {
    await page.goto(`file://${place}/out/index.html`);
    assert.strictEqual(await page.evaluate(() => typeof globalThis.THREE), "undefined");
  });

  await check("a key starts a viewer, and it plays", async () => {
    await figure(0).getByRole("button", { name: "Turn it by hand" }).focus();
    await page.keyboard.press("Enter");
    await until("playing", async () => inPage(0, "return viewer && viewer.clock.time > 0.1"));
    await page.keyboard.press("Space");
    assert.strictEqual(await inPage(0, "return viewer.clock.playing"), false);
  });
  await shot("free-top");

  // how far the attitude that is shown is from that of `simulate`, at the worst of these times
  const worstAttitude = async (index, scene, times, ...settings) => {
    const range = figure(index).getByRole("slider", { name: "Time" });
    let worst = 0;
    for (const t of times) {
      await range.fill(String(t));
      await settled();
      const matrix = await inPage(index, "return viewer.model.node('space').matrixWorld.clone().invert().multiply(viewer.body.matrixWorld).elements");
      const [w, x, y, z] = attitudeAt(scene, t, ...settings);
      const exact = [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)];
      exact.forEach((value, i) => (worst = Math.max(worst, Math.abs(value - matrix[4 * Math.floor(i / 3) + (i % 3)]))));
    }
    return worst;
  };
  await check("the slider sets the time exactly", async () => {
    const worst = await worstAttitude(0, "free_symmetric_top", [1.5, 3.7, 8.25]);
    // between keys: a tenth of a pixel
    assert.ok(worst < 2e-4, `off by ${worst}`);
    return `within ${worst.toExponential(1)}`;
  });

  // the page computes with Polhode itself, where that was compiled for it
  const computes = await page.evaluate(() => document.querySelector("script[data-core]") !== null);
  const spin = figure(0).getByRole("slider", { name: "Spin, °/s" });
  const answered = (index) => until("an answer", async () => inPage(index, "return viewer.told.textContent !== 'computing …'"));
  if (!computes) console.log("no sliders: this program was built without Emscripten");
  if (computes) await check("a slider computes the motion anew, as simulate does", async () => {
    await spin.fill("310");
    await answered(0);
    const settings = ["motion.spin.rates_deg_per_s[2]=310"];
    const worst = await worstAttitude(0, "free_symmetric_top", [1.5, 3.7, 8.25], ...settings);
    assert.ok(worst < 2e-4, `off by ${worst}`);
    // at key times: single precision
    const keys = await inPage(0, "const track = viewer.model.tracks.find((one) => one.node === viewer.body && one.path === 'rotation'); return [40, 111, 222].map((i) => [track.times[i], ...track.values.slice(4 * i, 4 * i + 4)])");
    for (const [t, ...q] of keys) {
      const [w, x, y, z] = attitudeAt("free_symmetric_top", t, ...settings);
      const far = Math.min(...[1, -1].map((sign) => Math.hypot(q[0] - sign * x, q[1] - sign * y, q[2] - sign * z, q[3] - sign * w)));
      assert.ok(far < 3e-7, `${t}: ${far}`);
    }
    // the numbers beside it are those of the new motion, in seven digits
    const [omega, energy] = await inPage(0, "return [viewer.data.series.omega[0], viewer.data.series.energy[0]]");
    const table = run("simulate", `${place}/free_symmetric_top.toml`, "-o", "-", "--set", settings[0]).split("\n").map((row) => row.split(","));
    const of = (name) => Number(table[1][table[0].indexOf(name)]);
    const exact = Math.hypot(of("wx"), of("wy"), of("wz"));
    assert.ok(Math.abs(omega - exact) <= 1e-6 * exact, `${omega} is not ${exact}`);
    assert.ok(Math.abs(energy - of("energy")) <= 1e-6 * of("energy"), `${energy} is not ${of("energy")}`);
    await shot("slider");
    const took = [];
    for (let i = 0; i < 5; ++i) {
      await spin.fill(String(320 + 20 * i));
      await answered(0);
      took.push(await inPage(0, "return viewer.took"));
    }
    return `${took.map((one) => one.toFixed(0)).join(" ")} ms each`;
  });
  if (computes) await check("it plays on while a slider is moved", async () => {
    await inPage(0, "viewer.clock.loops = true; viewer.clock.play()");
    const rate = await page.evaluate(async () => {
      const viewer = document.querySelector("figure[data-turn]").viewer;
      let drawn = 0;
      const draw = viewer.draw.bind(viewer);
      viewer.draw = () => { ++drawn; draw(); };
      const before = performance.now();
      for (let i = 0; i < 40; ++i) {
        viewer.vary(0, 100 + 10 * i);
        await new Promise((done) => setTimeout(done, 50));
      }
      delete viewer.draw;
      return (1000 * drawn) / (performance.now() - before);
    });
    await answered(0);
    assert.strictEqual(await inPage(0, "return viewer.values[0].value"), 490);
    await inPage(0, "viewer.clock.pause(); viewer.clock.loops = false");
    assert.ok(rate > 0);
    return `${rate.toFixed(0)} frames/s`;
  });
  if (computes) await check("what cannot be computed is told, and the motion stays", async () => {
    const before = await inPage(0, "return viewer.model.about.scene");
    await inPage(0, "viewer.data.request.method = 'nonsense'; viewer.vary(0, 200)");
    await answered(0);
    assert.match(await figure(0).locator(".sliders > output").textContent(), /nonsense/);
    assert.strictEqual(await inPage(0, "return viewer.model.about.scene"), before);
    await inPage(0, "delete viewer.data.request.method");
    await figure(0).getByRole("button", { name: "Starting values as in the film" }).click();
    await answered(0);
    const worst = await worstAttitude(0, "free_symmetric_top", [3.7]);
    assert.ok(worst < 2e-4, `off by ${worst}`);
    assert.strictEqual(await figure(0).locator(".sliders > output").textContent(), "");
  });
  if (computes) await check("keys move a slider, and a link brings it back", async () => {
    await spin.focus();
    await page.keyboard.press("ArrowRight");
    await answered(0);
    const value = await inPage(0, "return viewer.values[0].value");
    assert.ok(Math.abs(value - (72 + 7.9)) < 1e-6, String(value));
    const link = await inPage(0, "return viewer.link()");
    const other = await newPage();
    await other.goto(`file://${place}/out/index.html${link}`);
    await other.waitForFunction(() => document.querySelector("figure[data-turn]").viewer?.told.textContent === "");
    assert.strictEqual(await other.evaluate(() => document.querySelector("figure[data-turn]").viewer.values[0].value), value);
    await other.context().close();
    await figure(0).getByRole("button", { name: "Starting values as in the film" }).click();
    await answered(0);
  });

  await check("a drag turns the camera by the angle that it should, the height of the picture by half a turn", async () => {
    await inPage(0, "viewer.look('film')");
    await settled();
    const direction = () => inPage(0, "const m = viewer.middle.matrixWorld.elements; return viewer.camera.position.clone().sub({ x: m[12], y: m[13], z: m[14] }).toArray()");
    const azimuth = (v) => Math.atan2(v[0], v[2]);
    const before = await direction();
    const box = await figure(0).locator("canvas").boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - box.height / 4, y, { steps: 5 });
    await page.mouse.up();
    await settled();
    const after = await direction();
    const turned = (azimuth(after) - azimuth(before)) % (2 * Math.PI);
    assert.ok(Math.abs(turned - Math.PI / 4) < 0.01, `${turned}`);
    assert.ok(Math.abs(Math.hypot(...after) - Math.hypot(...before)) < 1e-6);
    await page.mouse.wheel(0, -200);
    await settled();
    assert.ok(Math.hypot(...(await direction())) < 0.9 * Math.hypot(...before));
  });

  await check("views along L, Omega and the axis look along them", async () => {
    for (const name of ["along_momentum", "along_omega", "along_axis"]) {
      await figure(0).getByRole("combobox", { name: "View" }).selectOption(name);
      await settled();
      const cosine = await inPage(0, "const d = viewer.camera.getWorldDirection(viewer.camera.position.clone()); const e = viewer.model.node(given).matrixWorld.elements; const l = Math.hypot(e[8], e[9], e[10]); return -(d.x * e[8] + d.y * e[9] + d.z * e[10]) / l", name);
      assert.ok(cosine > 1 - 1e-6, `${name}: ${cosine}`);
    }
    await shot("along-axis");
  });

  await check("in the body's frame the body stands still in the picture", async () => {
    await figure(0).getByRole("combobox", { name: "View" }).selectOption("film");
    await figure(0).getByRole("combobox", { name: "Frame of reference" }).selectOption("body");
    const seen = async (t) => {
      await inPage(0, "viewer.clock.set(given)", t);
      await settled();
      return inPage(0, "return viewer.camera.matrixWorldInverse.clone().multiply(viewer.body.matrixWorld).elements");
    };
    const a = await seen(0.5), b = await seen(3.1);
    assert.ok(Math.max(...a.map((value, i) => Math.abs(value - b[i]))) < 1e-5);
    await figure(0).getByRole("combobox", { name: "Frame of reference" }).selectOption("space");
  });

  await check("ticks hide what they name, and its label", async () => {
    const tick = figure(0).getByRole("checkbox", { name: "omega", exact: true });
    await tick.uncheck();
    await settled();
    assert.strictEqual(await inPage(0, "return viewer.model.node('omega').visible"), false);
    assert.strictEqual(await inPage(0, "return viewer.labels.find((one) => one.label.includes('Ω')).tip.style.display"), "none");
    await tick.check();
    await settled();
    assert.strictEqual(await inPage(0, "return viewer.labels.find((one) => one.label.includes('Ω')).tip.style.display"), "");
  });

  await check("names stay in the picture, and do not cover each other", async () => {
    const boxes = await inPage(0, `viewer.look("film"); const found = [];
      for (let i = 0; i <= 20; ++i) {
        viewer.clock.set((i / 20) * viewer.duration);
        viewer.magnify(1.06); // out of the picture at last
        viewer.draw();
        const all = viewer.picture.getBoundingClientRect();
        found.push(viewer.labels.filter((one) => one.tip.style.display === "").map(({ tip }) => { const box = tip.getBoundingClientRect(); return [box.left + box.width / 2 - all.left, box.top + box.height / 2 - all.top, all.right - box.left - box.width / 2, all.bottom - box.top - box.height / 2]; }));
      }
      viewer.look("film");
      return found;`);
    for (const moment of boxes) {
      for (const box of moment) assert.ok(Math.min(...box) > 15, String(box));
      for (const [i, a] of moment.entries()) for (const b of moment.slice(0, i)) assert.ok(Math.abs(a[0] - b[0]) > 11 || Math.abs(a[1] - b[1]) > 13, `${a} ${b}`);
    }
    assert.ok(boxes[0].length > 3 && boxes[20].length < boxes[0].length, String(boxes.map((one) => one.length)));
  });

  await check("two viewers have one clock; a plot shows the time and sets it", async () => {
    await figure(1).getByRole("button", { name: "Turn it by hand" }).click();
    await until("second viewer", async () => inPage(1, "return Boolean(viewer)"));
    await inPage(1, "viewer.clock.pause()");
    await inPage(0, "viewer.clock.set(2)");
    assert.strictEqual(await inPage(1, "return viewer.clock.time"), 2);
    // speed and repeat are the clock's, too, and each says so
    await figure(0).getByRole("combobox", { name: "Speed" }).selectOption("0.25");
    await figure(0).getByRole("button", { name: "Repeat" }).click();
    await settled();
    assert.strictEqual(await figure(1).getByRole("combobox", { name: "Speed" }).inputValue(), "0.25");
    assert.strictEqual(await figure(1).getByRole("button", { name: "Repeat" }).getAttribute("aria-pressed"), "true");
    await figure(1).getByRole("button", { name: "Repeat" }).click();
    await figure(1).getByRole("combobox", { name: "Speed" }).selectOption("1");
    // numbers are those of the time also where the picture is not seen
    const tilt = () => inPage(1, "return viewer.numbers['θ'].textContent");
    const seen = [];
    for (const out of [false, true]) {
      await inPage(1, "viewer.picture.style.transform = given ? 'translateY(-20000px)' : ''", out);
      await until("out of sight", async () => (await inPage(1, "return viewer.seen")) === !out);
      await inPage(1, "viewer.clock.set(0.7)");
      await settled();
      await inPage(1, "viewer.clock.set(1.9)");
      await settled();
      seen.push(await tilt());
    }
    assert.strictEqual(seen[1], seen[0]);
    await inPage(1, "viewer.picture.style.transform = ''; viewer.clock.set(2)");
    const plot = figure(1).locator(".curves svg").first();
    const box = await plot.boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await settled();
    const [t, to, cursor] = await inPage(1, "return [viewer.t, viewer.data.to, Number(viewer.cursors[0].getAttribute('x1'))]");
    assert.ok(Math.abs(t - to / 2) < 0.01 * to, `${t} of ${to}`);
    assert.ok(Math.abs(cursor - 50) < 1);
    await shot("plots");
  });

  await check("a path is drawn by one call, as far as it has come", async () => {
    const lengths = [];
    for (const part of [0.1, 0.5, 0.9, 0.3]) {
      await inPage(1, "viewer.clock.set(given * viewer.duration)", part);
      await settled();
      const [drawn, there] = await inPage(1, "const path = viewer.model.paths[0]; return [path.shape.drawRange.count, path.triangles.filter((_, i) => path.pieces[i].visible).reduce((sum, one) => sum + one.length, 0)]");
      assert.strictEqual(drawn, there);
      lengths.push(drawn);
    }
    const [early, middle, late, again] = lengths;
    assert.ok(0 < early && early < again && again < middle && middle < late, String(lengths));
  });

  await check("without a graphics card, edges are smooth when the picture rests", async () => {
    const across = () => inPage(0, "return viewer.canvas.width / Math.floor(viewer.picture.clientWidth)");
    await figure(0).scrollIntoViewIfNeeded();
    await inPage(0, "viewer.clock.set(1)");
    await page.waitForTimeout(600);
    assert.strictEqual(await across(), 2);
    await inPage(0, "viewer.turn(0.01, 0)");
    await settled();
    assert.ok((await across()) <= 1);
  });

  await check("a link brings back view and time", async () => {
    await inPage(0, "viewer.look('along_omega'); viewer.turn(0.3, -0.2); viewer.magnify(1.5); viewer.show('body', false); viewer.clock.set(4.2)");
    const link = await inPage(0, "return viewer.link()");
    await page.goto("about:blank");
    await page.goto(`file://${place}/out/index.html${link}`);
    await until("viewer", async () => inPage(0, "return Boolean(viewer)"));
    const state = await inPage(0, "return [viewer.view, viewer.yaw, viewer.pitch, viewer.zoom, viewer.clock.time, viewer.model.node('body').visible]");
    assert.deepStrictEqual(state, ["along_omega", 0.3, -0.2, 1.5, 4.2, false]);
  });

  await check("pause points stop it, with their words", async () => {
    await figure(2).getByRole("button", { name: "Turn it by hand" }).click();
    await until("viewer", async () => inPage(2, "return Boolean(viewer)"));
    const at = await inPage(2, "return viewer.clock.pauses");
    assert.ok(at.length > 0);
    await inPage(2, "viewer.clock.pause(); viewer.clock.set(given - 0.2); viewer.clock.play()", at[0]);
    await until("stopped", async () => inPage(2, "return !viewer.clock.playing"));
    assert.strictEqual(await inPage(2, "return viewer.clock.time"), at[0]);
    // a frame that ends a rounding error before it is at the stop
    const near = await inPage(2, "viewer.clock.set(given - 0.1); viewer.clock.playing = true; viewer.clock.before = 1000; viewer.clock.tick(1100 - 1e-9); return [viewer.clock.time, viewer.clock.playing]", at[0]);
    assert.deepStrictEqual(near, [at[0], false]);
    await settled();
    assert.notStrictEqual(await figure(2).locator(".said").textContent(), "");
    await figure(2).getByRole("button", { name: /^Pause point 1/ }).click();
    assert.strictEqual(await inPage(2, "return viewer.clock.time * viewer.data.scale + viewer.data.from"), await inPage(2, "return viewer.data.pauses[0].at"));
  });

  await check("what the story shows and hides comes and goes with it, until a tick is used", async () => {
    const shown = async (t) => {
      await inPage(2, "viewer.clock.pause(); viewer.clock.set(given)", t);
      await settled();
      return inPage(2, "return ['omega', 'momentum'].map((name) => viewer.model.node(name).visible && viewer.ticks.get(name).tick.checked)");
    };
    assert.deepStrictEqual(await shown(1), [false, false]);
    assert.deepStrictEqual(await shown(3), [true, false]);
    assert.deepStrictEqual(await shown(4), [true, true]);
    await figure(2).getByRole("checkbox", { name: "momentum", exact: true }).uncheck();
    assert.deepStrictEqual(await shown(4), [true, false]);
    await figure(2).getByRole("checkbox", { name: "momentum", exact: true }).check();
    assert.deepStrictEqual(await shown(1), [false, true]);
    await figure(2).getByRole("button", { name: "Turn back" }).click();
    assert.deepStrictEqual(await shown(1), [false, false]);
  });

  await check("hostile titles and labels stay words", async () => {
    await figure(3).getByRole("button", { name: "Turn it by hand" }).click();
    await until("viewer", async () => inPage(3, "return Boolean(viewer)"));
    await inPage(3, "viewer.clock.pause(); viewer.clock.set(1.5)");
    await settled();
    assert.strictEqual(await page.evaluate(() => globalThis.hacked), undefined);
    assert.ok((await inPage(3, "return viewer.labels.map((one) => one.tip.textContent)")).some((text) => text.includes("onerror")));
    assert.strictEqual(await figure(3).locator(".tip img, .tip script, .said img").count(), 0);
    assert.strictEqual(await figure(3).locator(".sliders img").count(), 0);
    if (computes) assert.match(await figure(3).locator(".sliders").textContent(), /onerror=hack/);
    await shot("hostile");
  });

  await check("everything is reached by keys and has a name", async () => {
    await accessible();
    await figure(0).locator("canvas").focus();
    await inPage(0, "viewer.clock.pause(); viewer.clock.set(0); viewer.look('film')");
    await page.keyboard.press(".");
    assert.ok(Math.abs((await inPage(0, "return viewer.clock.time")) - 0.1) < 1e-9);
    await page.keyboard.press("ArrowRight");
    assert.ok((await inPage(0, "return viewer.yaw")) > 0.05);
    await page.keyboard.press("+");
    assert.ok((await inPage(0, "return viewer.zoom")) > 1.05);
    const names = [];
    for (let i = 0; i < 30; ++i) {
      await page.keyboard.press("Tab");
      names.push(await page.evaluate(() => document.activeElement.getAttribute("aria-label") ?? document.activeElement.textContent.trim() ?? ""));
    }
    for (const wanted of ["Time", "Play", "−1 frame", "+1 frame", "Speed", "Repeat", "View", "Frame of reference", "Turn back", "Full screen", "Back to the film"]) assert.ok(names.includes(wanted), `${wanted} not in ${names}`);
  });

  await check("back to the film, and to the model again", async () => {
    await figure(0).getByRole("button", { name: "Back to the film" }).click();
    assert.ok(await figure(0).locator("video").isVisible());
    await figure(0).getByRole("button", { name: "Turn it by hand" }).click();
    assert.ok(await figure(0).locator("canvas").isVisible());
  });

  await check("it looks as the film does", async () => {
    const said = [];
    for (const [name, t] of [["bare_free", 1], ["bare_waves", 0.1]]) {
      const other = await newPage({ viewport: { width: 700, height: 900 } });
      await other.goto(`file://${place}/out/index.html#turn=${name}&t=${t}`);
      await other.waitForTimeout(1500);
      await other.addStyleTag({ content: ".turning { position: fixed !important; left: 0; top: 0; z-index: 9; width: 640px !important; height: 360px !important; aspect-ratio: auto !important; } .tip { display: none !important; } canvas { outline: none !important; }" });
      await other.waitForTimeout(800);
      await other.screenshot({ path: `${place}/page.png`, clip: { x: 0, y: 0, width: 640, height: 360 } });
      run("render", `${place}/${name}.toml`, "-o", `${place}/film.png`, "--still", String(t), "--size", "640x360", "--quiet");
      if (pictures) for (const which of ["page", "film"]) fs.copyFileSync(`${place}/${which}.png`, `${pictures}/turn-${name}-${which}.png`);
      let out = "";
      try {
        out = run("diff", `${place}/page.png`, `${place}/film.png`, "--json", "--ssim", "0.1");
      } catch (error) {
        assert.strictEqual(error.status, 1, error.stderr); // they differ
        out = error.stdout;
      }
      const ssim = Number(JSON.parse(out).ssim);
      said.push(ssim);
      assert.ok(ssim > LEAST_SSIM, `${name}: SSIM ${ssim}`);
      await other.context().close();
    }
    return `SSIM ${said.join(" ")}`;
  });

  await check("what a table hides is dashed as in the film", async () => {
    // L of a ball that spins downwards: through the ball, and then below the table
    fs.writeFileSync(`${place}/below.toml`, `format = 1
title = "Below"
[body]
solid = { kind = "sphere", radius_mm = 40, mass_g = 300 }
[motion]
hold = "table"
duration = 1
spin = { space = [0, 0, -20] }
friction = { kind = "coulomb", mu = 0.2 }
[show]
vector_length = 1.6
space_axes = false
omega = false
contact = false
labels = false
clock = false
`);
    fs.writeFileSync(`${place}/below.md`, `![Below](below.toml){ .turn size=640x360 fps=10 }\n`);
    run("lecture", `${place}/below.md`, "-o", `${place}/below`, "--to", "html", "--quiet");
    const other = await newPage({ viewport: { width: 700, height: 900 } });
    await other.goto(`file://${place}/below/index.html#turn=below&t=0`);
    await other.waitForTimeout(1500);
    await other.addStyleTag({ content: ".turning { position: fixed !important; left: 0; top: 0; z-index: 9; width: 640px !important; height: 360px !important; aspect-ratio: auto !important; } .tip { display: none !important; } canvas { outline: none !important; }" });
    await other.waitForTimeout(800);
    await other.screenshot({ path: `${place}/page.png`, clip: { x: 0, y: 0, width: 640, height: 360 } });
    run("render", `${place}/below.toml`, "-o", `${place}/film.png`, "--still", "0", "--size", "640x360", "--quiet");
    // how often the blue of L ends from one row to the next, and in how many rows it is
    const dashes = (file) =>
      other.evaluate(async (url) => {
        const image = new Image();
        image.src = url;
        await image.decode();
        const canvas = new OffscreenCanvas(640, 360);
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, 640, 360);
        const blue = Array.from({ length: 360 }, (_, y) => {
          for (let x = 0; x < 640; ++x) {
            const [r, , b] = data.subarray(4 * (640 * y + x));
            if (b > 130 && b - r > 75) return true;
          }
          return false;
        });
        return { ends: blue.filter((now, y) => now && !blue[y + 1]).length, rows: blue.filter(Boolean).length };
      }, `data:image/png;base64,${fs.readFileSync(`${place}/${file}.png`).toString("base64")}`);
    const film = await dashes("film");
    const page = await dashes("page");
    assert.ok(film.ends > 8, `${film.ends} dashes in the film`);
    assert.ok(Math.abs(page.ends - film.ends) <= 2, `${page.ends} dashes on the page, ${film.ends} in the film`);
    assert.ok(Math.abs(page.rows - film.rows) <= 0.2 * film.rows, `${page.rows} rows on the page, ${film.rows} in the film`);
    await other.context().close();
    return `${page.ends} and ${film.ends} dashes, ${page.rows} and ${film.rows} rows`;
  });

  await check("as wide as a phone", async () => {
    await page.setViewportSize({ width: 375, height: 700 });
    await page.waitForTimeout(300);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 375);
    await accessible();
    await figure(0).scrollIntoViewIfNeeded();
    await shot("phone");
  });

  await check("one finger turns, two fingers zoom", async () => {
    const phone = await newPage({ viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true });
    await phone.goto(`file://${place}/out/index.html`);
    await phone.getByRole("button", { name: "Turn it by hand" }).first().tap();
    await phone.waitForFunction(() => document.querySelector("figure[data-turn]").viewer);
    const canvas = phone.locator("figure[data-turn] canvas").first();
    await canvas.scrollIntoViewIfNeeded();
    const state = () => phone.evaluate(() => { const { yaw, pitch, zoom } = document.querySelector("figure[data-turn]").viewer; return { yaw, pitch, zoom }; });
    const box = await canvas.boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const client = await phone.context().newCDPSession(phone);
    const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })) });
    const scrolled = await phone.evaluate(() => scrollY);
    await touch("touchStart", [x, y]);
    for (let i = 1; i <= 5; ++i) await touch("touchMove", [x - (i * box.height) / 20, y + (i * box.height) / 40]);
    await touch("touchEnd");
    const turned = await state();
    assert.ok(Math.abs(turned.yaw - Math.PI / 4) < 0.02 && Math.abs(turned.pitch + Math.PI / 8) < 0.02, JSON.stringify(turned));
    await touch("touchStart", [x - 20, y], [x + 20, y]);
    for (let i = 1; i <= 5; ++i) await touch("touchMove", [x - 20 - 4 * i, y], [x + 20 + 4 * i, y]);
    await touch("touchEnd");
    const larger = await state();
    assert.ok(Math.abs(larger.zoom - 2) < 0.05, JSON.stringify(larger));
    assert.deepStrictEqual([larger.yaw, larger.pitch], [turned.yaw, turned.pitch]);
    assert.strictEqual(await phone.evaluate(() => scrollY), scrolled);
    await phone.context().close();
  });

  await check("memory stays flat while it plays", async () => {
    await page.setViewportSize({ width: 1280, height: 900 });
    await figure(0).scrollIntoViewIfNeeded();
    const client = await page.context().newCDPSession(page);
    await client.send("HeapProfiler.enable");
    const used = async () => {
      await client.send("HeapProfiler.collectGarbage");
      return (await client.send("Runtime.getHeapUsage")).usedSize;
    };
    await inPage(0, "viewer.clock.loops = true; viewer.clock.pauses = []; viewer.clock.play()");
    await page.waitForTimeout(5000);
    const before = await used();
    const minutes = Number(process.env.POLHODE_MINUTES ?? 5);
    await page.waitForTimeout(60000 * minutes);
    const after = await used();
    assert.ok(await inPage(0, "return viewer.clock.playing"));
    assert.ok(after < before + 2e6, `${before} to ${after} bytes`);
    await inPage(0, "viewer.clock.pause()");
    return `${(before * 1e-6).toFixed(1)} to ${(after * 1e-6).toFixed(1)} MB in ${minutes} min`;
  });

  await check("whoever wants no movement gets none before asking", async () => {
    const calm = await newPage({ reducedMotion: "reduce" });
    await calm.goto(`file://${place}/out/index.html`);
    await calm.locator("figure[data-turn]").first().getByRole("button", { name: "Turn it by hand" }).click();
    await calm.waitForTimeout(800);
    assert.strictEqual(await calm.evaluate(() => document.querySelector("figure[data-turn]").viewer.clock.time), 0);
  });

  await check("slides carry viewers", async () => {
    const slides = await newPage({ viewport: { width: 1280, height: 720 } });
    await slides.goto(`file://${place}/out/slides.html`);
    await slides.waitForTimeout(500);
    await slides.evaluate(() => { const at = Reveal.getIndices(document.querySelector("figure[data-turn]").closest("section")); Reveal.slide(at.h, at.v); });
    await slides.getByRole("button", { name: "Turn it by hand" }).first().click();
    await slides.waitForTimeout(1000);
    const state = await slides.evaluate(() => { const one = document.querySelector("figure[data-turn]"); const box = one.viewer.canvas.getBoundingClientRect(); return [one.viewer.clock.time > 0, box.width, box.height]; });
    assert.ok(state[0] && state[1] > 300 && state[2] > 200, String(state));
    // keys of the viewer are not those of the slides
    const where = await slides.evaluate(() => Reveal.getIndices().h);
    await slides.keyboard.press("ArrowRight");
    assert.strictEqual(await slides.evaluate(() => Reveal.getIndices().h), where);
    await shot("slide", slides);
    // a clicker goes on, also behind a press of a button, and the film that is not seen does not wait
    await slides.locator("figure[data-turn] .turn-bar button, figure[data-turn] [role=group] button").filter({ visible: true }).first().focus();
    await slides.keyboard.press("PageDown");
    await slides.waitForFunction((before) => Reveal.getIndices().h !== before || Reveal.getIndices().v > 0, where);
    assert.strictEqual(await slides.evaluate(() => document.querySelector(".hint").textContent), "");
  });

  await check("two viewers on one slide have one clock", async () => {
    const slides = await newPage({ viewport: { width: 1280, height: 720 } });
    await slides.goto(`file://${place}/out/slides.html`);
    await slides.waitForTimeout(500);
    await slides.evaluate(() => { const at = Reveal.getIndices(document.querySelector("figure[data-clock=slide]").closest("section")); Reveal.slide(at.h, at.v); });
    const both = slides.locator("figure[data-clock=slide]");
    assert.strictEqual(await both.count(), 2);
    for (const i of [0, 1]) await both.nth(i).getByRole("button", { name: "Turn it by hand" }).click();
    const clocks = () => slides.evaluate(() => [...document.querySelectorAll("figure[data-clock=slide]")].map(({ viewer }) => ({ time: viewer.clock.time, t: viewer.t, same: viewer.clock.watchers.length, width: viewer.canvas.getBoundingClientRect().width, height: viewer.canvas.getBoundingClientRect().height })));
    await slides.waitForFunction(() => document.querySelector("figure[data-clock=slide]").viewer.clock.time > 0.2);
    await slides.evaluate(() => document.querySelector("figure[data-clock=slide]").viewer.clock.pause());
    const [a, b] = await clocks();
    assert.ok(a.same === 2 && a.time === b.time && a.t === b.t, JSON.stringify([a, b]));
    for (const one of [a, b]) assert.ok(one.width > 200 && one.height > 100, JSON.stringify(one));
    await shot("slide-of-two", slides);
    await slides.context().close();
  });

  await check("without WebGL the film is shown", async () => {
    const bare = await chromium.launch({ executablePath: browserPath, args: ["--disable-gpu", "--disable-3d-apis", ...sandbox] });
    const plain = await newPage({}, bare);
    await plain.goto(`file://${place}/out/index.html`);
    assert.ok(await plain.locator("figure[data-turn] video").first().isVisible());
    assert.strictEqual(await plain.getByRole("button", { name: "Turn it by hand" }).count(), 0);
    await bare.close();
  });

  assert.deepStrictEqual(problems, []);
  await browser.close();
  fs.rmSync(place, { recursive: true });
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
