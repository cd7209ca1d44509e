// The viewers: pictures are borrowed from the figures, so that each is in the file once.
document.documentElement.classList.add("js");
const hints = {
  slide: "Drag or use the arrow keys: reference on the left, actual on the right.",
  flip: "Hold the pointer over the picture, or press, to see the actual one.",
  difference: "Differences of values, amplified.",
  heat: "FLIP: how far the two look apart.",
};
for (const viewer of document.querySelectorAll(".viewer")) {
  const stage = viewer.querySelector(".stage");
  const figures = viewer.parentElement.querySelector(".figures");
  for (const image of stage.querySelectorAll("img")) {
    image.src = figures.querySelector("img." + image.dataset.of).src;
  }
  const show = (mode) => {
    stage.dataset.mode = mode;
    stage.classList.remove("flipped");
    viewer.querySelector(".hint").textContent = hints[mode];
    for (const button of viewer.querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.mode === mode));
    }
  };
  for (const button of viewer.querySelectorAll("button")) {
    button.addEventListener("click", () => show(button.dataset.mode));
  }
  const range = stage.querySelector("input");
  const move = () => stage.style.setProperty("--at", range.value + "%");
  range.addEventListener("input", move);
  stage.addEventListener("pointermove", (event) => {
    if (stage.dataset.mode !== "slide" || event.pointerType !== "mouse") return;
    const box = stage.getBoundingClientRect();
    range.value = String(Math.max(0, Math.min(100, (100 * (event.clientX - box.left)) / box.width)));
    move();
  });
  // a mouse flips by hovering, a finger by pressing
  const hover = (on) => (event) => {
    if (stage.dataset.mode === "flip" && event.pointerType === "mouse") stage.classList.toggle("flipped", on);
  };
  stage.addEventListener("pointerenter", hover(true));
  stage.addEventListener("pointerleave", hover(false));
  stage.addEventListener("pointerdown", () => stage.dataset.mode === "flip" && stage.classList.toggle("flipped"));
  move();
  show("slide");
}
