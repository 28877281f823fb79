"""options_test.py BIN_DIR SOURCE_DIR: help texts, manual pages and completions name the same options, a help text fits a
screen and speaks no parser's language, and a manual page is short before its options."""

import gzip
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

bin_dir, source_dir = map(pathlib.Path, sys.argv[1:3])
wrong = []

FREE_WORDS = {"--autopilot", "--yaw", "--gains"}  # any of very many, or a number or file instead


def run(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True, **options).stdout


def meanings(tool, *verb):
    """What the full help says of each option: by its flags, the word for its value and the text."""
    text = run(bin_dir / tool, *verb, "--help-all").partition("\nVerbs:\n")[0]
    said, flags = {}, None
    for line in text.splitlines():
        begun = re.match(r"  (-[^\s,]+(?:, -[^\s,]+)*)(?: (\S.*?))?(?:  +(\S.*))?$", line)
        if begun:
            flags = tuple(begun[1].split(", "))
            said[flags] = [begun[2] or "", begun[3] or ""]
        elif flags and line.startswith(" " * 30):
            said[flags][1] = f"{said[flags][1]} {line.strip()}".strip()
        else:
            flags = None
    return said


def flags_and_words(tool, *verb):
    """The flags of the help, and those that take one of some words, with their texts."""
    flags, words = set(), {}
    for spelled, (value, text) in meanings(tool, *verb).items():
        flags.update(spelled)
        if value.split("|")[0] == "WORD":
            words.update({flag: text for flag in spelled})
    return flags, words


def verbs_of(tool):
    help_text = run(bin_dir / tool, "--help")
    section = help_text.partition("\nVerbs:\n")[2].partition("\n\n")[0]
    return re.findall(r"^  (\S+)", section, re.M)


def completed(script, *words):
    """What bash offers for the last of the words."""
    line = " ".join(f"'{w}'" for w in words)
    function = "_" + words[0].replace("-", "_")
    # compopt works within a completion only.
    shell = (f"source {script}; compopt() {{ :; }}; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; "
             f"{function}; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    return set(run("bash", "--norc", "-c", shell, env={**os.environ, "PATH": f"{bin_dir}:{os.environ['PATH']}"}).split())


def expect(what, found, expected):
    if found != expected:
        wrong.append(f"{what}: missing {sorted(expected - found)}, too many {sorted(found - expected)}")


def plain(markdown):
    return re.sub(r"\\(.)", r"\1", markdown)


def check_manual(tool, flags):
    """The options are the tool's own words, and the page leaves a place for them."""
    printed = run(bin_dir / tool, "--help-man")
    heads = re.findall(r"^(\*\*.*)\n:", printed, re.M)
    named = {plain(flag) for head in heads for flag in re.findall(r"\*\*(-.*?)\*\*", head)}
    expect(f"{tool} --help-man", named, flags)
    section = (source_dir / "docs/man" / f"{tool}.1.md").read_text().partition("\n# OPTIONS\n")[2].partition("\n# ")[0]
    if "\n**--help** shows " not in section or "\n:" in section:
        wrong.append(f"docs/man/{tool}.1.md: OPTIONS is made from the tool, after the line \"**--help** shows ...\"")
    page = bin_dir.parent / "man" / f"{tool}.1.gz"
    if page.exists():
        text = gzip.open(page, "rt").read().replace("\\-", "-").replace("\\f[R]", "").replace("\\f[B]", "")
        missing = [flag for flag in flags if flag not in text]
        if missing:
            wrong.append(f"{page.name} leaves out {missing}")


def check_help(tool):
    """--help fits a screen, ends with an example, and every option has a group and a word that people know."""
    shown, everything = run(bin_dir / tool, "--help"), run(bin_dir / tool, "--help-all")
    if len(shown.splitlines()) > 32:
        wrong.append(f"{tool} --help: {len(shown.splitlines())} lines, expected at most 32 (tools/cli/help/tool_page.cpp)")
    if "\nExample:\n  " not in shown:
        wrong.append(f"{tool} --help: no example (tools/cli/help/tool_page.cpp)")
    if "\nOther:\n" in everything:
        lost = everything.partition("\nOther:\n")[2]
        wrong.append(f"{tool}: an option without a group (tools/cli/help/option_groups.cpp):\n{lost}")
    for word in re.findall(r"\b(?:FLOAT|UINT|INT|TEXT|POSITIVE)\b", everything):
        wrong.append(f"{tool} --help-all: {word}")


def check_lengths():
    """Words of a manual page before its options."""
    counts = {}
    for page in sorted((source_dir / "docs/man").glob("*.1.md")):
        counts[page.name] = len(re.split(r"^# (?:OPTIONS|EXIT STATUS)$", page.read_text(), flags=re.M)[0].split())
    print(f"words before OPTIONS: median {statistics.median(counts.values())}, most {max(counts.values())}")
    wrong.extend(f"docs/man/{name}: {count} words before OPTIONS" for name, count in counts.items() if count > 250)
    if statistics.median(counts.values()) > 120:
        wrong.append("docs/man: more than 120 words before OPTIONS in the median: longer texts belong to a page of section 7")


def check_words(what, offered, text):
    """The words that completion offers are those that the help names."""
    if not offered or any(word not in text for word in offered):
        wrong.append(f"{what}: completion offers {sorted(offered)}, the help says: {text}")


def check_bash(script, tool, verb, flags, words):
    expect(f"bash, {tool} {verb}", completed(script, tool, *verb, "-"), flags)
    for flag, text in words.items():
        offered = completed(script, tool, *verb, flag, "")
        if not offered and flag not in FREE_WORDS:
            wrong.append(f"bash, {tool} {verb} {flag}: no words are offered")
        if offered:
            check_words(f"bash, {tool} {verb} {flag}", offered, text)
            expect(f"bash, {tool} {verb} {flag}=", completed(script, tool, *verb, flag, "=", ""), offered)


def check_zsh(script, tool, verbs, flags):
    text = script.read_text()
    assert text.startswith(f"#compdef {tool}\n")
    for flag in flags:
        if not re.search(rf"[)*]{flag}[=+]?\[", text):
            wrong.append(f"zsh, {tool}: {flag} is missing")
    for verb in verbs:  # the function that the last case calls by the verb's name
        assert f"_{tool}_{verb}() {{".replace("-", "_") in text, verb
    if shutil.which("zsh"):
        run("zsh", "-n", script)


def of_one_kind(word):
    """The word for a value without what is optional, and for one of several: LAT,LON of LAT,LON[,HEIGHT]|auto."""
    kind = re.sub(r"\[.*?\]| \.\.\.$", "", word).split("|")[0]
    return "FILE" if kind == "FOLDER" else kind  # both are places to write to


def check_one_meaning():
    """No two tools, or verbs of one, have an option of one name for values of different kinds."""
    kinds = {}
    for tool in tools:
        for verb in [(), *((verb,) for verb in verbs_of(tool))]:
            for flags, (word, text) in meanings(tool, *verb).items():
                if not text.startswith("--"):  # the rest of a list of options that broke over the line
                    for flag in flags:
                        kinds.setdefault(flag, {}).setdefault(of_one_kind(word), set()).add(" ".join((tool, *verb)))
    wrong.extend(f"{flag} takes different things: {found}" for flag, found in sorted(kinds.items()) if len(found) > 1)
    return kinds


def check_tool(tool, folder):
    verbs = verbs_of(tool)
    bash, zsh = folder / tool, folder / f"_{tool}"
    bash.write_text(run(bin_dir / tool, "--completion", "bash"))
    zsh.write_text(run(bin_dir / tool, "--completion", "zsh"))
    flags, words = flags_and_words(tool)
    check_bash(bash, tool, [], flags, words)
    if verbs:
        expect(f"bash, verbs of {tool}", completed(bash, tool, ""), set(verbs))
    for verb in verbs:
        of_verb, of_words = flags_and_words(tool, verb)
        check_bash(bash, tool, [verb], of_verb, of_words)
        flags |= of_verb
    check_manual(tool, flags)
    check_help(tool)
    check_zsh(zsh, tool, verbs, flags)


def check_front(folder):
    script = folder / "skyway"
    script.write_text(run(bin_dir / "skyway", "--completion", "bash"))
    listed = set(re.findall(r"^  (\S+) ", run(bin_dir / "skyway", "help").partition("\n\nTopics")[0], re.M))
    topics = run(bin_dir / "skyway", "help").partition("Topics (skyway help TOPIC):\n")[2].splitlines()[0].split()
    pages = {p.name.removeprefix("skyway-").removesuffix(".7.md") for p in (source_dir / "docs/man").glob("*.7.md")}
    expect("topics of skyway help", set(topics), pages)
    expect("bash, verbs of skyway", completed(script, "skyway", ""), listed | {"help"})
    expect("bash, skyway info -", completed(script, "skyway", "info", "-"), flags_and_words("skyway-info")[0])
    zsh = run(bin_dir / "skyway", "--completion", "zsh")
    assert all(f"'{verb}:" in zsh for verb in listed), zsh
    refused = subprocess.run([bin_dir / "skyway-info", "--completion", "fish"], capture_output=True, text=True)
    assert refused.returncode == 2 and "expected bash or zsh" in refused.stderr, refused


tools = sorted(p.name for p in bin_dir.glob("skyway-*") if p.is_file() and os.access(p, os.X_OK))
assert "skyway-plan" in tools
with tempfile.TemporaryDirectory() as name:
    for one in tools:
        check_tool(one, pathlib.Path(name))
    check_front(pathlib.Path(name))
check_lengths()
check_one_meaning()
print("\n".join(wrong) or f"manual pages and completions of {len(tools)} tools agree with --help")
sys.exit(bool(wrong))
