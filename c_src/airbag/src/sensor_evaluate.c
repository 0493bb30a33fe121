/* Median of three redundant sensors, each with a probe (Paper I, 4.3). */
#include "airbag.h"
#include "faultcheck_wrapper.h"

int sensor_evaluate(int s1, int s2, int s3) {
    faultcheck_injectFaultInt("S1val", &s1);
    faultcheck_injectFaultInt("S2val", &s2);
    faultcheck_injectFaultInt("S3val", &s3);

    int low = s1 < s2 ? s1 : s2;
    int high = s1 < s2 ? s2 : s1;
    if (s3 < low)
        return low;
    return s3 > high ? high : s3;
}
