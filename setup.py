"""What pyproject.toml cannot tell: the version, and that CMake builds the compiled part of the Python module.

The compiled part is a library of C, which ctypes loads. So one wheel is for every interpreter and every numpy of a
platform: py3-none-linux_x86_64.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70
    from wheel.bdist_wheel import bdist_wheel

repository = pathlib.Path(__file__).resolve().parent
# All that is written while a wheel is made: nothing is left in the source tree.
scratch = tempfile.TemporaryDirectory(prefix="quadrille-wheel-")
library = "libquadrille_python.so"
# What every system with an interpreter has; all else goes into the wheel.
of_system = re.compile(r"(libc|libm|libdl|librt|libpthread|libgcc_s|libstdc\+\+|ld-linux.*|linux-vdso)\.so")


def version():
    """As version.h tells it."""
    header = (repository / "include/quadrille/version.h").read_text()
    return ".".join(re.findall(r"#define QUADRILLE_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))


def needed_by(path):
    """The libraries that one is linked with, but for those of the system, as paths."""
    told = subprocess.run(["ldd", path], capture_output=True, text=True, check=True).stdout
    found = re.findall(r"^\s*(\S+) => (/\S+)", told, re.MULTILINE)
    return [pathlib.Path(place) for name, place in found if not of_system.match(name)]


class CMakeBuild(build_py):
    def run(self):
        super().run()
        folder = pathlib.Path(scratch.name) / "cmake"
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "QUADRILLE_BUILD_TESTS": "OFF",
            "Python3_EXECUTABLE": sys.executable,
            # Said at once where they are missing; otherwise the module, or a part of it, would be left out.
            "CMAKE_REQUIRE_FIND_PACKAGE_Python3": "ON",
            "CMAKE_REQUIRE_FIND_PACKAGE_nanoflann": "ON",
            # The module needs no models, and nothing that npm fetches.
            "QUADRILLE_DATA_DIR": repository,
            "QUADRILLE_NPM": "OFF",
        }
        environment = {"CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count() or 1), **os.environ}
        defined = [f"-D{name}={value}" for name, value in options.items()]
        for command in (["cmake", "-S", repository, "-B", folder, *defined],
                        ["cmake", "--build", folder, "--config", "Release", "--target", "quadrille_python"]):
            if subprocess.run(command, env=environment).returncode != 0:
                sys.exit("CMake could not build the compiled part, as is told above: "
                         "see doc/manual/python.md for what it needs")
        target = pathlib.Path(self.build_lib) / "quadrille"
        subprocess.run([sys.executable, repository / "examples/products/option_table.py", "python",
                        target / "_table.py"], check=True)
        built = folder / "examples/products/python/quadrille" / library
        for file in [built, *needed_by(built)]:
            shutil.copy(file, target / file.name)


class PlatformWheel(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return True


setup(
    version=version(),
    distclass=PlatformDistribution,
    cmdclass={"build_py": CMakeBuild, "bdist_wheel": PlatformWheel},
    options={"build": {"build_base": scratch.name}, "egg_info": {"egg_base": scratch.name}},
)
