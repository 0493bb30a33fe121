/* As the Erlang side makes it from headers: a pointer to each thing that a stripped library
 * exports. */
#include "torture.h"

struct point mirrored(struct point p);
int increment(void);
extern int plain;
extern struct point corners[2];

__typeof__(add) *cb_sig_add;
__typeof__(mirrored) *cb_sig_mirrored;
__typeof__(increment) *cb_sig_increment;
__typeof__(plain) *cb_sig_plain;
__typeof__(corners) *cb_sig_corners;
