#!/usr/bin/env python3
"""Alters facts in files as translators send them back, and counts how many of the altered units `ciklo texts import` refuses.

    tests/mutate_exchange.py [--ciklo PATH] [--count N] [--seed N] [--lang LANG]... [--least SHARE] [--show]

Each language is exported as XLIFF; in the final units one fact each is altered: a number, a unit, a Q number, a code, a
negation, a label, a choice. Some other units get a harmless edit, which must be taken over. Nothing is written: the import is a
dry run. Exits with 1 if fewer than --least (0.99) are refused, or if a harmless edit is.
"""
import argparse, collections, html, json, os, random, re, subprocess, sys, tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LANGUAGES = ["fi", "it", "pt", "sl"]
HARMLESS = 25
UNITS = (("mm/min", "mm"), ("mm", "°"), ("%", "mm"))
# Words that deny, each with what is left without it.
NEGATIONS = {
    "fi": [(r"\bei (?=\w)", ""), (r"\beivät (?=\w)", "")],
    "it": [(r"\bnon (?=\w)", "")],
    "pt": [(r"\bnão (?=\w)", "")],
    "sl": [(r"\bne (?=\w)", ""), (r"\bni (?=\w)", "je "), (r"\bniso (?=\w)", "so ")],
}
DENIES = re.compile(r"\b(not|no|never|without|cannot)\b")
SENTENCES = ("step-", "say-", "until-", "note-", "guard-", "choice-", "cycle-", "parameter-", "condition-", "message-")
PRINTED = (".label", ".nc", ".word", ".symbol", ".prompt")
REFERENCES = {
    "fi": [("absoluuttis", "inkrementaalis"), ("inkrementaalis", "absoluuttis")],
    "it": [("assolut", "incremental")],
    "pt": [("absolut", "incremental")],
    "sl": [("absolutn", "inkrementaln"), ("inkrementaln", "absolutn")],
}
CODE = re.compile(r"<ph [^>]*>(.*?)</ph>", re.S)


class Unit:
    def __init__(self, match):
        self.id, self.whole = match[1], match[0]
        self.source = re.search(r"<source>(.*?)</source>", self.whole, re.S)[1]
        target = re.search(r'<target state="final">(.*?)</target>', self.whole, re.S)
        self.target = target and target[1]
        # The words in their places, without codes and entities.
        blank = lambda match: "\0" * len(match[0])
        self.words = target and re.sub(r"&\w+;", blank, CODE.sub(blank, self.target))
        self.codes = [code for code in CODE.finditer(self.target or "") if code[1].startswith("{ $q-")]

    def with_target(self, target):
        return self.whole.replace(f'<target state="final">{self.target}</target>', f'<target state="final">{target}</target>', 1)


def spliced(text, start, end, new):
    return text[:start] + new + text[end:]


def mutants(unit, language, others, rng):
    """(kind, new target, what) of every alteration of a unit that has one target of its own."""
    text, words = unit.target, unit.words
    name = unit.id.split("#")[0] if not unit.id.startswith("topics/") else ""
    if name.endswith(".label"):
        other = rng.choice(others["labels"])
        if other != text:
            yield "label", other, f"{text} -> {other}"
        return
    if name.endswith(PRINTED) or (name and "." not in name and name.startswith(("parameter-", "cycle-", "unit-"))):
        return
    for number in re.finditer(r"(?<![\w.,\0])\d+(?![\w½]|-[Dud])", words):
        if not re.match(r"[.,]\d", words[number.end():]):
            new = number[0][1:] if len(number[0]) > 1 and number[0][1] != "0" else str(int(number[0]) + 1)
            yield "number", spliced(text, number.start(), number.end(), new), f"{number[0]} -> {new}"
    for minus in re.finditer(r"(?<![\w\0])[−-](?=\d)", words):
        yield "minus", spliced(text, minus.start(), minus.end(), ""), "minus lost"
    for one, other in UNITS:
        for hit in re.finditer(r"(?<=\d)(?:\u00a0| |\0+)?" + re.escape(one) + r"(?![\w/])", words):
            start = hit.end() - len(one)
            yield "unit", spliced(text, start, hit.end(), other), f"{one} -> {other}"
    for q in re.finditer(r"\bQ(\d{2,3})\b", words):
        new = f"Q{int(q[1]) + 1}"
        yield "q-number", spliced(text, q.start(), q.end(), new), f"{q[0]} -> {new}"
    for one, other in REFERENCES[language]:
        if one in words:
            yield "reference", text.replace(one, other, 1), f"{one} -> {other}"
    if unit.codes:
        code = rng.choice(unit.codes)
        if text.count(code[1]) == 1:
            yield "code-dropped", spliced(text, code.start(), code.end(), ""), f"{code[1]} dropped"
        other = rng.choice([other for other in others["codes"] if other != code[1]])
        yield "code-foreign", spliced(text, code.start(1), code.end(1), other), f"{code[1]} -> {other}"
        different = [(a, b) for a, b in zip(unit.codes, unit.codes[1:]) if a[1] != b[1]]
        if different:
            a, b = rng.choice(different)
            new = text[:a.start()] + b[0] + text[a.end():b.start()] + a[0] + text[b.end():]
            yield "codes-exchanged", new, f"{a[1]} <-> {b[1]}"
    if unit.id.startswith(SENTENCES) and DENIES.search(html.unescape(CODE.sub(" ", unit.source))):
        hits = [(hit, left) for pattern, left in NEGATIONS[language] for hit in re.finditer(pattern, words)]
        if len(hits) == 1:
            hit, left = hits[0]
            yield "negation", spliced(text, hit.start(), hit.end(), left), f"{hit[0].strip()} dropped"


def choices():
    """Pairs of choices of the same parameter."""
    for folder, _, names in sorted(os.walk(os.path.join(ROOT, "cycle-specs"))):
        for name in sorted(names):
            if name.endswith(".yaml"):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    for block in re.findall(r"choices:((?:\s*- \{value[^\n]*)+|\s*\[[^\]]*\])", file.read()):
                        members = ["choice-" + one for one in re.findall(r"choice: ([\w-]+)", block)]
                        yield from zip(members, members[1:])


def drawn(units, language, count, rng):
    """A list of (kind, {id: new unit}, what): altered facts evenly of all kinds, then harmless edits; each unit once."""
    by_id = {unit.id: unit for unit in units if unit.target}
    others = {
        "labels": sorted({unit.target for unit in by_id.values() if unit.id.endswith(".label")}),
        "codes": sorted({code[1] for unit in by_id.values() for code in unit.codes}),
    }
    by_kind = collections.defaultdict(list)
    for unit in by_id.values():
        for kind, target, what in mutants(unit, language, others, rng):
            by_kind[kind].append((kind, {unit.id: unit.with_target(target)}, f"{unit.id}: {what}"))
    for one, other in sorted(set(choices())):
        if one in by_id and other in by_id and by_id[one].target != by_id[other].target:
            a, b = by_id[one], by_id[other]
            both = {one: a.with_target(b.target), other: b.with_target(a.target)}
            by_kind["choice"].append(("choice", both, f"{one} <-> {other}"))
    for kind in by_kind.values():
        rng.shuffle(kind)
    chosen, used = [], set()
    while len(chosen) < count and any(by_kind.values()):
        for kind in sorted(by_kind):
            while by_kind[kind]:
                mutant = by_kind[kind].pop()
                if not used & set(mutant[1]):
                    used |= set(mutant[1])
                    chosen.append(mutant)
                    break
    chosen = chosen[:count]
    # A refusal may be about the message as a whole, so no variant of an altered one is edited.
    message = lambda id: re.split(r"__|[.#]", id)[0]
    altered = {message(id) for id in used}
    plain = [unit for unit in by_id.values() if message(unit.id) not in altered and unit.target.endswith(".") and unit.id.startswith(SENTENCES)]
    for unit in rng.sample(plain, HARMLESS):
        chosen.append(("harmless", {unit.id: unit.with_target(unit.target[:-1])}, unit.id))
    return chosen


def ciklo(options, *words):
    return subprocess.run([options.ciklo, "--data", ROOT, "--ui-lang", "en", "texts", *words], capture_output=True, text=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ciklo", default=os.path.join(ROOT, "target/release/ciklo"))
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--lang", action="append", help="only this language; may be repeated")
    parser.add_argument("--least", type=float, default=0.99, help="the share that must be refused")
    parser.add_argument("--show", action="store_true", help="list every mutant that is taken over")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    found, total, missed = collections.Counter(), collections.Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        languages = options.lang or LANGUAGES
        for language in languages:
            path = os.path.join(folder, f"{language}.xlf")
            ciklo(options, "export", "--to", language, "--out", path).check_returncode()
            with open(path, encoding="utf-8") as file:
                exported = file.read()
            units = [Unit(match) for match in re.finditer(r'<trans-unit id="([^"]*)".*?</trans-unit>', exported, re.S)]
            chosen = drawn(units, language, options.count // len(languages), rng)
            changed = {id: whole for _, wholes, _ in chosen for id, whole in wholes.items()}
            with open(path, "w", encoding="utf-8") as file:
                file.write(re.sub(r'<trans-unit id="([^"]*)".*?</trans-unit>', lambda match: changed.get(match[1], match[0]), exported, flags=re.S))
            run = ciklo(options, "import", path, "--dry-run", "--format", "json")
            if run.returncode > 1:
                sys.exit(run.stderr)
            refused = set()
            for line in run.stdout.splitlines():
                refused |= set(re.findall("units? “([^”]*)”", json.loads(line)["message"]))
            for kind, wholes, what in chosen:
                total[kind] += 1
                is_refused = bool(refused & set(wholes))
                found[kind] += is_refused
                if is_refused == (kind == "harmless"):
                    missed.append(f"{language} {kind}: {what}")
    for kind in sorted(total):
        print(f"{kind:16} {found[kind]:4} of {total[kind]:4} refused")
    if options.show:
        print(*(f"wrongly {'refused' if ' harmless: ' in line else 'taken over'}: {line}" for line in missed), sep="\n")
    harmless = found.pop("harmless"), total.pop("harmless")
    rate = sum(found.values()) / max(1, sum(total.values()))
    print(f"refused {sum(found.values())} of {sum(total.values())} mutants: {100 * rate:.2f} %, and {harmless[0]} of {harmless[1]} harmless edits")
    return 0 if rate >= options.least and harmless[0] == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
