/* The median of three, and its three probes. */
#include "airbag.h"

#include <limits.h>

#include "check.h"
#include "faultcheck_wrapper.h"

static void the_median_of_every_order(void) {
    CHECK_INT(2, sensor_evaluate(1, 2, 3));
    CHECK_INT(2, sensor_evaluate(1, 3, 2));
    CHECK_INT(2, sensor_evaluate(2, 1, 3));
    CHECK_INT(2, sensor_evaluate(2, 3, 1));
    CHECK_INT(2, sensor_evaluate(3, 1, 2));
    CHECK_INT(2, sensor_evaluate(3, 2, 1));
    CHECK_INT(5, sensor_evaluate(5, 5, 9));
    CHECK_INT(0, sensor_evaluate(INT_MIN, 0, INT_MAX));
}

static void one_faulty_sensor_is_outvoted_and_two_are_not(void) {
    faultcheck_addFaultSetTo("S1val", 1000);
    CHECK_INT(10, sensor_evaluate(9, 9, 10));
    faultcheck_addFaultSetTo("S3val", 2000);
    CHECK_INT(1000, sensor_evaluate(9, 9, 10));
    faultcheck_removeAllFaults();
    CHECK_INT(9, sensor_evaluate(9, 9, 10));
}

static void each_sensor_is_a_probe_of_its_own(void) {
    faultcheck_addFaultOffset("S2val", -100);
    CHECK_INT(1, sensor_evaluate(1, 2, 3));
    faultcheck_removeAllFaults();
}

int main(void) {
    the_median_of_every_order();
    one_faulty_sensor_is_outvoted_and_two_are_not();
    each_sensor_is_a_probe_of_its_own();
    return check_result();
}
