// Searches the index of a language (`search/<lang>.js`, which defines `cikloIndex`) without a network.
// A word that was typed leads to all forms with its stem, to words that begin with it and to compounds that contain it, with or
// without diacritics; one that no page contains leads to the forms that begin most like it.
"use strict";
(() => {
  const index = cikloIndex;
  const input = document.getElementById("query");
  const status = document.getElementById("status");
  const list = document.getElementById("hits");
  const more = document.getElementById("more");
  const choice = document.getElementById("controls");
  const STEP = 20;
  const fold = (text) => text.toLocaleLowerCase(index.language).normalize("NFD").replace(/\p{M}/gu, "");
  const wordsOf = (text) => fold(text).match(/[\p{L}\p{N}]+/gu) || [];

  // Forms with the same stem have the same number; all other words have one of their own.
  const numbers = new Map();
  const stems = [];
  for (const group of index.stems) {
    const [stem, ...forms] = group.split(" ").map(fold);
    const number = stems.push(stem) - 1;
    for (const form of forms) if (!numbers.has(form)) numbers.set(form, number);
  }
  const numberOf = (word) => {
    let number = numbers.get(word);
    if (number === undefined) {
      number = stems.push(word) - 1;
      numbers.set(word, number);
    }
    return number;
  };

  // What can be found: titles (sentence −1) and sentences, by the numbers of their words.
  const texts = [];
  const postings = new Map();
  const add = (page, sentence, text) => {
    const at = texts.push([page, sentence]) - 1;
    for (const word of new Set(wordsOf(text))) {
      const number = numberOf(word);
      const known = postings.get(number);
      if (known === undefined) postings.set(number, [at]);
      else if (known[known.length - 1] !== at) known.push(at);
    }
  };
  index.pages.forEach(([, title], page) => add(page, -1, title));
  index.sentences.forEach((own, page) => own.forEach(([, text], sentence) => add(page, sentence, text)));
  const forms = [...numbers.keys()];

  // Whether words that are only like those typed are looked for as well, since nothing else was found.
  let loose = false;

  // The numbers that a word leads to, with how well they fit.
  const fitting = (word) => {
    const found = new Map();
    const note = (number, fit) => { if (!(found.get(number) >= fit)) found.set(number, fit); };
    const exact = numbers.get(word);
    if (exact !== undefined) note(exact, 1);
    const inner = exact !== undefined && word.length > 4 ? stems[exact] : word;
    for (const form of forms) {
      if (form.startsWith(word)) note(numbers.get(form), 0.7);
      else if (inner.length > 3 && form.includes(inner)) note(numbers.get(form), 0.5);
    }
    if (found.size > 0 && !loose) return found;
    let best = Math.max(3, Math.ceil(word.length * 0.4));
    let near = [];
    for (const form of forms) {
      let shared = 0;
      while (shared < form.length && shared < word.length && form[shared] === word[shared]) shared += 1;
      if (shared > best) { best = shared; near = []; }
      if (shared === best) near.push(form);
    }
    for (const form of near) note(numbers.get(form), 0.3);
    // A word of which only the inner part is known, such as one with another prefix.
    if (loose || near.length === 0 || best < word.length * 0.6) {
      for (const form of forms) if (form.length > 4 && word.includes(form.slice(0, 5))) note(numbers.get(form), 0.2);
    }
    return found;
  };

  const bits = () => [...choice.querySelectorAll("input")].reduce((on, box) => on | (box.checked ? 1 << box.value : 0), 0);

  // Pages with their sentences that contain every word, the best first.
  const search = (words) => {
    const on = bits();
    let hits = null;
    for (const word of words) {
      const own = new Map();
      for (const [number, fit] of fitting(word)) {
        for (const at of postings.get(number) || []) own.set(at, Math.max(own.get(at) || 0, fit));
      }
      const byPage = new Map();
      for (const [at, fit] of own) {
        const [page, sentence] = texts[at];
        const mask = sentence < 0 ? index.pages[page][2] : index.sentences[page][sentence][2];
        if ((mask & on) === 0) continue;
        const known = byPage.get(page) || { title: 0, best: 0, sentences: new Map() };
        if (sentence < 0) known.title = Math.max(known.title, fit);
        else {
          known.sentences.set(sentence, fit);
          known.best = Math.max(known.best, fit);
        }
        byPage.set(page, known);
      }
      if (hits === null) { hits = byPage; continue; }
      for (const [page, known] of hits) {
        const other = byPage.get(page);
        if (other === undefined) { hits.delete(page); continue; }
        known.title += other.title;
        known.best += other.best;
        // A sentence with several of the words is better than one with one.
        for (const [sentence, fit] of other.sentences) known.sentences.set(sentence, (known.sentences.get(sentence) || 0) + fit);
      }
    }
    const asked = words.join(" ");
    const rated = [...(hits || [])].map(([page, known]) => {
      const title = wordsOf(index.pages[page][1]);
      const name = title.slice(/^\d+$/.test(title[2] || "") ? 3 : 0).join(" ");
      const same = name === asked || title.join(" ") === asked || words.length === 1 && title[2] === asked;
      const covered = known.title / Math.max(1, title.length);
      const rows = [...known.sentences.values()].reduce((most, fit) => Math.max(most, fit), 0);
      return { page, sentences: known.sentences, score: (same ? 100 : 0) + 6 * known.title + 3 * covered + 2 * rows + Math.min(1, known.sentences.size / 20) };
    });
    return rated.sort((a, b) => b.score - a.score || a.page - b.page);
  };

  // The sentence around the first word found, the words marked.
  const excerpt = (text, words) => {
    const line = document.createElement("p");
    const found = [...text.matchAll(/[\p{L}\p{N}]+/gu)];
    const wanted = new Map(words.map((word) => [word, fitting(word)]));
    const fits = (word) => [...wanted.values()].some((own) => own.has(numberOf(fold(word))));
    const first = found.find(([word]) => fits(word));
    let start = first && first.index > 100 ? text.indexOf(" ", first.index - 80) + 1 : 0;
    const end = text.length - start > 240 ? text.lastIndexOf(" ", start + 220) : text.length;
    if (start > 0) line.append("… ");
    for (const match of found) {
      if (match.index < start || match.index + match[0].length > end || !fits(match[0])) continue;
      line.append(text.slice(start, match.index));
      const mark = document.createElement("mark");
      mark.textContent = match[0];
      line.append(mark);
      start = match.index + match[0].length;
    }
    line.append(text.slice(start, end));
    if (end < text.length) line.append(" …");
    return line;
  };

  const link = (href, text) => {
    const to = document.createElement("a");
    to.href = href;
    to.textContent = text;
    return to;
  };

  let asked = [];
  let hits = [];
  const show = (from) => {
    const on = bits();
    const own = Math.max(0, index.controls.findIndex(([id]) => id === list.dataset.own));
    for (const { page, sentences } of hits.slice(from, from + STEP)) {
      const [file, title, mask] = index.pages[page];
      const at = (bit) => `${list.dataset.root}${index.controls[bit][0]}/${index.language}/`;
      const chosen = index.controls.map((_, bit) => bit).filter((bit) => (mask & on & (1 << bit)) !== 0);
      const first = chosen.includes(own) ? own : chosen[0];
      const item = document.createElement("li");
      const head = document.createElement("h2");
      head.append(link(at(first) + file, title));
      item.append(head);
      const names = document.createElement("p");
      names.className = "of";
      chosen.forEach((bit, count) => names.append(count > 0 ? " · " : "", link(at(bit) + file, index.controls[bit][1])));
      item.append(names);
      const best = [...sentences].sort((a, b) => b[1] - a[1] || a[0] - b[0]).slice(0, 3);
      for (const [sentence] of best) {
        const [place, text, where] = index.sentences[page][sentence];
        const line = excerpt(text, asked);
        const bit = (where & (1 << first)) !== 0 ? first : chosen.find((other) => (where & (1 << other)) !== 0);
        if (place !== "" && bit !== undefined && !file.includes("#")) line.append(" ", link(`${at(bit)}${file}#${place}`, "#"));
        line.lastElementChild?.setAttribute("title", place);
        item.append(line);
      }
      list.append(item);
    }
    more.hidden = from + STEP >= hits.length;
  };

  const run = () => {
    asked = wordsOf(input.value);
    list.replaceChildren();
    loose = false;
    hits = asked.length === 0 ? [] : search(asked);
    if (asked.length > 0 && hits.length === 0) {
      loose = true;
      hits = search(asked);
    }
    status.textContent = asked.length === 0 ? "" : hits.length === 0 ? status.dataset.none : `${status.dataset.found} ${hits.length}`;
    show(0);
    const address = new URL(location.href);
    if (input.value === "") address.searchParams.delete("q"); else address.searchParams.set("q", input.value);
    try { history.replaceState(null, "", address); } catch { /* Some browsers do not allow it for files. */ }
  };

  if (index.controls.length > 1) {
    index.controls.forEach(([id, name], bit) => {
      const label = document.createElement("label");
      const box = document.createElement("input");
      box.type = "checkbox";
      box.value = bit;
      box.checked = id === list.dataset.own;
      box.addEventListener("change", run);
      label.append(box, ` ${name}`);
      choice.append(label);
    });
    choice.hidden = false;
  } else {
    const box = document.createElement("input");
    box.type = "checkbox";
    box.value = 0;
    box.checked = true;
    choice.append(box);
  }
  const other = document.getElementById("find");
  input.value = new URLSearchParams(location.search).get("q") || "";
  if (other) other.closest("form").hidden = true;
  let waiting = 0;
  input.addEventListener("input", () => { clearTimeout(waiting); waiting = setTimeout(run, 120); });
  document.getElementById("search").addEventListener("submit", (event) => { event.preventDefault(); run(); });
  more.addEventListener("click", () => show(list.childElementCount));
  run();
  if (input.value === "") input.focus();
})();
