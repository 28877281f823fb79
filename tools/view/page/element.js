// Making parts of the page.

// element("p", {class: "soft", onclick: f}, "text", child, …)
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children.flat().filter(child => child !== null && child !== undefined));
  return made;
}

function byId(id) { return document.getElementById(id); }

// [["words", "value"], …] as a list of facts.
function facts(pairs) {
  return element("dl", { class: "facts" }, pairs.filter(([, value]) => value !== null).flatMap(
    ([name, value]) => [element("dt", {}, name), element("dd", {}, value)]));
}

function choice(label, options, chosen, change) {
  const select = element("select", { "aria-label": label, onchange: () => change(select.value) },
    options.map(([value, words]) =>
      element("option", { value, selected: value === chosen }, words)));
  return select;
}

function slider(label, low, high, step, value, input) {
  const range = element("input", { type: "range", min: low, max: high, step, value,
    "aria-label": label, oninput: () => input(Number(range.value)) });
  return range;
}

// One of several, as joined buttons; returns {element, choose}.
function buttonGroup(label, options, chosen, change) {
  const buttons = options.map(([value, words, hint]) => element("button", {
    type: "button", title: hint, "aria-pressed": String(value === chosen), "data-value": value,
    onclick: () => change(value) }, words));
  const choose = value => {
    for (const b of buttons) b.setAttribute("aria-pressed", String(b.dataset.value === value));
  };
  return { element: element("div", { class: "group", role: "group", "aria-label": label }, buttons), choose };
}
