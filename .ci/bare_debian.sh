#!/bin/sh
# Runs both README commands on a bare Debian 12, in a chroot made from this machine's Debian mirror.
#   sh .ci/bare_debian.sh FOLDER   (as root, on Debian, with debootstrap and git installed)
# FOLDER is made if it does not exist; one that holds a Debian already is used again.
set -eu
repository=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
folder=${1:?usage: sh .ci/bare_debian.sh FOLDER}

if [ ! -e "$folder/etc/debian_version" ]; then
  mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | head -n 1)
  [ -n "$mirror" ] || { echo "apt knows of no mirror of Debian 12" >&2; exit 1; }
  debootstrap --variant=minbase bookworm "$folder" "$mirror"
fi
# The same way to the network as this machine's.
apt-config dump Acquire > "$folder/etc/apt/apt.conf.d/99host"
cp /etc/resolv.conf "$folder/etc/resolv.conf"

rm -rf "$folder/quadrille"
git clone --quiet --no-hardlinks "$repository" "$folder/quadrille"

mount -t proc proc "$folder/proc"
trap 'umount "$folder/proc"' EXIT
trap 'exit 1' HUP INT TERM
status=0
for command in "sh examples/run.sh" "sh test/run.sh"; do
  echo "== $command"
  chroot "$folder" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    sh -c "cd quadrille && $command" || { echo "== $command: exit status $?"; status=1; }
done
exit $status
