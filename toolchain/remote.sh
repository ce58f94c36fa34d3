# shellcheck shell=sh
# Shell functions of the scripts that connect to a robot: its options, its address, its ssh. The caller sets `root`, and
# `tool` to its own name.
: "${root:?}" "${tool:?}"

# Options of every such script; used by the functions below.
team="${NAOCAL_TEAM:-}"
user=nao
port=22

refuse() {
  echo "$tool: $*" >&2
  exit 2
}

# Option values become words of ssh and of the robot's shell, so only what they stand for is accepted.
matches() { # TEXT EXTENDED-REGEX: one line that matches as a whole
  [ "$(printf '%s' "$1" | wc -l)" -eq 0 ] && printf '%s\n' "$1" | LC_ALL=C grep -Eqx "$2"
}
is_address() { # four numbers up to 255, or a literal of IPv6
  byte='(25[0-5]|2[0-4][0-9]|1?[0-9]?[0-9])'
  matches "$1" "($byte\.){3}$byte|[0-9a-fA-F:]*:[0-9a-fA-F:]*"
}

check_connection() {
  matches "$user" '[A-Za-z_][A-Za-z0-9_.-]*' || refuse "--user: expected a user's name of letters, digits, '_', '.' and '-', found '$user'"
  { matches "$port" '[1-9][0-9]{0,4}' && [ "$port" -le 65535 ]; } || refuse "--port: expected a port number from 1 to 65535, found '$port'"
}

# Address of a robot number, by cable or wireless; other arguments are returned unchanged.
address() { # ROBOT
  matches "$1" '[A-Za-z0-9:][A-Za-z0-9_.:-]*' || refuse "expected a robot's number, name or address, found '$1'"
  case "$1" in
  *[!0-9]*w | w) echo "$1" && return ;;
  *w) net=0 number="${1%w}" ;;
  *[!0-9]*) echo "$1" && return ;;
  *) net=1 number="$1" ;;
  esac
  case "$team" in
  "" | *[!0-9]*) refuse "robot $1 is a number, so the team's is needed: --team N or \$NAOCAL_TEAM; found '$team'" ;;
  esac
  [ "${#number}" -le 3 ] && [ "$number" -le 245 ] && [ "${#team}" -le 3 ] && [ "$team" -le 255 ] ||
    refuse "robot $1 of team $team has no address: expected a robot up to 245 and a team up to 255"
  echo "10.$net.$team.$((10 + number))"
}

# Runs the script of standard input on the robot `host`.
on_robot() { # ARGUMENT...
  # shellcheck disable=SC2086 # splits $ssh into words
  $ssh "$user@$host" sh -s -- "$@"
}

# connect ROBOT: sets `host`, `rsync_host` (the host as rsync wants it: IPv6 in brackets) and `ssh`.
connect() {
  host="$(address "$1")"
  case "$host" in
  *:*) rsync_host="[$host]" ;;
  *) rsync_host="$host" ;;
  esac
  ssh="${NAOCAL_SSH:-ssh -o ConnectTimeout=5} -p $port"
}

# Runs this script once per robot, all at the same time; prefixes each line with its robot, and ends with a summary.
# Usage: each_robot "ROBOT..." OPTION...
each_robot() {
  robots="$1"
  shift
  logs="$(mktemp -d)"
  trap 'rm -rf "$logs"' EXIT
  for robot in $robots; do
    { { "$0" "$@" "$robot" 2>&1 || echo $? > "$logs/$robot"; } | sed "s/^/$robot: /"; } &
  done
  wait
  failed="$(ls "$logs")"
  # shellcheck disable=SC2086 # robots are words
  count="$(printf '%s\n' $robots | wc -l)"
  if [ -z "$failed" ]; then
    say "All $count robots are done"
    return 0
  fi
  say "$(printf '%s\n' "$failed" | wc -l) of $count robots failed: $(printf '%s\n' "$failed" | tr '\n' ' ')"
  return 1
}
