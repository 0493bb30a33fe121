/* fc.h: alter values and packets on their way through a program, on command.
 *
 * Contexts
 *   They own identifiers, faults, channels, seed, clock and errors, and do not influence each
 *   other. A NULL context means the default one, on which also the compatible headers act.
 * Names
 *   Byte strings compared exactly and copied; NULL equals "". Probes and channels have separate
 *   name spaces.
 * Results
 *   Below 0 are FC_E_ codes, FC_OK is 0, fault ids are above 0. On an error nothing has changed,
 *   the context's error counter and the thread's fc_last_error() are set, and the error callback
 *   is called.
 * Threads
 *   Every function may be called from any thread. A probe call, a put and a get are atomic per
 *   identifier; a probe call on an identifier without faults takes no lock. Callbacks run without
 *   any lock held.
 * Order
 *   A probe call walks the identifier's faults in the order of adding; for each it advances the
 *   trigger and, if triggered, applies the fault to the value left by the one before. */
#ifndef FC_H
#define FC_H

#include "fc_channel.h"
#include "fc_context.h"
#include "fc_fault.h"
#include "fc_list.h"
#include "fc_named.h"
#include "fc_probe.h"
#include "fc_record.h"
#include "fc_resolve.h"
#include "fc_snapshot.h"
#include "fc_trigger.h"

#endif
