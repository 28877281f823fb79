"""wheel_test.py BUILD_DIR SOURCE_DIR: the wheel, made by pip of a build folder, installed without network, runs an example."""

import base64
import csv
import hashlib
import io
import pathlib
import subprocess
import sys
import tempfile
import zipfile

build, source = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])


def run(*words):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"})
    assert done.returncode == 0, (words, done.stdout, done.stderr)
    return done.stdout


def test_the_record_is_true(wheel):
    with zipfile.ZipFile(wheel) as archive:
        record = next(name for name in archive.namelist() if name.endswith("/RECORD"))
        rows = list(csv.reader(io.StringIO(archive.read(record).decode())))
        assert {row[0] for row in rows} == set(archive.namelist())
        for name, digest, size in rows:
            data = archive.read(name)
            wanted = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            assert name == record or (digest, size) == (f"sha256={wanted}", str(len(data))), name
        assert {"skyway/__init__.py", "skyway/py.typed", "skyway/_skyway.pyi"} <= set(archive.namelist())


with tempfile.TemporaryDirectory() as folder:
    out = pathlib.Path(folder)
    pip = (sys.executable, "-m", "pip", "--disable-pip-version-check")
    run(*pip, "wheel", "--no-index", "--no-deps", "--config-settings", f"build-dir={build}", "-w", out, source)
    wheel, = out.glob("skyway-*.whl")
    test_the_record_is_true(wheel)
    run(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", out / "venv")
    python = out / "venv/bin/python"
    run(*pip, "--python", python, "install", "--no-index", "--no-deps", "--force-reinstall", wheel)
    where = run(python, "-c", "import skyway; print(skyway.__file__, skyway.__version__)")
    assert where.startswith(str(out / "venv")), where
    said = run(python, source / "tools/python/examples/lab.py", out)
    assert "cf1 ok" in said and (out / "page.html").stat().st_size > 100000, said
print("the wheel installs and runs")
