"""text_streams.py SOURCE_DIR: no code of the product uses a plain stream of a text, or parses JSON by itself.

std::istringstream and std::ostringstream catch std::bad_alloc: a text that is read then looks as if it ended there, and one
that is written lacks its end. geom::TextInput and geom::TextOutput (geom/base/text_stream.h) throw it on. A plain
std::ifstream ends in the same way where reading fails; geom::open_file gives one that throws.

Of a key that comes twice in a JSON object, the later wins in silence. geom::parse_json (geom/text/parse_json.h) refuses such
a text, and all readers of JSON call it.
"""

import pathlib
import re
import sys

PLAIN = re.compile(r"std::(?:[io]?stringstream|ifstream|ofstream)\b")
ALLOWED = {"text_stream.h", "open_file.cpp",
           "memory.cpp", "peak_memory.cpp", "mapped_file.cpp",  # what the system says in /proc
           "read_footprints.cpp"}  # looks at bad()
JSON = re.compile(r"[jJ]son::(?:sax_parse|parse|accept)\(|\b(?:dom|ondemand)::parser\b")
PARSERS = {"simdjson_value.cpp", "worded_json.cpp"}  # behind geom::parse_json


def is_plain(file, line):
    return bool(file.name not in ALLOWED and PLAIN.search(line) or file.name not in PARSERS and JSON.search(line))


def main(root):
    files = [f for folder in ("libgeom", "libplan", "libtraj", "tools") for f in sorted((root / folder).rglob("*"))
             if f.suffix in (".cpp", ".h") and "build" not in f.parts]
    assert len(files) > 500, f"looked at {len(files)} files only"
    found = [f"{file.relative_to(root)}:{number}: {line.strip()}" for file in files
             for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1)
             if is_plain(file, line) and not line.startswith("//")]
    print("\n".join(found))
    print(f"{len(files)} files, {len(found)} plain streams or parsers of JSON")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
