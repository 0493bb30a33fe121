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
