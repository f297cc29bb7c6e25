#!/bin/sh
# Re-runs the proofs and compares the constants of the code, of Sollya and of the Gappa scripts.
# Needs sollya and gappa (both are Debian packages).
set -eu
cd "$(dirname "$0")"
functions=../src/interval/functions
failed=0

# prove SCRIPT HALF BOUND: one Gappa script with its placeholders filled in.
prove() {
    if sed -e "s/@HALF@/$2/" -e "s/@BOUND@/$3/" "$1" | gappa -Wno-dichotomy-failure >/dev/null 2>&1; then
        echo "proved $1 on $2: $3"
    else
        echo "FAILED $1 on $2: $3"
        failed=1
    fi
}

# same NAME CODE SCRIPT...: the constants that Sollya prints stand in the code (their bits) and in the Gappa scripts
# (the coefficients).
same() {
    name=$1
    code=$2
    shift 2
    constants=$(sollya "$name.sollya" </dev/null)
    for bits in $(echo "$constants" | grep '^0x'); do
        grep -q "$bits" "$code" || { echo "FAILED: $bits of $name.sollya is not in $code"; failed=1; }
    done
    for literal in $(echo "$constants" | sed -n 's/^Q[0-9]* = //p'); do
        for script in "$@"; do
            grep -q "= $literal;" "$script" || { echo "FAILED: $literal of $name.sollya is not in $script"; failed=1; }
        done
    done
    echo "compared the constants of $name.sollya, $code, $*"
}

same exp "$functions/exp.rs" exp_fused.g exp_plain.g
for script in exp_fused.g exp_plain.g; do
    prove "$script" "[-0.34658, 0]" 4.3e-17
    prove "$script" "[0, 0.34658]" 8e-17
done
exit "$failed"
