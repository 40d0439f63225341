#!/usr/bin/env python3
"""Exports texts, has other programs read and write the files, imports them again: nothing may change, an edit only its own words.

    tests/round_trips.py [--ciklo PATH] [--lang LANG] [--file FILE]... [--require NAME]...

The clients that are installed are used, the others are named as missing: translate-toolkit, polib and moz.l10n (Python
packages of the interpreter that runs this), msgcat and msgmerge (gettext), xliff (a Node package, found from the working
directory), omegat. --require makes a missing one a failure. Works on a copy of the data; exits with 1 if anything else
than what was edited changes.
"""
import argparse, importlib.util, os, re, shutil, subprocess, sys, tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# An edit that no check minds: a full stop goes. In the middle of words, so that no client trims it away.
EDIT = re.compile(r"(?<=[a-zäöčšžàèìòùáéíóúâêôãõç])\.(?=</target>)|(?<=[a-zäöčšžàèìòùáéíóúâêôãõç])\.(?=\"\n\n)")


def text_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return file.read()


def put(path, text):
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(text)


def toolkit(form):
    def write(path):
        from translate.storage import factory
        if form == "xliff2":
            from translate.storage.xliff2 import Xliff2File
            store = Xliff2File.parsefile(path)
        else:
            store = factory.getobject(path)
        for unit in store.units:
            # Each is read and set anew, as an editor does that saves what it shows.
            if not unit.isheader() and unit.target and form == "po":
                unit.target = str(unit.target)
        store.savefile(path)
    return write


def polib(path):
    import polib as library
    library.pofile(path).save(path)


def moz(path):
    from moz.l10n.formats import Format
    from moz.l10n.resource import parse_resource, serialize_resource
    resource = parse_resource(path)
    put(path, "".join(serialize_resource(resource, resource.format or Format.xliff)))


def msgcat(path):
    subprocess.run(["msgcat", "--no-wrap", "-o", path, path], check=True)


def msgmerge(path):
    template = path + "t"
    subprocess.run(["msgattrib", "--empty", "--no-obsolete", "-o", template, path], check=True)
    subprocess.run(["msgmerge", "--quiet", "--no-fuzzy-matching", "-o", path, path, template], check=True)


def node(version):
    names = {"xliff": ("xliff12ToJs", "jsToXliff12"), "xliff2": ("xliff2js", "js2xliff")}[version]
    code = f"""
const x = require('xliff'), fs = require('fs'), path = process.argv[1];
const read = x.{names[0]} || x.default.{names[0]}, write = x.{names[1]} || x.default.{names[1]};
Promise.resolve(read(fs.readFileSync(path, 'utf8'))).then(js => write(js)).then(text => fs.writeFileSync(path, text));
"""
    return lambda path: subprocess.run(["node", "-e", code, path], check=True)


def omegat(path):
    """A project whose memory has the translations; it writes the translated file."""
    with tempfile.TemporaryDirectory() as project:
        for name in ("source", "target", "tm", "glossary", "dictionary", "omegat"):
            os.mkdir(os.path.join(project, name))
        language = re.search(r'target-language="([^"]*)"|"Language: (\w+)', text_of(path))
        shutil.copy(path, os.path.join(project, "source"))
        put(os.path.join(project, "omegat.project"), f"""<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<omegat><project version="1.0"><source_dir>__DEFAULT__</source_dir><source_dir_excludes/><target_dir>__DEFAULT__</target_dir>
<tm_dir>__DEFAULT__</tm_dir><glossary_dir>__DEFAULT__</glossary_dir><glossary_file>__DEFAULT__</glossary_file>
<dictionary_dir>__DEFAULT__</dictionary_dir><source_lang>EN</source_lang><target_lang>{(language[1] or language[2]).upper()}</target_lang>
<sentence_seg>false</sentence_seg><support_default_translations>true</support_default_translations><remove_tags>false</remove_tags>
</project></omegat>
""")
        subprocess.run(["omegat", "--mode=console-translate", project], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        shutil.copy(os.path.join(project, "target", os.path.basename(path)), path)


def has(package):
    return importlib.util.find_spec(package) is not None


def has_node():
    return shutil.which("node") and subprocess.run(["node", "-e", "require('xliff')"], capture_output=True).returncode == 0


CLIENTS = [
    ("translate-toolkit", lambda: has("translate"), "xliff", toolkit("xliff")),
    ("translate-toolkit", lambda: has("translate"), "xliff2", toolkit("xliff2")),
    ("translate-toolkit", lambda: has("translate"), "po", toolkit("po")),
    ("polib", lambda: has("polib"), "po", polib),
    ("moz.l10n", lambda: has("moz.l10n"), "xliff", moz),
    ("msgcat", lambda: shutil.which("msgcat"), "po", msgcat),
    ("msgmerge", lambda: shutil.which("msgmerge"), "po", msgmerge),
    ("xliff", has_node, "xliff", node("xliff")),
    ("xliff", has_node, "xliff2", node("xliff2")),
    ("omegat", lambda: shutil.which("omegat"), "po", omegat),
]


def tree(folder):
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


def ciklo(options, root, *words):
    return subprocess.run([options.ciklo, "--data", root, "--ui-lang", "en", "texts", *words], capture_output=True, text=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ciklo", default=os.path.join(ROOT, "target/release/ciklo"))
    parser.add_argument("--lang", default="fi")
    parser.add_argument("--file", action="append", help="only these files of the language; may be repeated")
    parser.add_argument("--require", action="append", default=[], help="a client that must be there; may be repeated")
    options = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        root = os.path.join(folder, "data")
        for name in ("cycle-specs", "locales", "templates"):
            shutil.copytree(os.path.join(ROOT, name), os.path.join(root, name))
        files = [word for name in options.file or [] for word in ("--file", name)]
        for name, is_there, form, write in CLIENTS:
            label = f"{name:18} {form:7}"
            if not is_there():
                print(f"{label} not installed")
                failed += name in options.require
                continue
            path = os.path.join(folder, "texts.po" if form == "po" else "texts.xlf")
            before = tree(root)
            try:
                ciklo(options, root, "export", "--to", options.lang, "--format", form, "--out", path, *files).check_returncode()
                exported = text_of(path)
                write(path)
                same = ciklo(options, root, "import", path)
                changed = sorted(own for own, text in tree(root).items() if before.get(own) != text)
                edit = EDIT.search(exported)
                put(path, exported[:edit.start()] + exported[edit.end():])
                write(path)
                once = ciklo(options, root, "import", path)
                edited = sorted(own for own, text in tree(root).items() if before.get(own) != text and not own.endswith(".lock"))
                left = sum(len(before[own]) - len(tree(root)[own]) for own in edited)
            except (OSError, subprocess.CalledProcessError, Exception) as error:
                print(f"{label} FAILED: {type(error).__name__}: {error}")
                failed += 1
                continue
            finally:
                for own, text in before.items():
                    with open(os.path.join(root, own), "wb") as file:
                        file.write(text)
            good = same.returncode == 0 and not changed and once.returncode == 0 and len(edited) == 1 and left == 1
            failed += not good
            print(f"{label} {'as it was, and one edit' if good else 'FAILED'}: {same.stderr.splitlines()[-2:-1] or same.stderr.splitlines()[:1]}")
            if not good:
                print(f"    changed without an edit: {changed}; with one: {edited}, {left} bytes")
                print("    " + "\n    ".join((same.stdout + once.stdout).splitlines()[:12]))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
