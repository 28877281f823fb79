"""loaded_test.py TOOLS SOURCE_DIR: the shared libraries that each tool has loaded when it starts.

A library that a tool can do without at its start costs each run of it 0.05 to 1.7 ms. It is linked statically, or loaded
where it is needed (geom/base/loaded_library.h). Debian's tools find the packages of linked libraries by themselves; those
of loaded ones stand in packaging/packages.cmake.
"""

import pathlib
import re
import subprocess
import sys

EVERY = {"libsimdjson", "libfmt", "libstdc++", "libm", "libgcc_s", "libc", "ld-linux-x86-64"}
FURTHER = {"skyway-cloud": {"libpcl_common", "libgomp"}}

tools = pathlib.Path(sys.argv[1])
source = pathlib.Path(sys.argv[2])


def name(library):
    return pathlib.Path(library).name.split(".so")[0]


def started(tool):
    """What the loader maps before main()."""
    lines = subprocess.run(["ldd", tool], check=True, capture_output=True, text=True).stdout.splitlines()
    return {name(line.split()[0]) for line in lines} - {"linux-vdso"}


def loaded():
    """(file, package) of each library that the sources load."""
    for path in sorted(source.glob("lib*/src/**/*.cpp")) + sorted(source.glob("tools/**/*.cpp")):
        for macro, package in re.findall(r'LoadedLibrary(?: \w+)?\((\w+), "([^"]+)"\)', path.read_text(encoding="utf-8")):
            yield path, macro, package


def faults():
    for tool in sorted(tools.glob("skyway*")):
        if tool.suffix or not tool.is_file():
            continue
        wrong = started(tool) - EVERY - FURTHER.get(tool.name, set())
        if wrong:
            yield f"{tool.name} starts with {', '.join(sorted(wrong))}: link it statically, or load it where it is needed"
    packages = (source / "packaging/packages.cmake").read_text(encoding="utf-8")
    listed = re.search(r"set\(skyway_loaded ([^)]*)\)", packages)[1].split()
    listed += re.search(r"list\(APPEND skyway_loaded ([^)]*)\)", packages)[1].split()
    for more in ("if_there", "by_cloud"):
        listed += re.search(rf"set\(skyway_loaded_{more} ([^)]*)\)", packages)[1].split()
    found = list(loaded())
    if {package for _, _, package in found} - {"skyway"} != set(listed):  # its own module
        yield f"packaging/packages.cmake lists {listed}, and the sources load {[package for _, _, package in found]}"


assert started(tools / "skyway") >= {"libc", "libstdc++"}, "ldd says nothing"
assert len(list(tools.glob("skyway-*"))) > 15
problems = list(faults())
print("\n".join(problems))
sys.exit(bool(problems))
