#!/usr/bin/env python3
"""What the sensor fault models make of a ramp 0, 1, 2, ...: a CSV table to look at or to plot.

libfaultcheck through ctypes. The fault acts from sample 4 to sample 11.
Usage: fault_shapes.py [SEED]      the seed of the random models, 1 by default
"""
import ctypes
import math
import sys

SAMPLES = 16
PROBE = b"sensor"
DOUBLE, INT, LONG = ctypes.c_double, ctypes.c_int, ctypes.c_int64

# A column: the function of fc_fault.h that arms the fault, and its parameters.
MODELS = {
    "offset": ("fc_add_offset", DOUBLE(2)),
    "stuck": ("fc_add_stuck",),
    "drift": ("fc_add_drift", DOUBLE(0.5), DOUBLE(math.inf)),
    "delay": ("fc_add_delay", LONG(3)),
    "quantise": ("fc_add_quantise", DOUBLE(5)),
    "saturate": ("fc_add_saturate", DOUBLE(0), DOUBLE(8)),
    "oscillate": ("fc_add_oscillate", DOUBLE(3), LONG(4)),
    "noise": ("fc_add_noise_uniform", DOUBLE(1)),
    "dropout": ("fc_add_dropout", DOUBLE(0.5), INT(1)),
}


def load(name):
    """Loads libfaultcheck and says what its functions take and give."""
    try:
        library = ctypes.CDLL(name)
    except OSError as error:
        sys.exit(f"{error}; LD_LIBRARY_PATH must name the folder of {name}")
    library.fc_new.restype = ctypes.c_void_p
    library.fc_free.argtypes = [ctypes.c_void_p]
    library.fc_seed.argtypes = [ctypes.c_void_p, ctypes.c_uint64]
    library.fc_trigger_after.argtypes = [ctypes.c_void_p, LONG, ctypes.c_uint64]
    library.fc_trigger_duration.argtypes = [ctypes.c_void_p, LONG, LONG]
    library.fc_probe_f64.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(DOUBLE)]
    library.fc_last_error_text.restype = ctypes.c_char_p
    return library


def column(library, seed, function, *parameters):
    """The ramp as a probe with one fault gives it."""
    context = ctypes.c_void_p(library.fc_new(None))
    library.fc_seed(context, seed)
    add = library[function]  # a fresh function object: its argument types are this model's
    add.restype = LONG
    fault = add(context, PROBE, *parameters)
    if fault < 0:
        sys.exit(f"{function}: {library.fc_last_error_text().decode()}")
    library.fc_trigger_after(context, fault, 4)
    library.fc_trigger_duration(context, fault, 8)
    values = []
    for sample in range(SAMPLES):
        value = DOUBLE(sample)
        library.fc_probe_f64(context, PROBE, ctypes.byref(value))
        values.append(value.value)
    library.fc_free(context)
    return values


def main():
    """Prints the table."""
    try:
        seed = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    except ValueError:
        sys.exit(f"fault_shapes.py: the seed must be a whole number, not {sys.argv[1]!r}")
    library = load("libfaultcheck.so.0")
    columns = {name: column(library, seed, *model) for name, model in MODELS.items()}
    print(",".join(["input", *columns]))
    for sample, row in enumerate(zip(*columns.values())):
        print(",".join([str(sample), *(f"{value:g}" for value in row)]))


if __name__ == "__main__":
    main()
