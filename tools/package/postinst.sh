# SPDX-License-Identifier: Apache-2.0
if [ "${1:-}" != configure ]; then exit 0; fi
require_fit "$root/package"
stop_at_rest

# The package's own files are replaced by the next one; a release stays as it is.
name=@RELEASE@
while [ -e "$root/releases/$name" ] && ! diff -rq "$root/package" "$root/releases/$name" >/dev/null; do name=$name+; done
if [ ! -e "$root/releases/$name" ]; then
    mkdir -p "$root/releases"
    rm -rf "$root/.taken"
    cp -a "$root/package" "$root/.taken"
    mv "$root/.taken" "$root/releases/$name"
fi
before=$(release current)
if [ -n "$before" ] && [ "$before" != "$name" ]; then point previous "$before"; fi
point current "$name"

for folder in "$root"/releases/*; do
    case ${folder##*/} in
    "$name" | "$(release previous)") ;;
    *) rm -rf "$folder" ;;
    esac
done

if [ -d /run/systemd/system ]; then systemctl daemon-reload || true; fi
echo "Boresight $name is current${before:+, before it $before}. It is not started; see $root/current/share/commissioning.md."
