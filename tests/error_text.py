"""error_text.py SOURCE_DIR: no code of the product reads an error's text to decide anything.

Errors have fields and types (geom::InputError, geom::FileError). A text may be shown and passed on, and that is all:
whoever looks for words in it depends on wording that is made elsewhere. Each pattern below must find its own example,
and nothing in the libraries and tools.
"""

import pathlib
import re
import sys

CALLS = r"(?:starts_with|ends_with|find\w*|rfind|substr|compare|contains|remove_prefix)"
PATTERNS = [  # what it finds, how, an example of it
    ("a search in what()", re.compile(rf"what\(\)\)*\.{CALLS}\("),
     'if (std::string_view(error.what()).starts_with(source)) throw;'),
    ("a comparison with what()", re.compile(r"what\(\)\)*\s*[=!]=|[=!]=\s*\w+(?:\.|->)what\(\)"),
     'return error.what() == kCut;'),
    ("what() as an argument of a search", re.compile(r"(?:regex_\w+|str(?:n?cmp|str|chr)|starts_with)\([^;]*what\(\)"),
     "if (std::regex_search(error.what(), kLine)) return;"),
    ("what() kept to be read", re.compile(r"(?:string|string_view|auto)(?: const)?&? \w+(?: = |\()\w+(?:\.|->)what\(\)"),
     "const std::string_view message = error.what();"),
    ("a search in a message", re.compile(rf"\b(?:message|refusal|complaint)\.{CALLS}\("),
     'const std::size_t end = message.find(" is required");'),
    ("a search in the text of an exception", re.compile(r"(?: in |\()str\((?:e|err|error|problem)\)|str\((?:e|err|error)\)\."),
     'if "expected" in str(error): pass'),
]


def faults(text):
    for number, line in enumerate(joined(text), 1):
        for what, pattern, _ in PATTERNS:
            if pattern.search(line):
                yield number, what


def joined(text):
    """The lines without comments, each with what follows of its statement: clang-format breaks them anywhere."""
    lines = ["" if line.lstrip().startswith("//") else line for line in text.splitlines()]
    for i, line in enumerate(lines):
        end = i + 1
        while end < min(len(lines), i + 4) and not line.rstrip().endswith((";", "{", "}", ":")):
            line += " " + lines[end].strip()
            end += 1
        yield re.sub(r"\(\s+", "(", line)


def main(root):
    for what, pattern, example in PATTERNS:
        assert [w for _, w in faults(example)].count(what) == 1, f"does not find its example: {what}"
    files = [f for folder in ("libgeom", "libplan", "libtraj", "tools") for f in sorted((root / folder).rglob("*"))
             if f.suffix in (".cpp", ".h", ".py") and "build" not in f.parts]
    assert len(files) > 500, f"looked at {len(files)} files only"
    found = [f"{file.relative_to(root)}:{number}: {what}" for file in files
             for number, what in faults(file.read_text(encoding="utf-8"))]
    print("\n".join(found))
    print(f"{len(files)} files, {len(found)} readers of an error's text")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
