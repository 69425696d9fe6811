"""What pyproject.toml cannot tell: the version, and that CMake builds the compiled part of the Python module."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

repository = pathlib.Path(__file__).resolve().parent
# All that is written while a wheel is made: nothing is left in the source tree.
scratch = tempfile.TemporaryDirectory(prefix="quadrille-wheel-")


def version():
    """As version.h tells it."""
    header = (repository / "include/quadrille/version.h").read_text()
    return ".".join(re.findall(r"#define QUADRILLE_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        folder = pathlib.Path(self.build_temp).resolve() / "cmake"
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "QUADRILLE_BUILD_TESTS": "OFF",
            "Python3_EXECUTABLE": sys.executable,
            # Said at once where one is missing; otherwise the module would be left out.
            "CMAKE_REQUIRE_FIND_PACKAGE_Python3": "ON",
            "CMAKE_REQUIRE_FIND_PACKAGE_pybind11": "ON",
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
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(folder / "examples/products/python/quadrille" / target.name, target)


setup(
    version=version(),
    ext_modules=[Extension("quadrille._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": scratch.name}, "egg_info": {"egg_base": scratch.name}},
)
