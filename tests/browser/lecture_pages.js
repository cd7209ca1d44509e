// SPDX-License-Identifier: MIT
// Opens what `polhode lecture` makes in a real browser, with files and without a network, as a student does.
// usage: lecture_pages.js FOLDER CHROMIUM [FOLDER for screenshots]
"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const { chromium } = require("playwright-core");
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const [folder, browserPath, pictures] = process.argv.slice(2);

const check = async (name, work) => {
  await work();
  console.log("ok", name);
};

(async () => {
  const browser = await chromium.launch({ executablePath: browserPath, args: process.getuid() === 0 ? ["--no-sandbox"] : [] });
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, offline: true });
  const page = await context.newPage();
  const problems = [];
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || problems.push("asks for " + request.url()));
  const shot = async (name) => pictures && page.screenshot({ path: `${pictures}/${name}.png` });
  const open = async (file) => {
    await page.goto("about:blank");
    await page.goto(`file://${folder}/${file}`);
    await page.waitForTimeout(500);
  };
  const film = page.locator("figure.film").first();
  const video = film.locator("video").first();
  const frame = async () => Math.floor((await video.evaluate((one) => one.currentTime * Number(one.dataset.fps))) + 1e-3);
  const press = async (name) => film.getByRole("button", { name, exact: true }).click();
  const until = async (what, work) => {
    for (let i = 0; i < 150; ++i) {
      if (await work()) return;
      await page.waitForTimeout(200);
    }
    assert.fail(what);
  };
  const accessible = async () => {
    await page.evaluate(axe);
    const found = await page.evaluate(async () => (await globalThis.axe.run()).violations.map((one) => `${one.id}: ${one.nodes[0].html.slice(0, 120)}`));
    assert.deepStrictEqual(found, []);
  };

  await open("index.html");
  await check("a film steps frame by frame", async () => {
    await press("+1 frame");
    await until("frame 1", async () => (await frame()) === 1);
    await press("+1 frame");
    await until("frame 2", async () => (await frame()) === 2);
    await press("−1 frame");
    await until("frame 1 again", async () => (await frame()) === 1);
    await video.focus();
    await page.keyboard.press(".");
    await until("frame 2 by key", async () => (await frame()) === 2);
  });
  await check("a film plays to its end, faster", async () => {
    await film.getByRole("combobox", { name: "Speed" }).selectOption("2");
    await press("Play");
    await until("the end", async () => video.evaluate((one) => one.ended));
    assert.strictEqual(await video.evaluate((one) => one.playbackRate), 2);
  });
  await check("captions are there where the story speaks", async () => {
    const cues = await page.evaluate(() => {
      const one = [...document.querySelectorAll("video")].find((each) => each.textTracks.length > 0);
      if (!one) return null;
      one.textTracks[0].mode = "showing";
      return new Promise((done) => setTimeout(() => done(one.textTracks[0].cues.length), 1500));
    });
    assert.ok(cues === null || cues > 0, "no captions");
  });
  await shot("page");
  await check("accessible", accessible);
  await check("the look changes, and stays", async () => {
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const before = await paper();
    await page.click("#Polhode-look");
    assert.notStrictEqual(await paper(), before);
    await accessible();
    await shot("page-dark");
  });
  await check("a link leads to a frame", async () => {
    const name = await page.locator("video").last().getAttribute("data-film");
    await open(`index.html#film=${encodeURIComponent(name)}&frame=7`);
    const last = page.locator(`video[data-film="${name}"]`);
    await until("frame 7", async () => (await last.evaluate((one) => Math.floor(one.currentTime * Number(one.dataset.fps) + 1e-3))) === 7);
    assert.ok(await last.isVisible());
  });
  await check("as wide as a phone", async () => {
    await page.setViewportSize({ width: 375, height: 700 });
    await open("index.html");
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 375);
    await accessible();
    await shot("page-phone");
  });

  if (fs.existsSync(`${folder}/slides.html`)) {
    await page.setViewportSize({ width: 1280, height: 720 });
    await open("slides.html");
    await check("slides go on, and their films play and pause", async () => {
      const count = await page.evaluate(() => Reveal.getTotalSlides());
      assert.ok(count > 2);
      let played = 0;
      for (let i = 0; i < count; ++i) {
        const films = await page.evaluate(() => Reveal.getCurrentSlide().querySelectorAll("video").length);
        if (films > 0) {
          await until(`film of slide ${i}`, async () => page.evaluate(() => Reveal.getCurrentSlide().querySelector("video").currentTime > 0));
          ++played;
        }
        await shot(`slide-${i}`);
        await page.evaluate(() => Reveal.next());
      }
      assert.ok(played > 0);
    });
    await check("a slide that holds too much is made smaller", async () => {
      const [before, after] = await page.evaluate(() => {
        Reveal.slide(1);
        const slide = Reveal.getCurrentSlide();
        const state = () => [slide.currentCSSZoom, slide.scrollHeight <= slide.clientHeight + 1 && slide.scrollWidth <= slide.clientWidth + 1];
        const first = state();
        for (let i = 0; i < 12; ++i) slide.append(Object.assign(document.createElement("p"), { textContent: "a line", className: "more" }));
        Reveal.slide(0);
        Reveal.slide(1);
        const second = state();
        for (const one of slide.querySelectorAll(".more")) one.remove();
        return [first, second];
      });
      assert.deepStrictEqual(before, [1, true]);
      assert.ok(after[0] < 1 && after[1], String(after));
    });
    await check("printed slides have dark letters on white", async () => {
      await page.emulateMedia({ media: "print" });
      const colours = await page.evaluate(() => {
        const style = (selector) => getComputedStyle(document.querySelector(selector));
        return [style(".reveal figcaption").color, style(".reveal").color, style("body").backgroundColor, style("html").backgroundColor];
      });
      const hidden = await page.evaluate(() =>
        [...document.querySelectorAll(".reveal figcaption")].filter((caption) => {
          const picture = [...caption.parentElement.querySelectorAll("video, img")].find((one) => one.getBoundingClientRect().height > 0);
          return picture && caption.getBoundingClientRect().top < picture.getBoundingClientRect().bottom - 1;
        }).map((caption) => caption.textContent));
      await page.emulateMedia({ media: null });
      assert.deepStrictEqual(colours, ["rgb(0, 0, 0)", "rgb(0, 0, 0)", "rgb(255, 255, 255)", "rgb(255, 255, 255)"]);
      assert.deepStrictEqual(hidden, []);
    });
    await check("with ?print-pdf each slide is a page, with all that it holds", async () => {
      const count = await page.evaluate(() => Reveal.getTotalSlides());
      await open("slides.html?print-pdf");
      await until("pages", () => page.evaluate(() => Reveal.isReady() && document.querySelector(".pdf-page") !== null));
      await page.evaluate(() => {
        const slide = document.querySelector(".pdf-page > section:has(figcaption)");
        for (let i = 0; i < 30; ++i) slide.append(Object.assign(document.createElement("p"), { textContent: "a line" }));
        Reveal.dispatchEvent({ type: "pdf-ready" });
      });
      await page.emulateMedia({ media: "print" });
      const [pages, cut] = await page.evaluate(() => {
        const all = [...document.querySelectorAll(".pdf-page")];
        const isCut = (one) => {
          const edge = one.getBoundingClientRect().bottom;
          return [one.querySelector("section"), ...one.querySelectorAll("section > *:not(.notes)")].some((part) => part.getBoundingClientRect().bottom > edge);
        };
        return [all.length, all.filter(isCut).map((one) => one.innerText)];
      });
      await page.emulateMedia({ media: null });
      assert.deepStrictEqual(cut, []);
      assert.ok(pages >= count, `${pages} pages of ${count} slides`);
      await open("slides.html");
    });
    await check("a film with a story waits for its speaker", async () => {
      const index = await page.evaluate(() => {
        const one = document.querySelector('video[data-pauses]:not([data-pauses=""])');
        return one ? Reveal.getIndices(one.closest("section")) : null;
      });
      if (index === null) return;
      await page.evaluate((at) => Reveal.slide(at.h, at.v), index);
      const state = () => page.evaluate(() => { const one = Reveal.getCurrentSlide().querySelector("video"); return [one.paused, one.currentTime]; });
      await until("a pause", async () => { const [paused, time] = await state(); return paused && time > 0; });
      const [, stopped] = await state();
      await page.keyboard.press("Space");
      await until("going on", async () => (await state())[1] > stopped + 0.2);
      // k goes on as well, and plays it once more with its pauses
      await page.evaluate((at) => { Reveal.slide(0); Reveal.slide(at.h, at.v); }, index);
      const hint = () => page.evaluate(() => document.querySelector(".hint").textContent);
      await until("the pause again", async () => (await hint()) !== "");
      await page.keyboard.press("k");
      await until("going on by k", async () => (await state())[1] > stopped + 0.2 && (await hint()) === "");
      await page.evaluate(() => { const one = Reveal.getCurrentSlide().querySelector("video"); one.dataset.last = "1e9"; one.currentTime = one.duration; });
      await until("the end", async () => page.evaluate(() => Reveal.getCurrentSlide().querySelector("video").ended));
      await page.keyboard.press("k");
      await until("the first pause once more", async () => { const [paused, time] = await state(); return paused && Math.abs(time - stopped) < 0.2; });
    });
  }
  assert.deepStrictEqual(problems.filter((one) => !one.includes("ERR_")), []);
  await browser.close();
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
