/* handle.c: what the handle macros cost. */
#include "handle.h"

#include "fc.h"

static volatile double sink;

void idle_by_handle(long count) {
    double value = 5;
    for (long i = 0; i < count; i++)
        FC_PROBE_F64("speed", &value);
    sink = value;
}

void active_by_handle(long count) {
    double value = 5;
    for (long i = 0; i < count; i++)
        FC_PROBE_F64("yaw", &value);
    sink = value;
}

void probe_ten(double *value) {
    FC_PROBE_F64("r0", value);
    FC_PROBE_F64("r1", value);
    FC_PROBE_F64("r2", value);
    FC_PROBE_F64("r3", value);
    FC_PROBE_F64("r4", value);
    FC_PROBE_F64("r5", value);
    FC_PROBE_F64("r6", value);
    FC_PROBE_F64("r7", value);
    FC_PROBE_F64("r8", value);
    FC_PROBE_F64("r9", value);
}
