/* handle_test.h: a probe compiled with FC_DISABLE. */
#ifndef HANDLE_TEST_H
#define HANDLE_TEST_H

double probe_disabled(double value);

#endif
