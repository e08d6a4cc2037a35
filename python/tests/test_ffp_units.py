"""Drops that the package's program was built without: compiled when first asked for. A package stands in, whose programs say who they are."""

import subprocess

import pytest

REFUSES = """#!/bin/sh
cat > /dev/null
echo "arenite-ffp: drops = {units}: this program was built without them; configure with -DARENITE_FFP_DROPS=all and build it anew" >&2
exit 3
"""
MAIN = """
#include <cstdio>
const char* unit();
int main() { std::puts(unit()); }
"""


@pytest.fixture
def package(ar, monkeypatch, tmp_path):
    """A package with a program that refuses the drops of `refuses(units)`, and what those of a slice are made of."""
    from arenite import _compile
    from arenite.ffp import _driver, _units

    try:
        compiler = _compile.compiler()
    except ar.Error as e:
        pytest.skip(str(e))
    folder = tmp_path / "arenite"
    for part in ("bin", "lib", "share/arenite/ffp/drop", "include/arenite"):
        (folder / part).mkdir(parents=True)
    (tmp_path / "main.cpp").write_text(MAIN)
    subprocess.run([*compiler, "-c", tmp_path / "main.cpp", "-o", tmp_path / "main.o"], check=True)
    subprocess.run(["ar", "rcs", folder / "lib" / "libffp_16.a", tmp_path / "main.o"], check=True)
    (folder / "share/arenite/ffp/drop/drop_slice.cpp").write_text("const char* unit() { return ARENITE_FFP_UNITS; }\n")
    for module in (_compile, _units):
        monkeypatch.setattr(module, "PACKAGE", folder)
    own = folder / "bin" / "arenite-ffp"
    monkeypatch.setattr(_driver, "_own", lambda: own)
    monkeypatch.delenv("ARENITE_FFP", raising=False)
    monkeypatch.setenv("ARENITE_CACHE", str(tmp_path / "cache"))

    def refuses(units):
        own.write_text(REFUSES.format(units=units))
        own.chmod(0o755)

    refuses("slice-law, slice")
    package.folder, package.own, package.refuses = folder, own, refuses
    return package


COMMAND = {"command": "drop", "options": {}}


def test_what_a_drop_needs_is_compiled_once(package, capfd):
    from arenite.ffp import _driver

    for first in (True, False):
        ending = _driver.run(COMMAND, quiet=False)
        assert ending == (0, ["slice-law, slice"])
        said = capfd.readouterr().err
        assert ("compiling arenite-ffp for drops of the kind slice-law, slice (once, half a minute each; " in said) == first
        assert "built without" not in said
    sources = package.folder / "share/arenite/ffp/drop/drop_slice.cpp"
    sources.write_text('const char* unit() { return "another"; }\n')  # of another version of the package
    assert _driver.run(COMMAND) == (0, ["another"])


def test_without_a_compiler_or_sources_the_cure_is_named(ar, package, monkeypatch):
    from arenite.ffp import _driver

    monkeypatch.setenv("CXX", "no-such-compiler")
    with pytest.raises(ar.Error, match="no-such-compiler: not found. arenite-ffp for drops of the kind slice-law, slice is not prebuilt"):
        _driver.run(COMMAND)
    for units in ("slice, unheard", "axisymmetric"):
        package.refuses(units)
        with pytest.raises(ar.Error, match=f"^drops = {units}: this program was built without them; configure with"):
            _driver.run(COMMAND).check()


def test_a_program_of_ones_own_is_not_replaced(ar, package, monkeypatch, tmp_path):
    from arenite.ffp import _driver

    monkeypatch.setenv("ARENITE_FFP", str(package.own.rename(tmp_path / "mine")))
    with pytest.raises(ar.Error, match="^drops = slice-law, slice: this program was built without them"):
        _driver.run(COMMAND).check()


def test_nothing_is_compiled_after_a_stop(package, monkeypatch, tmp_path):
    from arenite.ffp import _driver

    runs, run = _driver.Runs(), _driver.Runs._run

    def run_and_stop(self, *arguments):
        ending = run(self, *arguments)
        self.stop()
        return ending

    monkeypatch.setattr(_driver.Runs, "_run", run_and_stop)
    with pytest.raises(KeyboardInterrupt):
        runs.run(COMMAND)
    assert not list((tmp_path / "cache").glob("*.files"))
