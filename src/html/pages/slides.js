// The films of a slide play when it comes, stop where the story pauses, and go on at the next press.
"use strict";
const hint = document.querySelector(".hint");
const say = (words) => {
  if (hint.textContent === words) return;
  hint.textContent = words;
  hint.classList.toggle("shown", words !== "");
};
const pausesOf = (video) => (video.dataset.pauses || "").split(",").filter((one) => one !== "").map((one) => one.split(" ").map(Number));
// not those in whose place a model is turned
const shown = () => [...(Reveal.getCurrentSlide()?.querySelectorAll("video") ?? [])].filter((video) => !video.closest("[hidden]"));

// the stop that a film stands at, if it does
const waiting = new Map();
const watch = (video) => {
  if (!video.paused) {
    const last = Number(video.dataset.last ?? -1);
    const stop = pausesOf(video).find(([begins]) => begins > last && video.currentTime >= begins);
    if (stop) {
      video.dataset.last = String(stop[0]);
      if (stop[1] < video.duration - 0.02 || stop[0] > 0) {
        waiting.set(video, stop[1]);
        video.pause();
        // what comes at the pause has come by its end
        video.currentTime = Math.max(stop[0], Math.min(stop[1], video.duration) - 1.5 / Number(video.dataset.fps));
      }
    }
  }
  requestAnimationFrame(() => watch(video));
};
const tell = () => {
  say(shown().some((video) => waiting.has(video)) ? "Paused: space goes on" : "");
  requestAnimationFrame(tell);
};
requestAnimationFrame(tell);
for (const video of document.querySelectorAll("video")) {
  video.addEventListener("play", () => waiting.delete(video));
  requestAnimationFrame(() => watch(video));
}

const restart = (video) => {
  waiting.delete(video);
  video.dataset.last = "-1";
  video.currentTime = 0;
};
// A slide that holds more than it has room for is made smaller, down to some percent; what is more
// scrolls.
const overflows = (slide) => slide.scrollHeight > slide.clientHeight + 1 || slide.scrollWidth > slide.clientWidth + 1;
const fit = (slide, least) => {
  slide.style.zoom = "";
  for (let percent = 95; percent >= least && overflows(slide); percent -= 5) slide.style.zoom = `${percent}%`;
};
const fitShown = () => {
  const slide = Reveal.getCurrentSlide();
  if (slide) fit(slide, 50);
};
const enter = () => {
  fitShown();
  for (const video of document.querySelectorAll("video")) video.pause();
  for (const video of shown()) {
    restart(video);
    video.play().catch(() => {});
  }
};
// a paused film goes on before the slide does; true: there was one
const goOn = () => {
  let went = false;
  for (const video of shown()) {
    if (!waiting.has(video)) continue;
    video.play().catch(() => {});
    went = true;
  }
  return went;
};
const toggle = () => shown().forEach((video) => {
  if (!video.paused) return video.pause();
  // with its pauses once more
  if (video.ended) restart(video);
  video.play().catch(() => {});
});
const step = (by) => shown().forEach((video) => {
  video.pause();
  const fps = Number(video.dataset.fps);
  video.currentTime = (Math.max(0, Math.floor(video.currentTime * fps + 1e-3) + by) + 0.5) / fps;
});
const next = () => goOn() || Reveal.next();

Reveal.initialize({
  width: 1280, height: 720, margin: 0.02, center: false, display: "flex", controls: false, navigationMode: "linear", hash: true, respondToHashChanges: true,
  transition: "none", backgroundTransition: "none", slideNumber: "c/t", autoPlayMedia: false, preloadIframes: false, pdfMaxPagesPerSlide: 1,
  keyboard: {
    32: next, 39: next, 40: next, 34: next, 78: next,
    75: toggle, 188: () => step(-1), 190: () => step(1),
    84: () => Reveal.configure({ showNotes: !Reveal.getConfig().showNotes }),
  },
}).then(enter);
Reveal.on("slidechanged", enter);
// pictures and letters have come
addEventListener("load", fitShown);
// paper cannot be scrolled
Reveal.on("pdf-ready", () => {
  for (const slide of document.querySelectorAll(".pdf-page > section")) fit(slide, 5);
});
for (const video of document.querySelectorAll("video")) video.addEventListener("click", () => goOn() || toggle());
