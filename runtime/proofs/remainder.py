#!/usr/bin/env python3
"""How near a double comes to a multiple of pi/2, by continued fractions; and the words of 2/pi that the code holds.

For x = m 2^e with m < 2^53 the distance of x 2/pi from whole numbers is least at a convergent of 2^e 2/pi with
denominator below 2^53. Whole-number arithmetic throughout, 2/pi to 3,000 bits by Machin's formula.
"""

import re
import sys

BITS = 3000


def arctan_inverse(n, one):
    """arctan(1/n) times `one`, truncated."""
    term = one // n
    total, k, sign = term, 1, 1
    while term:
        term //= n * n
        k += 2
        sign = -sign
        total += sign * (term // k)
    return total


one = 1 << (BITS + 64)
pi = 4 * (4 * arctan_inverse(5, one) - arctan_inverse(239, one))
two_over_pi = (2 << (2 * (BITS + 64))) // pi >> 64  # times 2^BITS

failed = 0
code = open("../src/interval/functions/remainder.rs", encoding="utf-8").read()
table = re.search(r"TWO_OVER_PI: \[u64; 20\] = \[(.*?)\]", code, re.S).group(1)
words = [int(w.replace("_", ""), 16) for w in re.findall(r"0x[0-9a-f_]+", table)]
exact = [two_over_pi >> (BITS - 64 * (i + 1)) & (2**64 - 1) for i in range(20)]
if words != exact:
    print("FAILED: the words of 2/pi differ")
    failed = 1


def worst():
    """log2 of a lower bound of the distance: at the last convergent p/q with q < 2^53 it is above 1/(2 next q)."""
    least = 0
    for e in range(-60, 972):
        # Convergents of frac(2^e 2/pi): denominators start 1, then the quotients.
        scaled = two_over_pi << (e + 60)
        one_here = 1 << (BITS + 60)
        fraction = scaled % one_here
        q0, q1 = 0, 1
        p, q = one_here, fraction
        while q:
            a = p // q
            p, q = q, p - a * q
            q0, q1 = q1, a * q1 + q0
            if q1 >= 1 << 53:
                least = min(least, -(q1.bit_length() + 1))
                break
    return least


bound = worst()
print(f"every double but 0 is more than 2^{bound} (in quarter turns) from a multiple of pi/2")
if bound < -65:
    print("FAILED: the code relies on 2^-65")
    failed = 1
sys.exit(failed)
