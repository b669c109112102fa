# SPDX-License-Identifier: BSD-3-Clause
"""The check sums of results folders: FNV-1a with 64 bits of texts and lines, SHA-256 of listed files."""
from __future__ import annotations

import enum
from functools import lru_cache

import numpy as np

_OFFSET, _PRIME = 0xCBF29CE484222325, 0x100000001B3
_LOW_PRIME = _PRIME & 0xFF
_BLOCK = 1 << 16


@lru_cache(maxsize=1)
def _powers() -> np.ndarray:
    """_PRIME^n modulo 2^64, n = _BLOCK ... 1, so that the last `count` of them belong to a block of that length."""
    powers = np.multiply.accumulate(np.full(_BLOCK, _PRIME, dtype=np.uint64))
    return powers[::-1].copy()


def _low_bytes(text: np.ndarray, start: int) -> np.ndarray:
    """The low byte of (hash xor byte) before each multiplication.

    The low byte of the hash evolves by itself, and bit k of a product with an odd number is bit k of the factor,
    changed by its lower bits only. One bit after the other is therefore a cumulative exclusive or over the whole text.
    """
    mixed = np.zeros_like(text)
    for bit in range(8):
        carried = ((mixed * _LOW_PRIME) >> bit) & 1
        entering = (text >> bit) & 1
        # x_0 = bit of the start; x_{i+1} = x_i ^ text_i ^ carried_i; wanted is x_i ^ text_i.
        change = entering ^ carried
        before = np.empty_like(text)
        before[0] = (start >> bit) & 1
        np.bitwise_xor.accumulate(change[:-1], out=before[1:])
        before[1:] ^= before[0]
        mixed |= (before ^ entering) << bit
    return mixed


def hash64(text: bytes) -> int:
    """FNV-1a: hash = (hash xor byte) * prime modulo 2^64, for each byte.

    (hash xor byte) = hash + d, where d depends on the low byte of the hash alone. With all d of a block known, the hash
    is linear in them: a product of arrays in place of a loop over bytes.
    """
    value = _OFFSET
    data = np.frombuffer(text, dtype=np.uint8)
    for begin in range(0, len(data), _BLOCK):
        block = data[begin:begin + _BLOCK]
        mixed = _low_bytes(block, value & 0xFF)
        change = mixed.astype(np.int64) - (mixed ^ block).astype(np.int64)
        powers = _powers()[_BLOCK - len(block):]
        total = int((change.astype(np.uint64) * powers).sum(dtype=np.uint64))
        value = (value * int(powers[0]) + total) % (1 << 64)
    return value


def hash_text(text: bytes) -> str:
    """The hash as 16 hexadecimal digits."""
    return f"{hash64(text):016x}"


class SumState(enum.Enum):
    """Of an object whose last member may be its sum."""

    ABSENT = "absent"
    HOLDS = "holds"
    WRONG = "wrong"


def sum_state(text: bytes, before: bytes = b',"sum":"', after: bytes = b'"}') -> SumState:
    """Whether a JSON object ends in the sum of the text before it; `before` and `after` stand around the digits."""
    at = text.rfind(before)
    if at < 0:
        return SumState.ABSENT
    holds = text[at:] == before + hash_text(text[:at]).encode() + after
    return SumState.HOLDS if holds else SumState.WRONG


def line_sum_holds(line: bytes) -> bool:
    """Of a line of results or of a journal, without its end."""
    return sum_state(line) is SumState.HOLDS
