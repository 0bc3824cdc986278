#!/usr/bin/env python3
"""Builds gapcheck and check-c for machines that need nothing else, one file each: static programs for Linux on x86-64
and on arm64, and programs for Windows. What has machine code is built from Debian's source packages (oneTBB, GMP, MPFR,
fmt, zlib), since Debian has no static oneTBB, and no libraries for the other machines; what is headers alone comes from
the installed packages.

usage: machines.py [MACHINE …] [--mirror URL]
Writes the programs and SHA256SUMS to build/machines/programs. Without MACHINE: all. Needs Debian 12, the packages of
scripts/packages.txt and scripts/machines/packages.txt, and the network the first time.
"""

import argparse
import dataclasses
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MACHINES = ROOT / "build/machines"
SOURCES = MACHINES / "sources"
PROGRAMS = MACHINES / "programs"

SOURCE_PACKAGES = ["fmtlib", "gmp", "mpfr4", "onetbb", "zlib"]
HEADER_PACKAGES = ["libboost1.74-dev", "libcgal-dev", "libcli11-dev", "libeigen3-dev", "libtomlplusplus-dev",
                   "libxxhash-dev", "nlohmann-json3-dev"]
NO_AUTOTOOLS = ["AUTOCONF=:", "AUTOHEADER=:", "AUTOMAKE=:", "ACLOCAL=:", "MAKEINFO=:"]


@dataclasses.dataclass(frozen=True)
class Machine:
    name: str
    host: str  # as GNU names it
    system: str  # as CMake names it
    processor: str
    compilers: tuple = ("gcc", "g++")
    ending: str = ""
    link: str = "-static"

    @property
    def folder(self):
        return MACHINES / self.name

    @property
    def root(self):
        """Where the libraries are: include, lib."""
        return self.folder / "root"

    def tool(self, name):
        return f"{self.host}-{name}"


ALL = [
    Machine("linux-x86-64", "x86_64-linux-gnu", "Linux", "x86_64"),
    Machine("linux-arm64", "aarch64-linux-gnu", "Linux", "aarch64"),
    Machine("windows-x86-64", "x86_64-w64-mingw32", "Windows", "x86_64", ("gcc-posix", "g++-posix"), ".exe"),
]


def run(command, folder, log, **environment):
    """Runs a command, whose output goes to the end of a file; ends the script with its last lines if it fails."""
    log.parent.mkdir(parents=True, exist_ok=True)
    with open(log, "ab") as output:
        output.write(f"\n$ {' '.join(map(str, command))}\n".encode())
        output.flush()
        status = subprocess.run(command, cwd=folder, stdout=output, stderr=subprocess.STDOUT,
                                env={**os.environ, **environment}).returncode
    if status != 0:
        tail = log.read_text(errors="replace").splitlines()[-30:]
        sys.exit("\n".join(tail) + f"\n{command[0]} has failed; all of its output is in {log}")


def fetch_sources(mirror):
    """Unpacks the source packages of this Debian. The machine's own package lists stay as they are."""
    if all(any(SOURCES.glob(f"{package}-*/")) for package in SOURCE_PACKAGES):
        return
    print("fetching sources", flush=True)
    shutil.rmtree(SOURCES, ignore_errors=True)
    lists = SOURCES / "lists"
    (lists / "partial").mkdir(parents=True)
    suite = next(line.split("=")[1].strip() for line in open("/etc/os-release") if line.startswith("VERSION_CODENAME="))
    place = SOURCES / "sources.list"
    place.write_text(f"deb-src {mirror} {suite} main\n")
    apt = ["apt-get", "-o", f"Dir::Etc::sourcelist={place}", "-o", "Dir::Etc::sourceparts=-",
           "-o", f"Dir::State::lists={lists}", "-o", "APT::Sandbox::User="]
    run(apt + ["update"], SOURCES, MACHINES / "sources.log")
    run(apt + ["source", *SOURCE_PACKAGES], SOURCES, MACHINES / "sources.log")
    # Debian leaves out GMP's documentation, which its configure expects.
    (source("gmp") / "doc").mkdir()
    (source("gmp") / "doc/Makefile.in").write_text("all install:\n")


def source(package):
    return next(folder for folder in SOURCES.glob(f"{package}-*") if folder.is_dir())


def link_headers(machine):
    """Headers of the installed packages, and no others of this machine, into the root, with their CMake packages."""
    include, packages = machine.root / "include", machine.root / "lib/cmake"
    for folder in (include, packages):
        folder.mkdir(parents=True, exist_ok=True)
    for package in HEADER_PACKAGES:
        listed = subprocess.run(["dpkg", "-L", package], check=True, capture_output=True, text=True).stdout.splitlines()
        for path in map(pathlib.Path, listed):
            if path.parent == pathlib.Path("/usr/include"):
                link = include / path.name
                link.unlink(missing_ok=True)
                link.symlink_to(path)
            elif path.parent.name == "cmake" and path.is_dir() and not path.name.lower().startswith("boost"):
                shutil.copytree(path, packages / path.name, dirs_exist_ok=True)
    # Eigen has its files in a place of its own.
    shutil.copytree("/usr/share/eigen3/cmake", packages / "eigen3", dirs_exist_ok=True)


def cmake(machine, name, folder, targets, *options):
    build = machine.folder / name
    log = machine.folder / f"{name}.log"
    c, cxx = map(machine.tool, machine.compilers)
    run(["cmake", "-S", folder, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         f"-DCMAKE_SYSTEM_NAME={machine.system}", f"-DCMAKE_SYSTEM_PROCESSOR={machine.processor}",
         f"-DCMAKE_C_COMPILER={c}", f"-DCMAKE_CXX_COMPILER={cxx}",
         f"-DCMAKE_FIND_ROOT_PATH={machine.root}", f"-DCMAKE_PREFIX_PATH={machine.root}",
         "-DCMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER", "-DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY",
         "-DCMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY", "-DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY",
         f"-DCMAKE_INSTALL_PREFIX={machine.root}", "-DCMAKE_INSTALL_LIBDIR=lib", "-DBUILD_SHARED_LIBS=OFF", *options],
        ROOT, log)
    run(["ninja", f"-j{os.cpu_count()}", "-C", build, *targets], ROOT, log)
    return build


def autotools(machine, package, *options):
    build = machine.folder / package
    log = machine.folder / f"{package}.log"
    build.mkdir(parents=True, exist_ok=True)
    c, _ = map(machine.tool, machine.compilers)
    # Named as if this machine were another, else GMP takes the instructions of the processor that it finds.
    run([source(package) / "configure", "--build=x86_64-pc-linux-gnu", f"--host={machine.host}", "--disable-shared",
         "--enable-static", f"--prefix={machine.root}", f"CC={c}", "CC_FOR_BUILD=gcc", "CFLAGS=-O2", *options],
        build, log)
    run(["make", f"-j{os.cpu_count()}", "install", *NO_AUTOTOOLS], build, log)


def build_zlib(machine):
    """Without what reads and writes files. The source package lacks what zlib's own scripts need for Windows."""
    build = machine.folder / "zlib"
    build.mkdir(parents=True, exist_ok=True)
    log = machine.folder / "zlib.log"
    files = sorted(file for file in source("zlib").glob("*.c") if not file.name.startswith("gz"))
    run([machine.tool(machine.compilers[0]), "-O2", "-c", *files], build, log)
    run([machine.tool("ar"), "rcs", machine.root / "lib/libz.a", *sorted(build.glob("*.o"))], ROOT, log)
    for header in ("zconf.h", "zlib.h"):
        shutil.copy(source("zlib") / header, machine.root / "include")


def build_libraries(machine):
    done = machine.folder / "libraries-are-built"
    if done.exists():
        return
    print(f"{machine.name}: building libraries", flush=True)
    link_headers(machine)
    cmake(machine, "fmt", source("fmtlib"), ["install"], "-DFMT_TEST=OFF", "-DFMT_DOC=OFF")
    cmake(machine, "tbb", source("onetbb"), ["install"], "-DTBB_TEST=OFF", "-DTBB_STRICT=OFF", "-DTBBMALLOC_BUILD=OFF")
    build_zlib(machine)
    autotools(machine, "gmp")
    autotools(machine, "mpfr4", f"--with-gmp={machine.root}")
    done.touch()


def build_programs(machine):
    print(f"{machine.name}: building gapcheck and check-c", flush=True)
    build = cmake(machine, "gapcheck", ROOT, ["gapcheck", "check-c"], "-DGAPCHECK_TESTS=OFF",
                  f"-DCMAKE_EXE_LINKER_FLAGS={machine.link}",
                  "-DGAPCHECK_THREE_JS=/usr/share/javascript/three/three.min.js")
    folder = PROGRAMS / machine.name
    folder.mkdir(parents=True, exist_ok=True)
    for program in ("gapcheck", "check-c"):
        target = folder / f"{program}{machine.ending}"
        run([machine.tool("strip"), "-o", target, build / "apps" / program / target.name], ROOT,
            machine.folder / "gapcheck.log")
        print(f"{machine.name}: {target.relative_to(ROOT)}, {target.stat().st_size / 1e6:.1f} MB", flush=True)
    for text in ("LICENSE", "NOTICE"):
        shutil.copy(ROOT / text, folder)


def write_sums():
    files = sorted(file for file in PROGRAMS.glob("*/*") if file.is_file())
    lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.relative_to(PROGRAMS)}\n" for file in files]
    (PROGRAMS / "SHA256SUMS").write_text("".join(lines))


def main():
    names = {machine.name: machine for machine in ALL}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("machines", nargs="*", metavar="MACHINE", help=f"of {', '.join(names)}")
    parser.add_argument("--mirror", default="http://deb.debian.org/debian")
    arguments = parser.parse_args()
    if unknown := set(arguments.machines) - set(names):
        parser.error(f"{', '.join(sorted(unknown))}: no such machine; there are {', '.join(names)}")
    fetch_sources(arguments.mirror)
    for name in arguments.machines or names:
        build_libraries(names[name])
        build_programs(names[name])
    write_sums()


if __name__ == "__main__":
    main()
