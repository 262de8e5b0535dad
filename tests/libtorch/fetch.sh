#!/usr/bin/env bash
# fetch.sh FOLDER: the headers of Debian 13's libtorch 2.6 in FOLDER/usr/include, from the Debian mirror that this
# machine's apt uses. Nothing is installed, and apt's own lists stay as they are. Exit code 77: they cannot be had here.
set -euo pipefail
to=${1:?"a folder"}
lacking() { echo "libtorch 2.x: skipped, $*" >&2; exit 77; }

[ ! -e "$to/usr/include/ATen/ATen.h" ] || exit 0
for program in apt-get dpkg-deb; do
  command -v "$program" > /dev/null || lacking "no $program here: its headers come from a Debian package"
done
# Its sources, not its lists: those may not have been fetched yet.
mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2> /dev/null | sed '/^ *#/d' |
  grep -oE '[a-z+]+:/[^ ]*/debian/?( |$)' | head -n 1 | tr -d ' ') || true
[ -n "$mirror" ] || lacking "apt knows no Debian mirror"
keys=/usr/share/keyrings/debian-archive-keyring.gpg
[ -e "$keys" ] || lacking "no $keys (package debian-archive-keyring)"

mkdir -p "$to/apt/lists/partial" "$to/apt/cache/archives/partial"
cd "$to"
echo "deb [signed-by=$keys] $mirror trixie main" > apt/sources.list
cat > apt/apt.conf << TEXT
Dir::Etc::SourceList "$PWD/apt/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::State::Lists "$PWD/apt/lists";
Dir::State::Status "/dev/null";
Dir::Cache "$PWD/apt/cache";
APT::Architecture "amd64";
APT::Architectures "amd64";
APT::Sandbox::User "root";
Acquire::Languages "none";
Acquire::Retries "3";
Acquire::http::Timeout "20";
TEXT
export APT_CONFIG=$PWD/apt/apt.conf
timeout 300 apt-get -q update > apt/log 2>&1 || lacking "no package lists of Debian 13: $(tail -n 1 apt/log)"
timeout 300 apt-get -q download libtorch-dev >> apt/log 2>&1 || lacking "no package: $(tail -n 1 apt/log)"
rm -rf unpacked
dpkg-deb -x libtorch-dev_*.deb unpacked
rm -rf apt/lists apt/cache libtorch-dev_*.deb usr
mv unpacked/usr usr
rmdir unpacked
