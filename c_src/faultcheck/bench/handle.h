/* handle.h: probes through the handle macros, in a file of their own so that nothing is folded. */
#ifndef HANDLE_H
#define HANDLE_H

void idle_by_handle(long count);
void active_by_handle(long count);
/* One value through ten probes. */
void probe_ten(double *value);

#endif
