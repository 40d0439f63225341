// Searches the index of a manual (`search-index.js`, which defines `cikloIndex`) without a network.
// A word that was typed leads to every form with the same stem; one that no page contains leads to
// the forms that begin most like it.
"use strict";
(() => {
  const index = cikloIndex;
  const input = document.getElementById("query");
  const status = document.getElementById("status");
  const list = document.getElementById("hits");
  const wordsOf = (text) => text.toLocaleLowerCase(document.documentElement.lang).match(/[\p{L}\p{N}]+/gu) || [];

  // The numbers of the stems that a word leads to.
  const stemsOf = (word) => {
    const { forms } = index;
    let low = 0;
    let high = forms.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (forms[middle][0] < word) low = middle + 1; else high = middle;
    }
    if (low < forms.length && forms[low][0] === word) return new Set([forms[low][1]]);
    const begun = new Set();
    for (let at = low; at < forms.length && forms[at][0].startsWith(word); at += 1) begun.add(forms[at][1]);
    if (begun.size > 0) return begun;
    // Forms that share the longest beginning, if it is most of the word.
    let best = Math.max(3, Math.ceil(word.length * 0.6));
    let near = new Set();
    for (const [form, stem] of forms) {
      let shared = 0;
      while (shared < form.length && shared < word.length && form[shared] === word[shared]) shared += 1;
      if (shared > best) { best = shared; near = new Set(); }
      if (shared === best) near.add(stem);
    }
    return near;
  };

  const search = () => {
    const words = wordsOf(input.value);
    list.replaceChildren();
    if (words.length === 0) { status.textContent = ""; return; }
    let found = null;
    for (const word of words) {
      const scores = new Map();
      for (const stem of stemsOf(word)) {
        const postings = index.stems[stem];
        for (let at = 0; at < postings.length; at += 2) {
          scores.set(postings[at], (scores.get(postings[at]) || 0) + postings[at + 1]);
        }
      }
      if (found === null) { found = scores; continue; }
      for (const [page, score] of found) {
        if (scores.has(page)) found.set(page, score + scores.get(page)); else found.delete(page);
      }
    }
    const hits = [...found].sort((a, b) => b[1] - a[1] || a[0] - b[0]);
    status.textContent = hits.length === 0 ? status.dataset.none : `${status.dataset.found} ${hits.length}`;
    for (const [page] of hits) {
      const [href, title] = index.pages[page];
      const link = document.createElement("a");
      link.href = href;
      link.textContent = title;
      const item = document.createElement("li");
      item.append(link);
      list.append(item);
    }
  };

  const asked = new URLSearchParams(location.search).get("q");
  if (asked) input.value = asked;
  input.addEventListener("input", search);
  document.getElementById("search").addEventListener("submit", (event) => { event.preventDefault(); search(); });
  search();
})();
