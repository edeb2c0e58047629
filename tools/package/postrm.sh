# SPDX-License-Identifier: Apache-2.0
case ${1:-} in
remove | purge)
    rm -rf "$root/releases" "$root/current" "$root/previous" "$root/.taken" "$root/.switch"
    rmdir "$root" 2>/dev/null || true
    ;;
esac
if [ "${1:-}" = purge ]; then
    rmdir /etc/boresight 2>/dev/null || true
    if [ -d /var/lib/boresight ] && ! rmdir /var/lib/boresight 2>/dev/null; then
        echo "Recordings stay in /var/lib/boresight; remove them yourself."
    fi
fi
