"""The package works from where 'cmake --install' puts it, without the checkout."""

import os
import subprocess
import sys


def test_the_installed_package_calibrates(tmp_path):
    """Proves that the components python and configuration suffice, and that the descriptions beside them are used."""
    for component in ("python", "configuration"):
        subprocess.run([os.environ["NAOCAL_CMAKE"], "--install", os.environ["NAOCAL_BUILD"], "--prefix", tmp_path,
                        "--component", component], check=True, capture_output=True)
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    packages = tmp_path / "lib" / version / "dist-packages"
    assert sorted(file.name for file in (packages / "naocal").iterdir() if file.suffix != ".so") == [
        "__init__.py", "__init__.pyi", "py.typed"]
    (tmp_path / "share/naocal/configuration/drawings/NaoV6.json").rename(
        tmp_path / "share/naocal/configuration/drawings/NaoV6x.json")
    code = ("import naocal; print(naocal.__file__)\n"
            "try: naocal.simulate(poses=2)\n"
            "except naocal.InputError as error: print(error)")
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=True, capture_output=True, text=True,
                          env={"PYTHONPATH": str(packages)})
    file, sentence = done.stdout.splitlines()
    assert file.startswith(str(packages)) and str(tmp_path / "share/naocal/configuration") in sentence
