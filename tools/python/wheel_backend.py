"""Builds the wheel of the Python module (PEP 517) with CMake and the libraries of the system: nothing is downloaded.

`pip wheel` calls build_wheel. Its settings are build-dir (a build folder, made where there is none) and parts (which readers
a new build folder gets beside the module: footprints, cloud, mesh).
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sysconfig
import tempfile
import tomllib
import zipfile

_SOURCE = pathlib.Path(__file__).resolve().parents[2]
_PARTS = {"footprints": "skyway_python_gis", "cloud": "skyway_python_cloud", "mesh": "skyway_python_mesh"}


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel into the folder, and returns its name."""
    settings = config_settings or {}
    build = _SOURCE / settings.get("build-dir", "build/wheel")
    _build(build, [part for part in settings.get("parts", "").split(",") if part])
    project = tomllib.loads((_SOURCE / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(skyway VERSION ([0-9.]+)", (_SOURCE / "CMakeLists.txt").read_text())[1]
    files = _files(build)
    python = "cp" + re.search(r"_skyway\.cpython-(\d+)-", " ".join(files))[1]  # which CMake found
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"{project['name']}-{version}-{tag}.whl"
    _write(pathlib.Path(wheel_directory) / name, f"{project['name']}-{version}.dist-info", {
        **files, "METADATA": _metadata(project, version).encode(),
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: skyway\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()})
    return name


def _build(build, parts):
    unknown = set(parts) - set(_PARTS)
    if unknown:
        raise SystemExit(f"parts: expected some of {', '.join(_PARTS)}, found {', '.join(sorted(unknown))}")
    if not (build / "CMakeCache.txt").exists():
        options = [f"-DSKYWAY_{part.upper()}=ON" for part in parts]
        subprocess.run(["cmake", "-S", _SOURCE, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DSKYWAY_PYTHON=ON", *options], check=True)
    cache = (build / "CMakeCache.txt").read_text()
    built = [target for part, target in _PARTS.items() if f"SKYWAY_{part.upper()}:BOOL=ON" in cache]
    subprocess.run(["cmake", "--build", build, "--target", "skyway_python", *built], check=True)


def _files(build):
    """The package's own files, and the compiled parts without their symbols."""
    out = {f"skyway/{file.name}": file.read_bytes() for file in (_SOURCE / "tools/python/skyway").iterdir() if file.is_file()}
    for module in (build / "python").rglob("*.so"):
        with tempfile.NamedTemporaryFile() as stripped:
            subprocess.run(["strip", "--strip-unneeded", "-o", stripped.name, module], check=True)
            out[module.relative_to(build / "python").as_posix()] = pathlib.Path(stripped.name).read_bytes()
    return out


def _metadata(project, version):
    needs = "".join(f"Requires-Dist: {one}\n" for one in project["dependencies"])
    return (f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {version}\nSummary: {project['description']}\n"
            f"License: {project['license']['text']}\n"
            f"Requires-Python: {project['requires-python']}\n{needs}")


def _write(path, info, files):
    record = ""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in sorted(files.items()):
            name = name if "/" in name or name.endswith(".so") else f"{info}/{name}"
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record += f"{name},sha256={digest},{len(data)}\n"
            _add(wheel, name, data)
        _add(wheel, f"{info}/RECORD", f"{record}{info}/RECORD,,\n".encode())


def _add(wheel, name, data):
    entry = zipfile.ZipInfo(name)  # of 1980, so that equal content gives equal bytes
    entry.external_attr = 0o644 << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    wheel.writestr(entry, data)
