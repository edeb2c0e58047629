# SPDX-License-Identifier: Apache-2.0
program=$root/current/bin/boresight

start() {
    if [ -n "$(running)" ]; then
        echo 'Boresight runs already.'
        return
    fi
    [ -x "$program" ] || refuse "there is no $program; install the package again."
    # Boresight itself reports rights that are not granted.
    ulimit -r 90 2>/dev/null || true
    ulimit -l unlimited 2>/dev/null || true
    # Its lines go to the system's log; a terminal that hangs up does not stop it.
    setsid sh -c '"$0" --config "$1" 2>&1 </dev/null | logger -t boresight' "$program" "$config" >/dev/null 2>&1 &
}

case ${1:-} in
start) start ;;
stop) stop_running ;;
restart | force-reload)
    stop_at_rest
    start
    ;;
status)
    [ -n "$(running)" ] || { echo 'Boresight does not run.'; exit 3; }
    echo 'Boresight runs.'
    ;;
*)
    echo "usage: $0 start|stop|restart|force-reload|status" >&2
    exit 2
    ;;
esac
