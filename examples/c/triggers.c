/* triggers.c: several faults on one value, each with a time of its own.
 *
 * The way of Paper I, section 4.5: faults are armed from outside the code under test, and a trigger
 * counts the probe's calls. Prints which calls are affected, so the figures can be compared with
 * those given to the triggers. */
#include <faultcheck_wrapper.h>
#include <stdio.h>

enum { CALLS = 300 };

int main(void) {
    faultcheck_addFaultBitFlip("value", 2);
    faultcheck_setTriggerAfterIterations("value", 120); /* calls 1..120 pass ... */
    faultcheck_setDurationAfterTrigger("value", 45);    /* ... and 45 are affected */

    faultcheck_addFaultOffset("value", 23);
    faultcheck_setTriggerAfterIterations("value", 45);
    faultcheck_setDurationAfterTrigger("value", 200);

    faultcheck_addFaultBitFlip("value", 11);
    faultcheck_setTriggerAfterIterations("value", 130);
    faultcheck_setDurationAfterTrigger("value", 10);

    printf("   calls  value  active faults\n");
    int from = 1;
    int before = 0;
    int active_before = 0;
    for (int call = 1; call <= CALLS + 1; call++) {
        int value = 0;
        faultcheck_injectFaultInt("value", &value);
        int active = faultcheck_numActiveFaults("value");
        if (call > CALLS || (call > 1 && value != before)) {
            printf("%3d..%3d  %5d  %d\n", from, call - 1, before, active_before);
            from = call;
        }
        before = value;
        active_before = active;
    }
    return 0;
}
