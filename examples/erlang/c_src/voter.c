/* voter.c: two ways to make one value of three redundant sensors. */
#include <fc.h>

/* The handle form of probes: one load and one branch while nothing is armed. */
static void read_sensors(double *s1, double *s2, double *s3) {
    FC_PROBE_F64("S1val", s1);
    FC_PROBE_F64("S2val", s2);
    FC_PROBE_F64("S3val", s3);
}

double voter_median(double s1, double s2, double s3) {
    read_sensors(&s1, &s2, &s3);
    double low = s1 < s2 ? s1 : s2;
    double high = s1 < s2 ? s2 : s1;
    return s3 < low ? low : s3 > high ? high : s3;
}

double voter_mean(double s1, double s2, double s3) {
    read_sensors(&s1, &s2, &s3);
    return (s1 + s2 + s3) / 3;
}
