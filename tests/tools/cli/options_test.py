"""options_test.py BIN_DIR SOURCE_DIR: manual pages and completions name exactly the options that --help does, and
manual pages explain them in the same words."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

bin_dir, source_dir = map(pathlib.Path, sys.argv[1:3])
wrong = []


def run(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True, **options).stdout


def flags_and_words(tool, *verb):
    """The flags that --help lists, and of those with a fixed set of words, the words."""
    flags, words = set(), {}
    for line in run(bin_dir / tool, *verb, "--help").splitlines():
        named = re.match(r"  (-\S*)(.*)", line)
        if not named:
            continue
        listed = named[1].replace("{false}", "")
        spelled = [flag for flag in re.split("[,:]", listed) if flag.startswith("-")]
        flags.update(spelled)
        choice = re.search(r"\{([^}]*)\}", named[2])
        for flag in spelled if choice else []:
            words[flag] = set(choice[1].split(","))
    return flags, words


def meanings(tool):
    """What --help says of each option and argument, by how it is written there."""
    said, name = {}, None
    for line in run(bin_dir / tool, "--help").splitlines():
        begun = re.match(r"  (\S.*?)(?:  +(\S.*))?$", line)
        if begun:
            name = begun[1]
            said[name] = begun[2] or ""
        elif name and line.startswith("   "):
            said[name] = f"{said[name]} {line.strip()}".strip()
        else:
            name = None
    return said


def check_meanings(tool):
    """The page may say more, after the words of --help."""
    page = (source_dir / "docs/man" / f"{tool}.1.md").read_text()
    explained = {head: " ".join(text.split()) for head, text in re.findall(r"^`([^`]*)`\n:((?:.|\n(?!\n))*)", page, re.M)}
    for name, text in meanings(tool).items():
        if name in explained and not explained[name].startswith(text):
            wrong.append(f"{tool} {name}: --help says \"{text}\", the page \"{explained[name]}\"")


def verbs_of(tool):
    help_text = run(bin_dir / tool, "--help")
    section = help_text.partition("Subcommands:\n")[2]
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


def check_manual(tool, flags):
    page = (source_dir / "docs/man" / f"{tool}.1.md").read_text()
    section = page.partition("\n# OPTIONS\n")[2].partition("\n# ")[0]
    heads = re.findall(r"^(`.*|\*\*.*)\n:", section, re.M)
    # In "-o,--output TEXT:{a,b}" the flags are what stands before the first blank.
    named = {flag for head in heads for part in re.findall(r"[`*]([^`*]+)[`*]", head)
             for flag in part.split()[0].split(",") if flag.startswith("-")}
    expect(f"docs/man/{tool}.1.md", {f for f in named if f.startswith("--")}, {f for f in flags if f.startswith("--")})


def check_bash(script, tool, verb, flags, words):
    expect(f"bash, {tool} {verb}", completed(script, tool, *verb, "-"), flags)
    for flag, choice in words.items():
        expect(f"bash, {tool} {verb} {flag}", completed(script, tool, *verb, flag, ""), choice)
        expect(f"bash, {tool} {verb} {flag}=", completed(script, tool, *verb, flag, "=", ""), choice)


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
    check_meanings(tool)
    check_zsh(zsh, tool, verbs, flags)


def check_front(folder):
    script = folder / "skyway"
    script.write_text(run(bin_dir / "skyway", "--completion", "bash"))
    listed = set(re.findall(r"^  (\S+) ", run(bin_dir / "skyway", "help"), re.M))
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
print("\n".join(wrong) or f"manual pages and completions of {len(tools)} tools agree with --help")
sys.exit(bool(wrong))
