#!/bin/sh
# Re-runs the proofs and compares the constants of the code, of Sollya and of the Gappa scripts.
# Needs sollya, gappa (both are Debian packages) and python3.
set -eu
cd "$(dirname "$0")"
functions=../src/interval/functions
failed=0

# prove SCRIPT HALF BOUND: one Gappa script, with its placeholders (if it has any) filled in.
product="("
prove() {
    if sed -e "s/@HALF@/$2/" -e "s/@BOUND@/$3/" -e "s/@(/$product/g" "$1" | gappa -Wno-dichotomy-failure >/dev/null 2>&1; then
        echo "proved $1 ${2:+on $2: $3}"
    else
        echo "FAILED $1 ${2:+on $2: $3}"
        failed=1
    fi
}

# both SCRIPT HALF BOUND: a script for both ways of computing. Products that are written @(a * b) are exact with fused
# operations, and rounded without.
both() {
    prove "$@"
    product="rnd("
    prove "$@"
    product="("
}

# same NAME SCRIPTS CODE...: the constants that Sollya prints stand in the code (their bits), and the coefficients in one
# of the Gappa scripts for each way of computing (or the one for both). What a Sollya script claims must hold.
same() {
    name=$1
    scripts=$2
    shift 2
    constants=$(sollya "$name.sollya" </dev/null)
    echo "$constants" | grep '^proved' || true
    if echo "$constants" | grep 'FAILED'; then failed=1; fi
    for bits in $(echo "$constants" | grep '^0x'); do
        cat "$@" | grep -q "$bits" || { echo "FAILED: $bits of $name.sollya is not in $*"; failed=1; }
    done
    for way in fused plain; do
        for literal in $(echo "$constants" | sed -n 's/^[ABCLQS][0-9]* = //p'); do
            # shellcheck disable=SC2086
            (for script in $scripts; do cat "$script.g" 2>/dev/null || cat "${script}_$way.g"; done) | grep -q "= $literal;" ||
                { echo "FAILED: $literal of $name.sollya is not in $scripts"; failed=1; }
        done
    done
    echo "compared the constants of $name.sollya with ${scripts:+$scripts, }$*"
}

same exp exp "$functions/exp.rs"
for script in exp_fused.g exp_plain.g; do
    prove "$script" "[-0.34658, 0]" 4.3e-17
    prove "$script" "[0, 0.34658]" 8e-17
done
same exp exp_m1 "$functions/exp.rs"
same exp exp_m1_zero "$functions/exp.rs"
both exp_m1.g "[-0.34658, 0]" 1.45e-17
both exp_m1.g "[0, 0.34658]" 2.6e-17
both exp_m1_zero.g "[-0.34658, -1b-40]" 3.38e-16
both exp_m1_zero.g "[1b-40, 0.34658]" 3.38e-16
same exp_m1 "" "$functions/hyperbolic.rs"
same derived "" "$functions/derived.rs"
same fine "" ../src/interval/fine/functions.rs
for wave in sin cos; do
    for script in "${wave}_fused.g" "${wave}_plain.g"; do
        prove "$script" "" ""
    done
done
same sincos "sin cos" "$functions/circular.rs" "$functions/remainder.rs"
same ln ln "$functions/ln.rs"
prove ln_fused.g "[1b-53, 0.33334]" 7.2e-16
prove ln_fused.g "[-0.33334, -1b-53]" 6.1e-16
prove ln_plain.g "[1b-53, 0.33334]" 1e-15
prove ln_plain.g "[-0.33334, -1b-53]" 1e-15
same logarithm logarithm "$functions/logarithm.rs"
prove logarithm.g "" 1.7e-19
product="rnd("
prove logarithm.g "" 2.26e-19
product="("
same atan atan "$functions/arctangent.rs" "$functions/angle.rs"
both atan.g "" ""
same asin asin "$functions/arcsine.rs"
both asin.g "" ""
same cbrt "" "$functions/cbrt.rs"
prove cbrt.g "" ""
python3 remainder.py || failed=1
exit "$failed"
