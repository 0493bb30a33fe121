#!/usr/bin/env python3
"""How many corrupted packets does E2E profile 1 let pass? Every flip of 1, 2 and 3 bits is tried.

libe2e through ctypes: the structures are those of E2E_P01.h. Usage: bitflips.py
"""
import ctypes
import itertools
import sys


class Config(ctypes.Structure):
    """E2E_P01ConfigType; offsets and lengths in bits."""
    _fields_ = [
        ("CounterOffset", ctypes.c_uint16),
        ("CRCOffset", ctypes.c_uint16),
        ("DataID", ctypes.c_uint16),
        ("DataIDNibbleOffset", ctypes.c_uint16),
        ("DataIDMode", ctypes.c_int),
        ("DataLength", ctypes.c_uint16),
        ("MaxDeltaCounterInit", ctypes.c_uint8),
        ("MaxNoNewOrRepeatedData", ctypes.c_uint8),
        ("SyncCounterInit", ctypes.c_uint8),
    ]


class ProtectState(ctypes.Structure):
    """E2E_P01ProtectStateType."""
    _fields_ = [("Counter", ctypes.c_uint8)]


class CheckState(ctypes.Structure):
    """E2E_P01CheckStateType."""
    _fields_ = [
        ("LastValidCounter", ctypes.c_uint8),
        ("MaxDeltaCounter", ctypes.c_uint8),
        ("WaitForFirstData", ctypes.c_uint8),
        ("NewDataAvailable", ctypes.c_uint8),
        ("LostData", ctypes.c_uint8),
        ("Status", ctypes.c_int),
        ("SyncCounter", ctypes.c_uint8),
        ("NoNewOrRepeatedDataCounter", ctypes.c_uint8),
    ]


OK = 0
STATUS_WRONGCRC = 2
BITS = 32


def load(name):
    """Loads one of FaultCheck's libraries."""
    try:
        return ctypes.CDLL(name)
    except OSError as error:
        sys.exit(f"{error}; LD_LIBRARY_PATH must name the folder of {name}")


def protected_packet(e2e, config):
    """A packet of four bytes: CRC, two of payload, counter."""
    packet = (ctypes.c_uint8 * (BITS // 8))(0, 85, 170, 0)
    state = ProtectState()
    e2e.E2E_P01ProtectInit(ctypes.byref(state))
    e2e.E2E_P01Protect(ctypes.byref(config), ctypes.byref(state), packet)
    return int.from_bytes(bytes(packet), "little")


def passes(e2e, config, packet):
    """Whether a receiver that waits for its first packet believes this one."""
    state = CheckState()
    e2e.E2E_P01CheckInit(ctypes.byref(state))
    state.NewDataAvailable = 1
    data = packet.to_bytes(BITS // 8, "little")
    returned = e2e.E2E_P01Check(ctypes.byref(config), ctypes.byref(state), data)
    return returned == OK and state.Status != STATUS_WRONGCRC


def main():
    """Prints a line for each number of flipped bits."""
    e2e = load("libe2e.so.0")
    config = Config(CounterOffset=24, CRCOffset=0, DataID=0x123, DataLength=BITS,
                    MaxDeltaCounterInit=3, MaxNoNewOrRepeatedData=14)
    if e2e.E2E_P01CheckConfig(ctypes.byref(config)) != OK:
        sys.exit("the configuration is not one of the standard")
    packet = protected_packet(e2e, config)
    print(f"packet {packet.to_bytes(4, 'little').hex(' ')}")
    for flips in (1, 2, 3):
        tried = undetected = 0
        for bits in itertools.combinations(range(BITS), flips):
            tried += 1
            undetected += passes(e2e, config, packet ^ sum(1 << bit for bit in bits))
        print(f"{flips} bits flipped: {undetected:2} of {tried} packets pass")


if __name__ == "__main__":
    main()
