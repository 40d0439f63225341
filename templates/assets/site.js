// Small helps on every page; nothing depends on them: `/` leads to the search, a menu closes when one clicks beside it, programs
// can be copied, the list of cycles be ordered and filtered.
"use strict";
(() => {
  const find = document.getElementById("query") || document.getElementById("find");
  document.addEventListener("keydown", (event) => {
    const typing = event.target instanceof Element && event.target.closest("input, textarea, select");
    if (event.key === "/" && find && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      find.focus();
    }
    if (event.key === "Escape") document.querySelectorAll(".switch[open]").forEach((menu) => { menu.open = false; });
  });
  // A button that copies the program above which it is.
  document.querySelectorAll("figure.nc").forEach((figure) => {
    const { copy, copied } = figure.dataset;
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = copy;
    button.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(figure.querySelector("pre").textContent);
        button.textContent = copied;
      } catch {
        getSelection().selectAllChildren(figure.querySelector("pre"));
      }
      setTimeout(() => { button.textContent = copy; }, 2000);
    });
    figure.querySelector("figcaption").append(" ", button);
  });
  // The list of cycles by group, by number or by name, and only those that have what was typed.
  const filter = document.getElementById("filter");
  if (filter) {
    const groups = document.querySelector("#cycles .groups");
    const own = [...groups.children];
    const list = document.createElement("ul");
    const fold = (text) => text.toLocaleLowerCase(document.documentElement.lang).normalize("NFD").replace(/\p{M}/gu, "");
    const items = new Map();
    for (const item of groups.querySelectorAll("li")) items.set(item.querySelector("a").getAttribute("href"), item);
    const name = (item) => item.querySelector("a").textContent;
    const number = (item) => Number(item.querySelector(".key").textContent.replace(/\D+/g, ""));
    const { compare } = new Intl.Collator(document.documentElement.lang);
    const show = () => {
      const wanted = fold(filter.elements.wanted.value.trim());
      const order = filter.elements.order.value;
      if (order === "group") groups.replaceChildren(...own);
      else {
        const sorted = [...items.values()].map((item) => item.cloneNode(true));
        sorted.sort((a, b) => order === "number" ? number(a) - number(b) : compare(name(a), name(b)));
        list.replaceChildren(...sorted);
        groups.replaceChildren(list);
      }
      for (const item of groups.querySelectorAll("li")) item.hidden = !fold(item.textContent).includes(wanted);
      for (const group of own) group.hidden = group.querySelector("li:not([hidden])") === null;
    };
    filter.addEventListener("input", show);
    filter.addEventListener("submit", (event) => event.preventDefault());
    filter.hidden = false;
  }
  document.addEventListener("click", (event) => {
    document.querySelectorAll(".switch[open]").forEach((menu) => {
      if (!menu.contains(event.target)) menu.open = false;
    });
  });
})();
