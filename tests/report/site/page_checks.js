// What is looked at on every page: functions that run in the browser. Each returns a list of what is wrong.

// What a finger must meet has at least 24 by 24 pixels, but for links in a sentence (WCAG 2.2, success criterion 2.5.8). Of a
// box that stands in its label the label is met; a cell of a heat map is as large as its data let it be.
export const smallTargets = () => {
  const block = (one) => { while (/^inline$/.test(getComputedStyle(one).display)) one = one.parentElement; return one; };
  const inSentence = (link) => {
    const words = block(link.parentElement).cloneNode(true);
    for (const part of words.querySelectorAll("a, button, ul, ol, table, script, style")) part.remove();
    return /\p{L}{2}/u.test(words.textContent);
  };
  return [...document.querySelectorAll("a[href], button, input, select, summary, label")].filter((one) => {
    if (!one.checkVisibility({opacityProperty: true, visibilityProperty: true}) || one.matches(".skip, .cell-link, label:not([for], :has(input, select))")) return false;
    if (one.matches("input") && one.closest("label")) return false;
    const {width, height} = one.getBoundingClientRect();
    return (width < 23.5 || height < 23.5) && !(one.matches("a") && inSentence(one));
  }).map((one) => `${one.tagName.toLowerCase()} "${one.textContent.trim().slice(0, 30)}" in ${one.parentElement.tagName.toLowerCase()}.${one.closest("[class]")?.className} has ${["width", "height"].map((side) => one.getBoundingClientRect()[side].toFixed(0)).join(" x ")} pixels`);
};

// Words that go on in the next line, but for code and after a hyphen or another sign.
export const brokenWords = () => {
  const broken = [], range = document.createRange();
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const text = texts.currentNode, own = text.parentElement;
    if (!/\S/.test(text.data) || own.closest("pre, code, svg, script, style, option") || !own.checkVisibility()) continue;
    for (const {0: word, index} of text.data.matchAll(/[\p{L}\p{N}]{2,}/gu)) {
      range.setStart(text, index);
      range.setEnd(text, index + word.length);
      if (new Set([...range.getClientRects()].map(({top}) => Math.round(top))).size > 1) broken.push(`"${word}" in ${own.tagName.toLowerCase()}.${own.closest("[class]")?.className}`);
    }
  }
  return broken;
};

// Texts of charts that leave the picture, with the fonts of this machine.
export const cutTexts = () => [...document.querySelectorAll("figure > svg")].filter((svg) => svg.checkVisibility()).flatMap((svg) => {
  const picture = svg.getBoundingClientRect(), scale = picture.width / svg.viewBox.baseVal.width;
  return [...svg.querySelectorAll("text")].filter((text) => text.getBoundingClientRect().width > 0).flatMap((text) => {
    const {left, right, top, bottom} = text.getBoundingClientRect();
    const beyond = Math.max(picture.left - left, right - picture.right, picture.top - top, bottom - picture.bottom) / scale;
    return beyond > 2 ? [`"${text.textContent}" leaves ${svg.id || svg.querySelector("title").textContent} by ${beyond.toFixed(0)} pixels`] : [];
  });
});

// Numbers as no reader writes them: "1 turns", "3 us", "short by -9.93", 0.0009000000000000001.
export const wrongNumbers = () => {
  const patterns = [/(?<![-0-9.,/_A-Za-z])1 (?:borders|cases|collisions|columns|constants|cores|entries|evaluations|families|fits|impacts|instances|kinds|knots|levels|machines|methods|pages|pairs|parameters|points|problems|regimes|reports|rows|runs|scenes|searches|seeds|settings|simulations|solvers|speeds|starts|steps|tools|turns|values|variables)\b/g,
    /[0-9] us\b/g, /\bby [-−][0-9]/g, /\.[0-9]{13}/g];
  const text = document.body.innerText;
  return patterns.flatMap((pattern) => [...text.matchAll(pattern)].map(({0: found, index}) => `"${text.slice(Math.max(0, index - 30), index + found.length)}"`));
};

// Texts of charts that do not stand out from what they are on (WCAG 2.2: at least 3 for large letters and pictures).
export const faintTexts = () => {
  const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
  const mixed = (over, under, share) => under.map((one, i) => share * over[i] + (1 - share) * one);
  const luminance = (rgb) => rgb.map((one) => one / 255).map((one) => one <= 0.04045 ? one / 12.92 : ((one + 0.055) / 1.055) ** 2.4).reduce((sum, one, i) => sum + [0.2126, 0.7152, 0.0722][i] * one, 0.05);
  const paper = numbers(getComputedStyle(document.body).backgroundColor).slice(0, 3);
  return [...document.querySelectorAll("figure > svg")].filter((svg) => svg.checkVisibility()).flatMap((svg) => {
    const shapes = [...svg.querySelectorAll("path, rect, circle")].filter((one) => !one.closest("defs, clipPath, pattern, marker")).map((shape) => {
      const {fill, fillOpacity, opacity} = getComputedStyle(shape);
      return {shape, fill, share: Number(fillOpacity) * Number(opacity), back: shape.getScreenCTM().inverse()};
    }).filter(({fill}) => fill.startsWith("rgb"));
    return [...svg.querySelectorAll("text")].filter((text) => text.textContent && text.getBoundingClientRect().width > 0).flatMap((text) => {
      const {left, right, top, bottom} = text.getBoundingClientRect(), middle = new DOMPoint((left + right) / 2, (top + bottom) / 2);
      const below = shapes.filter(({shape, back}) => (text.compareDocumentPosition(shape) & Node.DOCUMENT_POSITION_PRECEDING) && shape.isPointInFill(middle.matrixTransform(back)));
      const ground = below.reduce((under, {fill, share}) => mixed(numbers(fill), under, share), paper);
      const [bright, dark] = [numbers(getComputedStyle(text).fill), ground].map(luminance).sort((a, b) => b - a);
      return bright / dark < 3 ? [`"${text.textContent}" of ${svg.id || svg.querySelector("title").textContent} has a contrast of ${(bright / dark).toFixed(1)}`] : [];
    });
  });
};
