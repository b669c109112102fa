# SPDX-License-Identifier: BSD-3-Clause
"""All attacks: importing a file registers those in it."""
import builds
import damage
import duration
import equal_bytes
import faults
import folders
import fuzzing
import kills
import memory
import mutants
import scarcity
import values

LOADED = (builds, damage, duration, equal_bytes, faults, folders, fuzzing, kills, memory, mutants, scarcity, values)
