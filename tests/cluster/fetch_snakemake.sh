#!/usr/bin/env bash
# fetch_snakemake.sh FOLDER: prints a PYTHONPATH with Debian's snakemake, in FOLDER, from the mirror that apt uses.
# Installed, it brings clients of every cloud, 670 MB; what it needs to run rules is 3 MB. Exit code 77: not to be had.
set -euo pipefail
to=${1:?"a folder"}
packages=(snakemake python3-appdirs python3-attr python3-certifi python3-chardet python3-charset-normalizer
  python3-configargparse python3-connection-pool python3-datrie python3-decorator python3-docutils
  python3-fastjsonschema python3-git python3-gitdb python3-humanfriendly python3-idna python3-jinja2
  python3-jsonschema python3-jupyter-core python3-markupsafe python3-nbformat python3-pkg-resources python3-psutil
  python3-pulp python3-py python3-pyparsing python3-pyrsistent python3-ratelimiter python3-requests python3-retry
  python3-roman python3-smart-open python3-smmap python3-stopit python3-tabulate python3-throttler python3-toposort
  python3-traitlets python3-urllib3 python3-wrapt python3-yaml)
if [ ! -d "$to/usr/lib/python3/dist-packages/snakemake" ]; then
  rm -rf "$to" && mkdir -p "$to/packages"
  (cd "$to/packages" && timeout 120 apt-get -q download "${packages[@]}") >"$to/log" 2>&1 ||
    { rm -rf "$to/packages"; echo "skipped: no snakemake: $(tail -n 1 "$to/log")"; exit 77; }
  for package in "$to"/packages/*.deb; do dpkg-deb -x "$package" "$to"; done
  rm -rf "$to/packages"
fi
echo "$to/usr/lib/python3/dist-packages"
