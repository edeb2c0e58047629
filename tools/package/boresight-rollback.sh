# SPDX-License-Identifier: Apache-2.0
if [ $# -gt 0 ]; then
    echo 'Makes the release before this one the current one; again, and this one is. Nothing else is changed.

usage: boresight-rollback

Refused while a drive is on, a motion is armed or a client has left START_UP, and if that release does not know a robot or an
option of the configuration. Boresight is stopped, and not started.
Exit code 0: done. 1: refused.'
    [ "$1" = --help ] || [ "$1" = -h ] || exit 2
    exit 0
fi

now=$(release current)
before=$(release previous)
if [ -z "$before" ] || [ ! -d "$root/releases/$before" ]; then refuse 'there is no release before this one.'; fi
if [ "$before" = "$now" ]; then refuse 'the release before this one is this one; install the one you want.'; fi
if [ ! -w "$root" ]; then refuse "$root cannot be written; be root."; fi
require_fit "$root/releases/$before"
stop_at_rest
point current "$before"
point previous "$now"
echo "Boresight $before is current, before it $now. It is not started."
