/* slices.h: the fastest of many short slices, the median of several such. */
#ifndef SLICES_H
#define SLICES_H

/* Runs the operation `count` times. */
typedef void (*bench_fn)(long count);

/* Keeps this thread on the processor it is on. */
void bench_pin(void);
/* Lets the threads started from now on run on any processor. */
void bench_unpin(void);

/* Nanoseconds for one operation. */
double bench_ns(bench_fn operation);

void bench_print(const char *key, double value, const char *unit, const char *baseline,
                 double baseline_value);

#endif
