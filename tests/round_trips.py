#!/usr/bin/env python3
"""Exports texts, has other programs read and write the files, imports them again: nothing may change, an edit only its own words.

    tests/round_trips.py [--ciklo PATH] [--lang LANG] [--file FILE]... [--require NAME]...

The clients that are installed are used, the others are named as missing: translate-toolkit, polib and moz.l10n (Python
packages of the interpreter that runs this), compare-locales (another one: it reads l10n.toml and must find nothing),
msgcat and msgmerge (gettext), xliff (a Node package, found from the working directory), omegat. --require makes a missing one a failure. Works on a copy of the data; exits with 1 if anything else
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


def in_omegat(path, tag, edited=None, memory=None):
    """The file as OmegaT writes it: with an edit (old and new words of a segment) in the memory of the project, or with what a
    memory has for segments that are not translated."""
    with tempfile.TemporaryDirectory() as project:
        project_of(project, tag)
        shutil.copy(path, os.path.join(project, "source"))
        if edited:
            pair = "".join(f'<tuv lang="{lang}"><seg>{words}</seg></tuv>' for lang, words in zip(("EN", tag.upper()), edited))
            put(os.path.join(project, "omegat", "project_save.tmx"), f"""<?xml version="1.0" encoding="UTF-8"?>
<tmx version="1.1"><header creationtool="OmegaT" o-tmf="OmegaT TMX" adminlang="EN" datatype="plaintext" creationtoolversion="3.6"
segtype="paragraph" srclang="EN"/><body><tu>{pair}</tu></body></tmx>
""")
        if memory:
            os.mkdir(os.path.join(project, "tm", "auto"))
            shutil.copy(memory, os.path.join(project, "tm", "auto"))
        subprocess.run(["omegat", "--mode=console-translate", project], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        shutil.copy(os.path.join(project, "target", os.path.basename(path)), path)


def project_of(project, tag):
    for name in ("source", "target", "tm", "glossary", "dictionary", "omegat"):
        os.mkdir(os.path.join(project, name))
    put(os.path.join(project, "omegat.project"), f"""<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<omegat><project version="1.0"><source_dir>__DEFAULT__</source_dir><source_dir_excludes/><target_dir>__DEFAULT__</target_dir>
<tm_dir>__DEFAULT__</tm_dir><glossary_dir>__DEFAULT__</glossary_dir><glossary_file>__DEFAULT__</glossary_file>
<dictionary_dir>__DEFAULT__</dictionary_dir><source_lang>EN</source_lang><target_lang>{tag.upper()}</target_lang>
<sentence_seg>false</sentence_seg><support_default_translations>true</support_default_translations><remove_tags>false</remove_tags>
</project></omegat>
""")


# Reads a glossary with the classes of OmegaT and prints source and target words of each entry.
GLOSSARY = """
import java.io.File;
import org.omegat.core.Core;
import org.omegat.core.data.*;
import org.omegat.gui.glossary.*;
import org.omegat.util.ProjectFileStorage;
public class Glossary {
    public static void main(String[] names) throws Exception {
        Core.initializeConsole(new java.util.TreeMap<String, String>());
        Core.setProject(new RealProject(ProjectFileStorage.loadProjectProperties(new File(names[0]))));
        java.io.PrintStream out = new java.io.PrintStream(System.out, true, "UTF-8");
        for (GlossaryEntry entry : GlossaryReaderTBX.read(new File(names[1]), false))
            out.println("=" + entry.getSrcText() + "\\t" + entry.getLocText());
    }
}
"""
OMEGAT = "/usr/share/omegat"


def omegat_steps(options, root, files):
    """What a translator does in OmegaT, each as a name and what went wrong, or nothing."""
    tag = options.lang
    with tempfile.TemporaryDirectory() as folder:
        at = lambda name: os.path.join(folder, name)
        before = tree(root)

        def changes(path, *words):
            result = ciklo(options, root, "import", path, *words)
            now = tree(root)
            edited = {own: text for own, text in now.items() if before.get(own) != text and not own.endswith(".lock")}
            locks = [own for own in now if own.endswith(".lock") and before.get(own) != now[own]]
            restore(root, before)
            return result, edited, locks

        for form, path in (("po", at("texts.po")), ("xliff", at("texts.xlf"))):
            export = ["export", "--to", tag, "--format", form, "--out", path, *files]
            ciklo(options, root, *export).check_returncode()
            exported = text_of(path)
            in_omegat(path, tag)
            same, edited, locks = changes(path)
            good = same.returncode == 0 and not edited and not locks
            yield f"omegat {form}, no edit", None if good else same.stdout + same.stderr
            # The program takes the translation for the source of an XLIFF file that has one.
            if form == "po":
                segment = re.search(r'msgid "([^"\\<{]{30,}[a-z]\.)"\nmsgstr "([^"\\<{]*\w)\."\n', exported)
                words = (segment[1], segment[2])
            else:
                segment = re.search(r"<target[^>]*>([^<{&]{30,}\w)\.</target>", exported)
                words = (segment[1] + ".", segment[1])
            put(path, exported)
            in_omegat(path, tag, edited=words)
            once, edited, _ = changes(path)
            left = sum(len(before[own]) - len(text) for own, text in edited.items())
            good = once.returncode == 0 and len(edited) == 1 and left == 1
            yield f"omegat {form}, one edit", None if good else f"{sorted(edited)} {left} bytes\n" + once.stdout + once.stderr
        # A file that a language lacks, translated by what its memory has.
        memory, path = at("ciklo.tmx"), at("missing.xlf")
        ciklo(options, root, "export", "--to", tag, "--format", "tmx", "--out", memory).check_returncode()
        name = (options.file or ["drilling.ftl"])[0]
        whole = ciklo(options, root, "export", "--to", tag, "--format", "po", "--file", name).stdout
        os.remove(os.path.join(root, "locales", tag, name))
        ciklo(options, root, "export", "--to", tag, "--missing", "--copy-source", "--file", name, "--out", path).check_returncode()
        in_omegat(path, tag, memory=memory)
        back = ciklo(options, root, "import", path, "--any-state")
        again = ciklo(options, root, "export", "--to", tag, "--format", "po", "--file", name).stdout
        restore(root, before)
        texts = lambda po: dict(re.findall(r'msgctxt "(.*)"\n(msgid [\s\S]*?\nmsgstr (?:".*"\n)+)', po + "\n"))
        there, now = texts(whole), texts(again)
        # Codes of a memory are not those that it gives to a file, so it leaves texts with codes to the translator.
        plain = [key for key in there if "{" not in there[key]]
        other = [key for key in plain if now.get(key) != there[key]]
        other += [key for key in there if key not in plain and key in now and not now[key].endswith('msgstr ""\n')]
        yield f"omegat xliff of {len(plain)} of {len(there)} missing texts, by TMX", None if plain and not other else f"{other}\n{back.stdout}{back.stderr}"
        if not (shutil.which("javac") and os.path.exists(f"{OMEGAT}/OmegaT.jar")):
            return
        project, path = at("project"), at("ciklo.tbx")
        os.mkdir(project)
        project_of(project, tag)
        ciklo(options, root, "export", "--to", tag, "--format", "tbx", "--out", path).check_returncode()
        put(at("Glossary.java"), GLOSSARY)
        command = ["java", "-cp", f"{OMEGAT}/OmegaT.jar:{OMEGAT}/lib/*", at("Glossary.java"), project, path]
        read = subprocess.run(command, capture_output=True, text=True)
        found = {tuple(line[1:].split("\t")) for line in read.stdout.splitlines() if line.startswith("=")}
        import csv
        rows = list(csv.DictReader(ciklo(options, root, "export", "--to", tag, "--format", "csv").stdout.splitlines()))
        terms = {lang: {row["concept"]: row["term"] for row in rows if row["language"] == lang} for lang in ("en", tag)}
        lacking = [own for own, word in terms[tag].items() if (terms["en"].get(own), word) not in found]
        yield f"omegat glossary, {len(terms[tag])} terms", None if found and not lacking else f"{lacking}\n{read.stderr[-400:]}"


def compare_locales(root):
    """What compare-locales finds in the languages of l10n.toml, or nothing."""
    shutil.copy(os.path.join(ROOT, "l10n.toml"), root)
    code = "import sys; from compare_locales.commands import CompareLocales; sys.exit(CompareLocales.call())"
    with open(os.path.join(root, "l10n.toml"), encoding="utf-8") as file:
        languages = re.findall(r'"(\w+)"', re.search(r"^locales = (.*)$", file.read(), re.M)[1])
    run = subprocess.run([sys.executable, "-c", code, "--json", "-", "l10n.toml", ".", *languages], cwd=root, capture_output=True, text=True)
    import json
    try:
        [found] = json.loads(run.stdout)
    except ValueError:
        return run.stdout + run.stderr
    kinds = ("errors", "warnings", "missing", "obsolete")
    counted = {tag: sum(own[kind] for kind in kinds) for tag, own in found["summary"].items()}
    is_clean = run.returncode == 0 and counted == dict.fromkeys(languages, 0)
    return None if is_clean else f"{counted}\n{json.dumps(found['details'], indent=1)[:2000]}"


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
]


def tree(folder):
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


def restore(root, files):
    for own, text in files.items():
        path = os.path.join(root, own)
        if not os.path.exists(path) or open(path, "rb").read() != text:
            with open(path, "wb") as file:
                file.write(text)


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
                # This one writes no states of XLIFF 2.0.
                states = ["--any-state"] if (name, form) == ("xliff", "xliff2") else []
                write(path)
                same = ciklo(options, root, "import", path, *states)
                changed = sorted(own for own, text in tree(root).items() if before.get(own) != text)
                edit = EDIT.search(exported)
                put(path, exported[:edit.start()] + exported[edit.end():])
                write(path)
                once = ciklo(options, root, "import", path, *states)
                edited = sorted(own for own, text in tree(root).items() if before.get(own) != text and not own.endswith(".lock"))
                left = sum(len(before[own]) - len(tree(root)[own]) for own in edited)
            except (OSError, subprocess.CalledProcessError, Exception) as error:
                print(f"{label} FAILED: {type(error).__name__}: {error}")
                failed += 1
                continue
            finally:
                restore(root, before)
            good = same.returncode == 0 and not changed and once.returncode == 0 and len(edited) == 1 and left == 1
            failed += not good
            print(f"{label} {'as it was, and one edit' if good else 'FAILED'}: {same.stderr.splitlines()[-2:-1] or same.stderr.splitlines()[:1]}")
            if not good:
                print(f"    changed without an edit: {changed}; with one: {edited}, {left} bytes")
                print("    " + "\n    ".join((same.stdout + once.stdout).splitlines()[:12]))
        if has("compare_locales"):
            wrong = compare_locales(root)
            print(f"compare-locales: {'finds nothing' if wrong is None else 'FAILED: ' + wrong}")
            failed += wrong is not None
        else:
            print("compare-locales    not installed")
            failed += "compare-locales" in options.require
        if not shutil.which("omegat"):
            print("omegat             not installed")
            failed += "omegat" in options.require
        else:
            for name, wrong in omegat_steps(options, root, files):
                print(f"{name}: {'as it should be' if wrong is None else 'FAILED: ' + wrong}")
                failed += wrong is not None
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
