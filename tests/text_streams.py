"""text_streams.py SOURCE_DIR: no code of the product uses a plain stream of a text.

std::istringstream and std::ostringstream catch std::bad_alloc: a text that is read then looks as if it ended there, and one
that is written lacks its end. geom::TextInput and geom::TextOutput (geom/base/text_stream.h) throw it on. A plain
std::ifstream ends in the same way where reading fails; geom::open_file gives one that throws.
"""

import pathlib
import re
import sys

PLAIN = re.compile(r"std::(?:[io]?stringstream|ifstream|ofstream)\b")
ALLOWED = {"text_stream.h", "open_file.cpp",
           "memory.cpp", "peak_memory.cpp", "mapped_file.cpp",  # what the system says in /proc
           "read_footprints.cpp"}  # looks at bad()


def main(root):
    files = [f for folder in ("libgeom", "libplan", "libtraj", "tools") for f in sorted((root / folder).rglob("*"))
             if f.suffix in (".cpp", ".h") and "build" not in f.parts]
    assert len(files) > 500, f"looked at {len(files)} files only"
    found = [f"{file.relative_to(root)}:{number}: {line.strip()}" for file in files if file.name not in ALLOWED
             for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1)
             if PLAIN.search(line) and not line.startswith("//")]
    print("\n".join(found))
    print(f"{len(files)} files, {len(found)} plain streams")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
