# SPDX-License-Identifier: Apache-2.0
# Releases of Boresight, and what of them runs. Part of each script below.
root=/opt/boresight
config=/etc/boresight/boresight.conf

refuse() {
    echo "boresight: $1" >&2
    exit 1
}

# The supervisors that run from a release or from what was unpacked, wherever /opt leads, as folders of /proc.
running() {
    [ -d "$root" ] || return 0
    place=$(readlink -f "$root")
    for link in /proc/[0-9]*/exe; do
        program=$(readlink "$link" 2>/dev/null) || continue
        case $program in
        "$place"/*/bin/boresight | "$place"/*"/bin/boresight (deleted)") echo "${link%/exe}" ;;
        esac
    done
}

# Asks the supervisor $1 for $2 by its own program and options: another release may not know what this one shares.
ask() (
    cd "$1/cwd"
    words=$(tr '\0' '\n' <"$1/cmdline" | sed 1d)
    IFS='
'
    set -f
    # shellcheck disable=SC2086
    exec "$1/exe" $words "$2"
)

# Refuses the release in the folder $1 whose program knows a robot or an option of the configuration not. It is asked by a name
# that no process runs with.
require_fit() {
    [ -e "$config" ] || return 0
    reason=$("$1/bin/boresight" --config "$config" --instance "fits-$$" --at-rest 2>&1) ||
        refuse "nothing is replaced, the release does not fit $config. $reason"
}

# All of them, asked for $1.
ask_all() {
    for process in $(running); do
        reason=$(ask "$process" "$1" 2>&1) || refuse "nothing is replaced, process ${process#/proc/} runs. $reason"
        case $reason in
        # It runs, so another one was asked.
        'No Boresight runs'*) refuse "nothing is replaced, process ${process#/proc/} runs, and its options have changed since its start; stop it. $reason" ;;
        esac
    done
}

# Each ends by itself, in the cycle in which it is at rest: nothing begins between the question and its end.
stop_at_rest() {
    ask_all --at-rest
    ask_all --stop-at-rest
    await_end
}

stop_running() {
    for process in $(running); do kill -INT "${process#/proc/}"; done
    await_end
}

await_end() {
    for _ in 1 2 3 4 5 6 7 8 9 10; do
        if [ -z "$(running)" ]; then return; fi
        sleep 1
    done
    refuse "it does not stop; nothing is replaced."
}

# Where the link $1 leads, without its folder; nothing where there is none.
release() {
    basename "$(readlink "$root/$1")" 2>/dev/null || true
}

# Lets the link $1 lead to the release $2. A rename: there is always one of them.
point() {
    mkdir -p "$root/.switch"
    ln -sfn "releases/$2" "$root/.switch/$1"
    mv -f "$root/.switch/$1" "$root/"
    rmdir "$root/.switch"
}
