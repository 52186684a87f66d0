# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
#
# shellcheck shell=bash
# Functions shared by the scripts: install missing packages, build, source the workspace. To be
# sourced, not run. Every step prints what it does, and does nothing if there is nothing to do.

package_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build_dir="${BUILD_DIR:-$package_dir/build}"
# Same value as in CMakeLists.txt.
devel_dir="$build_dir/devel"
[[ "$build_dir" != "$package_dir/build" ]] || devel_dir="$package_dir/devel"

# ROS's Python programs need the system's interpreter, even if others are installed.
export PATH="/usr/bin:$PATH"
export LC_ALL="${LC_ALL:-C.UTF-8}"

say() { printf '==> %s\n' "$*"; }
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }
fail_usage() { printf 'error: %s\n' "$*" >&2; exit 2; }  # for faults of the command line

# Debian's packages. If /opt/ros/noetic is sourced, ROS itself comes from there.
core_packages=(
  build-essential cmake ninja-build pkg-config python3
  libeigen3-dev libassimp-dev libqhull-dev libtinyxml2-dev libyaml-cpp-dev libssl-dev
  liburdfdom-dev liburdfdom-headers-dev libconsole-bridge-dev
  libcli11-dev libexpat1-dev libfcl-dev libhwy-dev libpng-dev
  pybind11-dev python3-dev python3-numpy python3-yaml
)
test_packages=(
  libgtest-dev librapidcheck-dev nlohmann-json3-dev doxygen
  python3-pytest python3-matplotlib python3-distributed
)
bench_packages=(libbenchmark-dev libbullet-dev)
debian_ros_packages=(
  libboost-all-dev
  ros-base-dev ros-robot-dev catkin rosbash python3-rosgraph python3-roslaunch python3-rospy
  python3-rostopic python3-rosservice python3-rostest python3-tf2-ros librostest-dev
  libtf2-ros-dev libtf2-eigen-dev libresource-retriever-dev libdiagnostic-updater-dev
  libnodelet-dev libnodeletlib-dev libnodeletlib-tools python3-nodelet ros-robot-state-publisher
  python3-diagnostic-msgs python3-geometry-msgs python3-rosgraph-msgs python3-sensor-msgs
  python3-std-msgs python3-std-srvs python3-tf2-msgs python3-trajectory-msgs
  python3-shape-msgs python3-visualization-msgs libshape-msgs-dev libtrajectory-msgs-dev
)

has_ros_noetic() { [[ "${ROS_DISTRO:-}" == noetic && -d /opt/ros/noetic ]]; }

is_installed() { dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed; }

# install_packages PACKAGE...: installs missing packages.
install_packages() {
  local missing=() package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return 0
  say "installing packages: ${missing[*]}"
  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null || fail "run as root or install sudo: ${missing[*]} are missing"
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null ||
    fail "apt-get could not install: ${missing[*]}"
}

# install_missing [GROUP...]: installs what the core needs and the given groups.
install_missing() {
  local packages=("${core_packages[@]}") group
  for group in "$@"; do
    case "$group" in
      ros) has_ros_noetic || packages+=("${debian_ros_packages[@]}") ;;
      test) packages+=("${test_packages[@]}") ;;
      bench) packages+=("${bench_packages[@]}") ;;
      show) has_ros_noetic || packages+=(rviz) ;;
      picture) packages+=(xvfb imagemagick pngquant) ;;
      plot) packages+=(python3-matplotlib) ;;
      *) fail "install_missing: no group '$group'; there are: ros, test, bench, show, picture, plot" ;;
    esac
  done
  install_packages "${packages[@]}"
}

# build_package [CMAKE OPTION...]: configures and builds all or the targets in BUILD_TARGET; repeats
# nothing.
build_package() {
  say "building in $build_dir"
  local log="$build_dir/build.log"
  mkdir -p "$build_dir"
  cmake -S "$package_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 "$@" >"$log" 2>&1 ||
    { tail -n 40 "$log" >&2; fail "configuring failed; all of it is in $log"; }
  # shellcheck disable=SC2086
  cmake --build "$build_dir" ${BUILD_TARGET:+--target $BUILD_TARGET} || fail "the build failed"
}

# source_workspace: lets rosrun, roslaunch and rostest find the built package.
source_workspace() {
  set +u
  # shellcheck disable=SC1091
  source "$devel_dir/setup.bash"
  set -u
}
