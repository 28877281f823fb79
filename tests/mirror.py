"""mirror.py SOURCE_DIR: each unit test of a library has the room and the name of what it tests."""

import pathlib
import sys

source = pathlib.Path(sys.argv[1])
strays = []
for library in ("geom", "plan", "traj"):
    tests = source / "tests" / library
    for test in sorted(tests.rglob("*_test.cpp")):
        tested = test.relative_to(tests).with_name(test.name.removesuffix("_test.cpp"))
        home = source / f"lib{library}"
        candidates = [home / "include" / library / f"{tested}.h", home / "src" / f"{tested}.h", home / "src" / f"{tested}.cpp"]
        if not any(path.exists() for path in candidates):
            strays.append(f"{test.relative_to(source)}: lib{library} has no {tested}.h or {tested}.cpp")
for stray in strays:
    print(stray)
sys.exit(bool(strays))
