# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Compares what a command printed with what the manual shows.

Words must be the same, however far apart. Numbers with decimals may differ by one in the last digit shown. "..." stands
for any words of a line, on a line of its own for any lines.
"""
import re

NUMBER = re.compile(r"[-+]?\d+\.\d+(?:[eE][-+]?\d+)?$|[-+]?\d+[eE][-+]?\d+$")
WORD = re.compile(r"[^\s,()]+|[,()]")


def unit(shown):
    """The value of a number's last digit."""
    mantissa, _, exponent = shown.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** (int(exponent or 0) - decimals)


def same_word(shown, printed):
    if shown == printed:
        return True
    if not NUMBER.match(shown):
        return False
    try:
        return abs(float(shown) - float(printed)) <= 1.01 * unit(shown)
    except ValueError:
        return False


def matches(shown, printed, same):
    """Whether two lists agree, where "..." in the first stands for any number of items."""
    if not shown:
        return not printed
    if shown[0] == "...":
        return any(matches(shown[1:], printed[i:], same) for i in range(len(printed) + 1))
    return bool(printed) and same(shown[0], printed[0]) and matches(shown[1:], printed[1:], same)


def same_line(shown, printed):
    return matches(WORD.findall(shown), WORD.findall(printed), same_word)


def same_output(shown, printed):
    lines = ["..." if line.strip() == "..." else line for line in shown.splitlines()]
    return matches(lines, printed.splitlines(), same_line)
