#define FC_DISABLE
#include "fc.h"

#include "handle_test.h"

double probe_disabled(double value) {
    FC_PROBE_F64("off", &value);
    return value;
}
