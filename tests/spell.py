#!/usr/bin/env python3
"""Looks up every word of the prose in locales/ and prints those that no dictionary and no word list knows.

    tests/spell.py [LANGUAGE …]

Hunspell checks en (en_GB), it (it_IT), pt (pt_PT) and sl (sl_SI), Voikko checks fi: Debian's hunspell, hunspell-en-gb,
hunspell-it, hunspell-pt-pt, hunspell-sl, voikko-fi and python3-libvoikko. Words of the trade that they do not know stand in
tests/spelling/<language>.txt (names and words of programs in common.txt), one a line, each read by somebody. Exits with 1 if a word is unknown.
"""
import os, re, subprocess, sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DICTIONARIES = {"en": "en_GB", "it": "it_IT", "pt": "pt_PT", "sl": "sl_SI"}
# Printed labels, names in blocks, lists of pieces of words: facts, and no prose.
SKIPPED = {"label", "label-aliases", "nc", "nc-aliases", "word", "forms", "forbidden", "source", "endings", "symbol"}
FILES = ("lexicon.ftl", "units.ftl", "logs.ftl")
WORD = re.compile(r"[^\W\d_]+(?:[’'\u2019-][^\W\d_]+)*")


def prose(language):
    folder = os.path.join(ROOT, "locales", language)
    for directory, _, names in os.walk(folder):
        for name in sorted(names):
            path = os.path.join(directory, name)
            if name.endswith(".ftl") and name not in FILES:
                yield from fluent(path)
            elif name.endswith(".md"):
                yield from markdown(path)


def fluent(path):
    attribute = None
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            if line.startswith("#"):
                continue
            head = re.match(r"^-?[A-Za-z][\w-]* =(.*)$", line)
            own = re.match(r"^\s+\.([a-z-]+) =(.*)$", line)
            if head:
                attribute, line = None, head[1]
            elif own:
                attribute, line = own[1], own[2]
            if attribute in SKIPPED:
                continue
            line = re.sub(r"\{[^{}]*\}", " ", line)
            line = re.sub(r"^\s*\*?\[[\w-]+\]", " ", line)
            # Options and keys of files are no words.
            line = re.sub(r"--[a-z][a-z-]*|\b[a-z_]+:(?= [a-z_]+:|[”»«])", " ", line)
            yield path, number, re.sub(r"`[^`]*`", " ", line)


def markdown(path):
    fenced = False
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            if line.startswith("```"):
                fenced = not fenced
            elif not fenced:
                line = re.sub(r"`[^`]*`", " ", line)
                yield path, number, re.sub(r"\]\([^)]*\)", "]", line)


def words(language):
    """Each word with the place where it stands first; capitals are names of keys, columns and blocks."""
    found = {}
    for path, number, text in prose(language):
        text = re.sub(r"\S*[\\/@$_]\S*|\S*\d\S*|[\u003c\u003e{}]", " ", text)
        for match in WORD.finditer(text):
            # An apostrophe joins an article to its word; a hyphen joins words.
            for part in re.split(r"[’'\u2019-]", match[0]):
                if len(part) > 2 and not part.isupper():
                    found.setdefault(part, (os.path.relpath(path, ROOT), number))
    return found


def unknown(language, candidates):
    if language == "fi":
        import libvoikko

        voikko = libvoikko.Voikko("fi")
        return {word for word in candidates if not voikko.spell(word)}
    run = subprocess.run(
        ["hunspell", "-i", "utf-8", "-d", DICTIONARIES[language], "-l"],
        input="\n".join(sorted(candidates)), capture_output=True, text=True, check=True, env={**os.environ, "LC_ALL": "C.UTF-8"},
    )
    return set(run.stdout.split())


def listed(name):
    path = os.path.join(ROOT, "tests/spelling", f"{name}.txt")
    if not os.path.exists(path):
        return set()
    with open(path, encoding="utf-8") as file:
        return {line.strip().lower() for line in file if line.strip() and not line.startswith("#")}


def main():
    bad = 0
    for language in sys.argv[1:] or ["en", "fi", "it", "pt", "sl"]:
        known = listed("common") | listed(language)
        found = words(language)
        for word in sorted(unknown(language, set(found))):
            if word.lower() not in known:
                place = found.get(word, ("", 0))
                print(f"{language}: {word} ({place[0]}:{place[1]})")
                bad += 1
    print(f"{bad} unknown words")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
