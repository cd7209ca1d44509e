// Paper cannot be scrolled: formulas that are wider than their place are set smaller, and then
// tables. For one of them browsers would print all pages smaller, and cut it off beyond that.
"use strict";
document.fonts.ready.then(() => {
  const widthAround = (part) => {
    const place = part.parentElement.closest("p, li, td, th, dd, dt, h1, h2, h3, h4, h5, h6, figcaption, blockquote, div, section, main, header");
    const style = getComputedStyle(place);
    return place.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  };
  const fit = (part) => {
    const width = Math.max(part.scrollWidth, part.getBoundingClientRect().width), room = widthAround(part);
    if (width > room) part.style.fontSize = `${(0.99 * room * parseFloat(getComputedStyle(part).fontSize)) / width}px`;
  };
  for (const formula of document.querySelectorAll("math")) if (!formula.closest("table")) fit(formula);
  for (const table of document.querySelectorAll("table")) fit(table);
});
