# shellcheck shell=bash disable=SC2154
# Shared by examples/run and test/run, which source it: what they need is installed, and the build is configured.
# Expects the variable `root`, the folder of the project.

# All that the tool can do: the formats of CAD programs, HDF5, compressed NumPy archives, pictures, and the page of --html.
packages=(g++ make cmake python3 libcgal-dev libeigen3-dev libceres-dev libtbb-dev nlohmann-json3-dev libcli11-dev
  libocct-data-exchange-dev libhdf5-dev zlib1g-dev libpng-dev libjs-three esbuild)
# The Python module.
# shellcheck disable=SC2034
python_packages=(python3-dev python3-pybind11 python3-numpy)
# What only the makers of cases from foreign files need, and the tests, which also read what was written, write what is to
# be read, build the manual, and look at the layout of the source.
# shellcheck disable=SC2034
test_packages=(libyaml-cpp-dev python3-ezdxf python3-h5py doxygen clang-format "${python_packages[@]}"
  python3-pytest python3-scipy python3-pandas python3-networkx python3-matplotlib python3-build python3-setuptools
  python3-wheel python3-venv mypy)
# Readers of written files, what draws, and a workflow manager, which are large, for `test/run --all`; what needs them is
# skipped without.
# shellcheck disable=SC2034
reader_packages=(freecad python3-vtk9 snakemake chromium libcgal-qt5-dev libgl1-mesa-dri xvfb xauth
  python3-distributed)
packages_are_checked=yes

fail()
{
  printf '%s\n' "$@" >&2
  exit 1
}

# Never more than two jobs at once: a compilation of this library takes more than a gigabyte.
number_of_jobs()
{
  local processors
  processors=$(nproc 2>/dev/null || echo 1)
  echo $((processors < 2 ? processors : 2))
}

list_missing_packages()
{
  local package
  for package in "${packages[@]}"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
  done
}

# Installs the Debian packages that are missing; where it may not, it says what is to be installed.
install_missing_packages()
{
  [[ $packages_are_checked == yes ]] || return 0
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "Not a Debian system: packages are left to you, and CMake will say what it does not find."
    return 0
  fi
  local missing
  mapfile -t missing < <(list_missing_packages)
  ((${#missing[@]})) || return 0

  local as_root=()
  if [[ $(id -u) != 0 ]]; then
    sudo -n true 2>/dev/null || fail \
      "These Debian packages are missing, and only root may install them:" \
      "$(printf '  %s\n' "${missing[@]}")" \
      "Install them, and run this again:" \
      "  sudo apt-get install ${missing[*]}" \
      "Or, if you have these libraries from elsewhere, run this again with --no-install."
    as_root=(sudo -n)
  fi
  echo "Installing ${missing[*]} ..."
  "${as_root[@]}" apt-get update -q || echo "The lists of packages could not be renewed; trying with those at hand." >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" ||
    fail "" "apt-get could not install: ${missing[*]}"
}

# Configures a preset in its folder, quietly unless it fails. Arguments: the preset, its folder.
configure()
{
  local preset=$1 folder=$root/$2
  command -v cmake >/dev/null || fail "There is no cmake; it is needed to build anything here."
  mkdir -p "$folder"
  # A tree that was moved, or is seen under another path in a container, cannot go on with its old build.
  if [[ -f $folder/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    echo "The build in $2 belongs to another place; it is configured anew."
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
  fi
  if ! (cd "$root" && cmake --preset "$preset") >"$folder/configure.log" 2>&1; then
    cat "$folder/configure.log" >&2
    fail "" "The build could not be configured; the reason stands above, and in $folder/configure.log."
  fi
}

# Builds in the folder of a preset. Arguments: the folder, more arguments of cmake --build.
build()
{
  local folder=$root/$1
  shift
  cmake --build "$folder" --parallel "$(number_of_jobs)" "$@" ||
    fail "" "The build failed; the first error above says why."
}
