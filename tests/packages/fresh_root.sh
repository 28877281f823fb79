#!/usr/bin/env bash
# fresh_root.sh DEB_DIR [ROOT]: the packages on a Debian 12 that has nothing else. Makes a root with mmdebstrap,
# installs each package there with apt, and runs the demo, the manual pages, the completions, the chain by Make, a program
# built against the libraries and the Python examples, without the source tree. Needs root, the network, and mmdebstrap and lintian; takes
# minutes, so it is run by hand. Afterwards it says how large everything is; a ROOT that was named is kept.
set -euo pipefail
debs=$(cd "$1" && pwd)
root=${2:-}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [ -z "$root" ]; then
  root=$(mktemp -d)
  trap 'rm -rf "$root"' EXIT
fi
in_root() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/srv LC_ALL=C.UTF-8 "$@"; }
deb() { (cd "$root" && printf '/%s' debs/"$1"_*.deb); }
used() { du -sm --exclude=var/cache --exclude=var/lib/apt "$root" | cut -f 1; }

echo "== lintian"
lintian --allow-root --fail-on error --tag-display-limit 0 "$debs"/*.deb

echo "== a fresh root"
mmdebstrap --quiet --variant=apt bookworm "$root"
echo "$(used) MB"
mkdir "$root/debs"
cp "$debs"/*.deb "$root/debs"
cp /etc/resolv.conf "$root/etc/resolv.conf"
in_root apt-get -qq update

# install PACKAGE ...: from our files, the rest from Debian, without recommended packages.
install() {
  local before after
  before=$(used)
  in_root DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "$@" > "$root/install.log" 2>&1 ||
    { tail -n 30 "$root/install.log"; exit 1; }
  after=$(used)
  echo "$*: $((after - before)) MB with what it needs"
}

echo "== skyway"
install "$(deb skyway)"
in_root bash /usr/share/skyway/tools/demo.sh /usr/bin /srv/out
in_root skyway help > /dev/null

echo "== manual pages and completions"
install man-db bash-completion
for tool in "$root"/usr/bin/skyway*; do
  name=$(basename "$tool")
  # The image leaves out manual pages of Debian's own, not ours.
  in_root man --pager=cat "$name" 2> /dev/null | grep -q "^NAME" || { echo "no manual page of $name"; exit 1; }
  [ -s "$root/usr/share/zsh/vendor-completions/_$name" ] || { echo "no zsh completion of $name"; exit 1; }
done
for page in "$here"/docs/man/*.7.md; do
  in_root man --pager=cat 7 "$(basename "$page" .7.md)" 2> /dev/null | grep -q "^NAME" || { echo "no manual page of $page"; exit 1; }
done
offered=$(in_root bash -c 'source /usr/share/bash-completion/bash_completion; _completion_loader skyway-plan
  COMP_WORDS=(skyway-plan --sn) COMP_CWORD=1; _skyway_plan; echo "${COMPREPLY[@]}"')
[ "$offered" = --snap-ends ] || { echo "bash offers \"$offered\" after skyway-plan --sn"; exit 1; }

echo "== the chain"
install make
cp "$here/tests/cluster/make.sh" "$root/srv"
in_root bash /srv/make.sh /usr/bin /usr/share/skyway/cluster /usr/share/skyway/data/downtown.csv
[ -x "$root/usr/share/skyway/cluster/submit.sh" ] || { echo "submit.sh is not executable"; exit 1; }
[ -s "$root/usr/share/doc/skyway/cluster.md" ] || { echo "no cluster.md"; exit 1; }

cp "$here"/tests/golden/data/{scan.xyz,blocks.geojson} "$root/srv"
echo "== skyway-cloud"
install "$(deb skyway-cloud)"
in_root skyway-cloud -q /srv/scan.xyz -o /srv/scan.boxmap

echo "== skyway-footprints"
install "$(deb skyway-footprints)"
in_root skyway-footprints -q --allow-skipped --default-height 10 /srv/blocks.geojson -o /srv/blocks.boxmap
in_root skyway-info /srv/blocks.boxmap > /dev/null

echo "== skyway-mesh"
install "$(deb skyway-mesh)"
printf 'v 0 0 0\nv 4 0 0\nv 0 4 3\nf 1 2 3\n' > "$root/srv/roof.obj"
in_root skyway-mesh -q /srv/roof.obj -o /srv/roof.boxmap

echo "== python3-skyway"
install "$(deb python3-skyway)"
for example in read query plan solve check researcher lab; do
  in_root python3 "/usr/share/doc/python3-skyway/examples/$example.py" /srv/out
done

echo "== the README and docs/guide, as installed"
mkdir -p "$root/srv/pages"
cp "$here/tests/tools/pages/pages_test.py" "$root/srv"
cp "$here/README.md" "$root/srv/pages"
ln -s /usr/share/doc/skyway "$root/srv/pages/docs"
ln -s /usr/share/skyway/data "$root/srv/pages/data"
in_root python3 /srv/pages_test.py /usr/bin /srv/pages /usr/lib/python3/dist-packages

echo "== libskyway-dev"
install g++ cmake "$(deb libskyway-dev)"
cp -r "$here/tests/consumer" "$root/srv/consumer"
in_root cmake -S /srv/consumer -B /srv/consumer/build > /dev/null
in_root cmake --build /srv/consumer/build > /dev/null
printf 'boundary 0 0 0 10 10 10\nblock 4 0 0 5 8 8\n' | in_root /srv/consumer/build/consumer > /dev/null
echo "find_package(skyway) works"

echo "== sizes"
for deb in "$debs"/*.deb; do
  echo "$(dpkg-deb -f "$deb" Package): $(($(stat -c %s "$deb") / 1000)) kB, installed $(dpkg-deb -f "$deb" Installed-Size) kB"
done
