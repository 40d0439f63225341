#!/usr/bin/env python3
"""Alters one fact at a time in a text or a specification and counts how many of the mutants `ciklo lint` finds.

    tests/mutate.py [--ciklo PATH] [--count N] [--seed N] [--kind KIND]... [--batch N] [--least SHARE] [--show]

Works on a copy of cycle-specs, locales and templates. Mutants that touch nothing in common are linted together; one is
found if a new finding names its text, its parameter, its cycle or its line. Exits with 1 if of any kind fewer than --least (0.99)
are found.
"""
import argparse, collections, json, os, random, re, shutil, subprocess, sys, tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LANGUAGES = ["en", "fi", "it", "pt", "sl"]


class Mutant:
    def __init__(self, kind, path, line, new, marks, what):
        self.kind, self.path, self.line, self.new, self.marks, self.what = kind, path, line, new, marks, what


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        return file.read().split("\n")


def messages(lines):
    """(line number, id, attribute or None, text) of every one-line text of a Fluent file."""
    current = None
    for at, line in enumerate(lines):
        head = re.match(r"^([a-z][\w-]*) = ?(.*)$", line)
        attribute = re.match(r"^\s+\.([a-z-]+) = (.*)$", line)
        if head:
            current = head[1]
            if head[2]:
                yield at, current, None, head[2]
        elif attribute and current:
            yield at, current, attribute[1], attribute[2]


def locale_mutants(root, rng):
    for language in LANGUAGES:
        folder = os.path.join(root, "locales", language)
        labels, placeables = {}, collections.defaultdict(list)
        for name in sorted(os.listdir(folder)):
            if not name.endswith(".ftl") or name.startswith(("diag", "cli", "explain", "lexicon", "interface", "site", "units", "text", "logs")):
                continue
            path = os.path.join(folder, name)
            lines = read(path)
            choices = []
            for at, key, attribute, text in messages(lines):
                base = key.split("__")[0]
                marks = {base, base.split("-", 1)[-1]}
                full = f"{key}.{attribute}" if attribute else key
                change = lambda kind, new, what: Mutant(kind, path, at, lines[at].replace(text, new, 1), marks, f"{language} {full}: {what}")
                if attribute == "label":
                    labels[full] = (path, at, lines[at], text, marks)
                    continue
                if attribute in ("nc", "nc-aliases", "label-aliases", "word", "prompt", "forms", "source", "forbidden"):
                    continue
                if attribute is None and base.startswith(("parameter-", "cycle-")):
                    continue
                prose = re.sub(r"\{[^}]*\}", lambda m: "\0" * len(m[0]), text)
                for number in re.finditer(r"(?<![\w.,])\d{2,}(?:[.,]\d+)?(?![\w])", prose):
                    digits = number[0]
                    new = text[:number.start()] + digits[1:] + text[number.end():]
                    yield change("digit-dropped", new, f"{digits} -> {digits[1:]}")
                for minus in re.finditer(r"(?<![\w\0])[−-](?=\d)", prose):
                    yield change("minus-lost", text[:minus.start()] + text[minus.end():], "minus lost")
                for unit, other in (("mm/min", "mm"), ("mm", "°"), ("°", "\u00a0mm")):
                    for hit in re.finditer(r"(?<=\d)(?:\u00a0| |\0+)?" + re.escape(unit) + r"(?![\w/])", prose):
                        at_unit = hit.end() - len(unit)
                        yield change("unit", text[:at_unit] + other + text[at_unit + len(unit):], f"{unit} -> {other}")
                        break
                for reference, other in REFERENCE_WORDS.get(language, []):
                    if reference in prose:
                        yield change("reference-word", text.replace(reference, other, 1), f"{reference} -> {other}")
                for code in re.finditer(r"\bQ(\d{2,3})\b", prose):
                    new = f"Q{int(code[1]) - 1}"
                    yield change("q-in-text", text[:code.start()] + new + text[code.end():], f"{code[0]} -> {new}")
                found = re.findall(r"\{ \$(q-[\w-]+) \}", text)
                if found:
                    others = [other for other in PLACEABLES if other != found[0]]
                    other = rng.choice(others)
                    yield change("argument", text.replace("{ $" + found[0] + " }", "{ $" + other + " }", 1), f"{found[0]} -> {other}")
                if base.startswith("choice-") and attribute is None and "__" not in key:
                    choices.append((at, base, text))
            yield from swapped_choices(root, path, lines, choices, language)
        ids = sorted(labels)
        for full in ids:
            path, at, line, text, marks = labels[full]
            other = labels[rng.choice(ids)]
            if other[3] != text and other[4] != marks:
                yield Mutant("label-of-another", path, at, line.replace(text, other[3], 1), marks, f"{language} {full}: {text} -> {other[3]}")


REFERENCE_WORDS = {
    "en": [("absolute", "incremental"), ("incremental", "absolute")],
    "sl": [("absolutn", "inkrementaln"), ("inkrementaln", "absolutn")],
    "it": [("assolut", "incremental")],
    "pt": [("absolut", "incremental")],
    "fi": [("absoluuttis", "inkrementaalis"), ("inkrementaalis", "absoluuttis")],
}
# What a program in inches would convert, or not, by mistake.
QUANTITIES = [
    ("length", "angle"), ("length", "feed"), ("length", "factor"), ("angle", "length"), ("feed", "length"), ("feed", "number"),
    ("time", "length"), ("speed", "length"), ("factor", "length"), ("count", "length"), ("number", "length"),
]
PLACEABLES = []
SETS = []


def swapped_choices(root, path, lines, choices, language):
    by_id = {base: (at, text) for at, base, text in choices}
    for members in SETS:
        for one, other in zip(members, members[1:]):
            if one in by_id and other in by_id and by_id[one][1] != by_id[other][1]:
                (a, text), (b, instead) = by_id[one], by_id[other]
                new = [lines[a].replace(text, instead, 1), lines[b].replace(instead, text, 1)]
                yield Mutant("choices-swapped", path, [a, b], new, {one, other, one[7:], other[7:]}, f"{language} {one} <-> {other}")


def spec_mutants(root, rng):
    for folder, _, names in sorted(os.walk(os.path.join(root, "cycle-specs"))):
        for name in sorted(names):
            if not name.endswith(".yaml") or folder.endswith(("controls", "machines")) or name in ("errata.yaml", "topics.yaml"):
                continue
            path = os.path.join(folder, name)
            lines = read(path)
            end = next((at for at, line in enumerate(lines) if line.startswith("examples:")), len(lines))
            head = re.match(r"(\d+)-(.*)\.yaml", name)
            cycle = {f" {head[1]} ", f" {head[1]}", head[2]} if head else set()
            concept = None
            for at, line in enumerate(lines[:end]):
                own = re.match(r"^  ([a-z][\w-]*):", line)
                concept = own[1] if own else concept
                marks = set(cycle)
                if "/parameters" in folder and concept:
                    marks |= {concept}
                named = re.search(r"is: ([\w-]+)", line)
                if named:
                    marks |= {named[1]}
                change = lambda kind, new, what: Mutant(kind, path, at, new, marks, f"{name}:{at + 1}: {what}")
                if "99999" in line and "range" in line:
                    yield change("limit", line.replace("99999", "9999", 1), "99999 -> 9999")
                if re.search(r"min: -\d", line):
                    yield change("minus-in-range", re.sub(r"min: -", "min: ", line, count=1), "minus lost in range")
                if "reference: absolute" in line:
                    yield change("reference", line.replace("reference: absolute", "reference: incremental"), "absolute -> incremental")
                if "reference: incremental" in line:
                    yield change("reference", line.replace("reference: incremental", "reference: absolute"), "incremental -> absolute")
                for quantity, other in QUANTITIES:
                    if f"quantity: {quantity}" in line:
                        yield change("quantity", line.replace(f"quantity: {quantity}", f"quantity: {other}"), f"{quantity} -> {other}")
                example = re.search(r'q: (Q\d+), is: [\w-]+, example: "-', line)
                if example and example[1] == "Q201":
                    yield change("minus-in-example", line.replace('example: "-', 'example: "', 1), "minus lost in example")
                number = re.match(r"^  - \{q: (Q\d+),", line)
                if number:
                    others = [other[1] for other in map(re.compile(r"^  - \{q: (Q\d+),").match, lines[:end]) if other and other[1] != number[1]]
                    if others:
                        other = rng.choice(others)
                        yield change("q-number", line.replace(number[1], other, 1), f"{number[1]} -> {other}")
                if re.match(r"^  - step: |^  - \{step: ", line) and not line.startswith("  - {step: ") or re.match(r"^  - \{step: .*\}\s*$", line):
                    stop = next((after for after in range(at + 1, end) if re.match(r"^(  - |\S)", lines[after])), end)
                    step = re.search(r"step: ([\w-]+)", line)[1]
                    yield Mutant("step-dropped", path, list(range(at, stop)), [None] * (stop - at), marks | {step}, f"{name}: step {step} dropped")
                formula = re.search(r"^  \w+: .*\b(Q\d{3})\b", line)
                if formula and "/parameters" not in folder and head:
                    used = [other for other in re.findall(r"q: (Q\d{3})", "\n".join(lines[:end])) if other != formula[1]]
                    if used:
                        other = rng.choice(used)
                        yield change("q-in-formula", line.replace(formula[1], other, 1), f"{formula[1]} -> {other} in a formula")
            pairs = [(at, re.search(r"\{value: (\S+), choice: ([\w-]+)", line)) for at, line in enumerate(lines[:end])]
            for (a, one), (b, other) in zip(pairs, pairs[1:]):
                if one and other and b == a + 1 and one[2] != other[2]:
                    new = [lines[a].replace(one[2], other[2], 1), lines[b].replace(other[2], one[2], 1)]
                    yield Mutant("choices-swapped-in-spec", path, [a, b], new, {one[2], other[2]} | set(cycle), f"{name}:{a + 1}: {one[2]} <-> {other[2]}")


def lint(ciklo, root):
    run = subprocess.run([ciklo, "--data", root, "lint", "--format", "json"], capture_output=True, text=True)
    found = []
    for line in run.stdout.splitlines():
        if line.startswith("{"):
            found.append(json.loads(line))
    if run.returncode > 1:
        found.append({"code": "unreadable", "message": run.stderr, "path": ""})
    return found


def key(finding):
    place = finding.get("place") or finding
    return json.dumps([finding.get("code"), finding.get("message"), place.get("path") or place.get("file")], sort_keys=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ciklo", default=os.path.join(ROOT, "target/release/ciklo"))
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", action="append", help="only mutants of this kind; may be repeated")
    parser.add_argument("--batch", type=int, default=8, help="so many mutants that touch nothing in common are linted together")
    parser.add_argument("--least", type=float, default=0.99, help="the share of each kind that must be found")
    parser.add_argument("--show", action="store_true", help="list every mutant that is not found")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as root:
        for folder in ("cycle-specs", "locales", "templates"):
            shutil.copytree(os.path.join(ROOT, folder), os.path.join(root, folder))
        for name in sorted(os.listdir(os.path.join(root, "locales/en"))):
            if name.endswith(".ftl"):
                PLACEABLES.extend(re.findall(r"\{ \$(q-[\w-]+) \}", "\n".join(read(os.path.join(root, "locales/en", name)))))
        PLACEABLES[:] = sorted(set(PLACEABLES))
        for folder, _, names in sorted(os.walk(os.path.join(root, "cycle-specs"))):
            for name in sorted(names):
                if name.endswith(".yaml"):
                    text = "\n".join(read(os.path.join(folder, name)))
                    for block in re.findall(r"choices:((?:\s*- \{value[^\n]*)+|\s*\[[^\]]*\])", text):
                        members = ["choice-" + one for one in re.findall(r"choice: ([\w-]+)", block)]
                        if len(members) > 1:
                            SETS.append(members)
        mutants = [mutant for mutant in [*locale_mutants(root, rng), *spec_mutants(root, rng)] if not options.kind or mutant.kind in options.kind]
        by_kind = collections.defaultdict(list)
        for mutant in mutants:
            by_kind[mutant.kind].append(mutant)
        chosen = []
        share = max(1, options.count // max(1, len(by_kind)))
        for kind in sorted(by_kind):
            rng.shuffle(by_kind[kind])
            chosen += by_kind[kind][:share]
        rng.shuffle(chosen)
        before = {key(finding) for finding in lint(options.ciklo, root)}
        found, total = collections.Counter(), collections.Counter()
        while chosen:
            batch, files, marks = [], set(), set()
            for mutant in list(chosen):
                if mutant.path not in files and not (mutant.marks & marks) and len(batch) < options.batch:
                    batch.append(mutant)
                    files.add(mutant.path)
                    marks |= mutant.marks
                    chosen.remove(mutant)
            kept = {mutant.path: read(mutant.path) for mutant in batch}
            for mutant in batch:
                lines = list(kept[mutant.path])
                at = mutant.line if isinstance(mutant.line, list) else [mutant.line]
                new = mutant.new if isinstance(mutant.new, list) else [mutant.new]
                for number, text in zip(at, new):
                    lines[number] = text
                with open(mutant.path, "w", encoding="utf-8", newline="") as file:
                    file.write("\n".join(line for line in lines if line is not None))
            news = [finding for finding in lint(options.ciklo, root) if key(finding) not in before]
            for mutant in batch:
                total[mutant.kind] += 1
                names = lambda finding: any(mark in json.dumps(finding, ensure_ascii=False) for mark in mutant.marks) or os.path.relpath(mutant.path, root) in json.dumps(finding)
                hits = [finding for finding in news if names(finding)]
                if hits:
                    found[mutant.kind] += 1
                elif options.show:
                    print(f"not found: {mutant.kind}: {mutant.what}", flush=True)
            for path, lines in kept.items():
                with open(path, "w", encoding="utf-8", newline="") as file:
                    file.write("\n".join(lines))
            print(f"{sum(found.values())} of {sum(total.values())} found", end="\r", file=sys.stderr, flush=True)
    below = [kind for kind in sorted(total) if found[kind] < options.least * total[kind]]
    for kind in sorted(total):
        mark = "   too few" if kind in below else ""
        print(f"{kind:26} {found[kind]:4} of {total[kind]:4}   ({len(by_kind[kind])} possible){mark}")
    rate = sum(found.values()) / max(1, sum(total.values()))
    print(f"found {sum(found.values())} of {sum(total.values())} mutants: {100 * rate:.2f} %")
    return 1 if below else 0


if __name__ == "__main__":
    sys.exit(main())
