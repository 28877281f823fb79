"""one_unit.py BUILD_DIR: no two tests that are compiled as one unit define a helper of one name.

Two helpers with one name and different parameters compile. A call in one test may then mean the helper of the other test. The
script reads the definitions of functions and constants that begin a line.
"""

import collections
import pathlib
import re
import sys

DEFINED = re.compile(r"^(?!return|using|namespace|struct|class|enum|template|else|static_assert)[A-Za-z][\w:<>,&* ]*?[ &*>](\w+)(?=\(| = |\{|;|\[)", re.M)


def repeated(unit):
    """The names that two of the unit's sources define, each with the sources."""
    of_name = collections.defaultdict(set)
    for source in map(pathlib.Path, re.findall(r'#include "(.*_test\.cpp)"', unit.read_text())):
        text = source.read_text() if source.exists() else ""  # CMake leaves old units in the folder
        for found in DEFINED.finditer(text):
            of_name[found[1]].add(source.name)
    return {name: sources for name, sources in of_name.items() if len(sources) > 1}


def main():
    units = sorted(pathlib.Path(sys.argv[1]).glob("tests/*/CMakeFiles/*_test.dir/Unity/**/*.cxx"))
    if not units:
        sys.exit(f"{sys.argv[1]}: no test is compiled together with another")
    wrong = [(name, sources) for unit in units for name, sources in repeated(unit).items()]
    for name, sources in wrong:
        print(f"{name}: " + ", ".join(sorted(sources)))
    if wrong:
        sys.exit("these tests are one unit: share the helper, rename it, or list a test under SKIP_UNITY_BUILD_INCLUSION")
    print(f"{len(units)} units of tests: no helper has the name of a neighbour's")


if __name__ == "__main__":
    main()
