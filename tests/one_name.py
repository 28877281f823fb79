"""one_name.py SOURCE_DIR: in a program no two types of one namespace have one name.

Each unit would compile, and the linker would take the constructors of either for both. The libraries are
one program, and so is each tool with them and what tools share. Names inside functions, of other types
and of unnamed namespaces clash with nothing.
"""

import collections
import pathlib
import re
import sys

TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<raw>[^(\s]*)\(.*?\)(?P=raw)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''
    r"|\[\[.*?\]\]|::|[A-Za-z_]\w*|[{}();=<>,:]|\d[\w']*|#[^\n]*(?:\\\n[^\n]*)*", re.S)


def types(text):
    """The qualified names of the types that are defined at the level of a named namespace."""
    tokens = [m.group() for m in TOKEN.finditer(text)
              if not m.group().startswith(("//", "/*", "#", "[[", '"', "'", "R\""))]
    scopes = []  # of each open brace the namespace it opens; None: a body, or a namespace without a name
    statement = []
    for token in tokens:
        if token == "{":
            name, body = opened(statement)
            if name and body and None not in scopes:
                yield "::".join([*scopes, name])
            scopes.append(name if not body else None)
            statement = []
        elif token == "}":
            if not scopes:
                raise ValueError("a brace closes that none opened")
            scopes.pop()
            statement = []
        elif token == ";":
            statement = []
        else:
            statement.append(token)
    if scopes:
        raise ValueError("a brace stays open")


def opened(statement):
    """What a brace after the statement opens: its name or None, and whether that is a body."""
    words = [word for word in statement if word != "inline"]
    if words[:1] == ["namespace"]:
        return ("".join(words[1:]) or None), False
    if words[:1] == ["template"]:
        depth = 0
        for i, word in enumerate(words[1:], 1):
            depth += (word == "<") - (word == ">")
            if depth == 0:
                words = words[i + 1:]
                break
    if words[:1] not in (["struct"], ["class"], ["enum"], ["union"]) or "(" in words:
        return None, True
    end = next((i for i, word in enumerate(words) if word in (":", "final")), len(words))
    name = [word for word in words[1:end] if word not in ("class", "struct", "alignas")]
    return "".join(name) or None, True


def read(folder, source):
    """Pairs of a type and its file."""
    for path in sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp")):
        file = str(path.relative_to(source))
        try:
            for name in types(path.read_text(encoding="utf-8")):
                yield name, file
        except ValueError as error:
            sys.exit(f"{file}: {error}")


def clashes(pairs):
    files = collections.defaultdict(set)
    for name, file in pairs:
        files[name].add(file)
    return {f"{name} is defined in {' and in '.join(sorted(where))}"
            for name, where in files.items() if len(where) > 1}


def self_test():
    text = """namespace a::b { struct X; struct X { struct In {}; }; enum class E : int { one };
      namespace { class Hidden {}; } template <typename T> class Of final : public X {}; struct X::Impl {};
      inline void f(struct X x) { struct Local {}; const char* s = "struct S {"; } // struct C {
      } struct Top {};"""
    found = list(types(text))
    wanted = ["a::b::X", "a::b::E", "a::b::Of", "a::b::X::Impl", "Top"]
    return [] if found == wanted else [f"the reader of types finds {found} where {wanted} are"]


def main():
    source = pathlib.Path(sys.argv[1])
    found = set(self_test())
    shared = [pair for folder in ("libgeom", "libplan", "libtraj", "tools/cli") for pair in read(source / folder, source)]
    if not shared:
        found.add(f"{source}: no type was found")
    for tool in sorted(path for path in (source / "tools").iterdir() if path.is_dir() and path.name != "cli"):
        found |= clashes(shared + list(read(tool, source)))
    for line in sorted(found):
        print(line)
    sys.exit(bool(found))


main()
