// Films: frame by frame, slower and faster; a link to a frame; the look of the page.
"use strict";
const speeds = [0.1, 0.25, 0.5, 1, 2];

// seconds from one frame to the next, and the middle of a frame, where a player surely shows it
const frameOf = (video) => Math.floor(video.currentTime * Number(video.dataset.fps) + 1e-3);
const goTo = (video, frame) => {
  const last = Number(video.dataset.frames) - 1;
  video.currentTime = (Math.max(0, Math.min(last, frame)) + 0.5) / Number(video.dataset.fps);
};

const button = (text, label, action) => {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = text;
  made.setAttribute("aria-label", label);
  made.title = label;
  made.addEventListener("click", action);
  return made;
};

// loads what is needed to seek, then does it
const whenReady = (video, action) => {
  if (video.readyState >= 1) return action();
  video.addEventListener("loadedmetadata", action, { once: true });
  video.preload = "auto";
  video.load();
};

for (const figure of document.querySelectorAll("figure.film")) {
  const video = figure.querySelector("video");
  const frames = Number(video.dataset.frames);
  const fps = Number(video.dataset.fps);
  video.controls = false;
  video.tabIndex = 0;
  for (const track of video.textTracks) track.mode = "hidden";
  const bar = document.createElement("div");
  bar.className = "controls";
  bar.setAttribute("role", "group");
  bar.setAttribute("aria-label", "Film: " + (video.getAttribute("aria-label") || ""));

  const range = document.createElement("input");
  range.type = "range";
  range.min = "0";
  range.max = String(frames - 1);
  range.value = "0";
  range.setAttribute("aria-label", "Frame");
  const where = document.createElement("span");
  where.className = "where";

  const pause = () => video.pause();
  const show = () => {
    const frame = Math.min(frames - 1, frameOf(video));
    range.value = String(frame);
    where.textContent = `${(frame / fps).toFixed(2)} s · frame ${frame}`;
    play.textContent = video.paused ? "▶" : "❚❚";
    play.setAttribute("aria-label", video.paused ? "Play" : "Pause");
    play.title = video.paused ? "Play (space)" : "Pause (space)";
  };
  const start = () => {
    if (video.ended || video.currentTime > (frames - 1) / fps) video.currentTime = 0;
    video.play().catch(() => {});
  };
  const seek = (frame) => {
    pause();
    whenReady(video, () => goTo(video, frame));
  };
  const play = button("▶", "Play", () => (video.paused ? start() : pause()));
  const step = (by) => seek((video.readyState >= 1 ? Math.min(frames - 1, frameOf(video)) : 0) + by);
  const back = button("−1", "−1 frame", () => step(-1));
  const on = button("+1", "+1 frame", () => step(1));
  const speed = document.createElement("select");
  speed.setAttribute("aria-label", "Speed");
  for (const value of speeds) {
    const option = document.createElement("option");
    option.value = String(value);
    option.textContent = `× ${value}`;
    option.selected = value === 1;
    speed.append(option);
  }
  speed.addEventListener("change", () => (video.playbackRate = Number(speed.value)));
  const repeats = video.loop;
  const loop = button("⟳", "Repeat", () => {
    video.loop = !video.loop;
    loop.setAttribute("aria-pressed", String(video.loop));
  });
  loop.setAttribute("aria-pressed", String(repeats));
  const link = button("Link", "Link to this frame: copy", () => {
    const place = `#film=${encodeURIComponent(video.dataset.film)}&frame=${Math.min(frames - 1, frameOf(video))}`;
    history.replaceState(null, "", place);
    if (navigator.clipboard) navigator.clipboard.writeText(location.href).catch(() => {});
    link.textContent = "Copied";
    setTimeout(() => (link.textContent = "Link"), 1500);
  });
  const large = button("⤢", "Full screen", () => {
    const screen = figure.querySelector(".screen");
    if (document.fullscreenElement) document.exitFullscreen();
    else if (screen.requestFullscreen) screen.requestFullscreen().catch(() => {});
  });
  bar.append(range, play, back, on, speed, loop, link);
  if (video.textTracks.length > 0) {
    const captions = button("CC", "CC: captions", () => {
      const off = video.textTracks[0].mode !== "showing";
      for (const track of video.textTracks) track.mode = off ? "showing" : "hidden";
      captions.setAttribute("aria-pressed", String(off));
    });
    captions.setAttribute("aria-pressed", "false");
    bar.append(captions);
  }
  bar.append(large, where);
  figure.querySelector(".screen").after(bar);

  range.addEventListener("input", () => seek(Number(range.value)));
  video.addEventListener("timeupdate", show);
  for (const event of ["play", "pause", "seeked", "ended", "loadedmetadata"]) video.addEventListener(event, show);
  const repaint = () => {
    if (!video.paused) show();
    requestAnimationFrame(repaint);
  };
  video.addEventListener("play", () => requestAnimationFrame(repaint), { once: true });
  video.addEventListener("click", () => (video.paused ? start() : pause()));
  video.addEventListener("keydown", (event) => {
    const keys = { " ": () => (video.paused ? start() : pause()), ",": () => step(-1), ".": () => step(1), ArrowLeft: () => step(-1), ArrowRight: () => step(1), Home: () => seek(0), End: () => seek(frames - 1) };
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  figure.seekFrame = seek;
  show();
}

// #film=NAME&t=2.5 or &frame=150
const followLink = () => {
  const words = new URLSearchParams(location.hash.slice(1));
  const name = words.get("film");
  if (!name) return;
  for (const video of document.querySelectorAll("video")) {
    if (video.dataset.film !== name) continue;
    const figure = video.closest("figure");
    if (figure.classList.contains("turn-figure")) figure.viewer.close(); // the film is asked for, not its model
    const frame = words.has("frame") ? Number(words.get("frame")) : Math.floor(Number(words.get("t")) * Number(video.dataset.fps) + 1e-6);
    if (Number.isFinite(frame)) figure.seekFrame(frame);
    figure.scrollIntoView({ block: "center" });
    video.focus({ preventScroll: true });
  }
};
addEventListener("hashchange", followLink);
followLink();

// the look: as the system has it, or turned over
const look = document.getElementById("Polhode-look");
const root = document.documentElement;
const kept = () => {
  try { return localStorage.getItem("polhode-look"); } catch { return null; }
};
const dark = () => root.dataset.look === "dark" || (root.dataset.look !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
const showLook = () => {
  look.textContent = dark() ? "Light look" : "Dark look";
};
if (kept() === "dark" || kept() === "light") root.dataset.look = kept();
look.hidden = false;
look.addEventListener("click", () => {
  root.dataset.look = dark() ? "light" : "dark";
  try { localStorage.setItem("polhode-look", root.dataset.look); } catch { /* nothing keeps it, then */ }
  showLook();
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", showLook);
showLook();
// on a phone the contents start closed
if (matchMedia("(max-width: 68rem)").matches) document.querySelector(".contents details").open = false;
// a formula wider than the page can be reached and scrolled by keys
for (const formula of document.querySelectorAll('math[display="block"]')) {
  if (formula.scrollWidth > formula.clientWidth) formula.setAttribute("tabindex", "0");
}
