/* The driver fc_threads itself, and what 7.4 promises of every run of it. */
#include "check.h"
#include "fc_threads.h"

enum { kRepetitions = 400 };

static const fc_threads_result *result(const fc_threads *plan, int calls, int repetition, int at) {
    return &fc_threads_results(plan)[repetition * calls + at];
}

/* Four calls, one of them affected: whichever came first. */
static void one_call_uses_up_a_once_trigger(void) {
    fc_threads *plan = fc_threads_new(2);
    const fc_model model = {FC_OFFSET, 100, 0, 0};
    const int32_t value = 1;
    const int fault = fc_threads_arm(plan, 0, "x", &model);
    fc_threads_faulted(plan, 0, FC_THREADS_ONCE_AFTER, fault, 0, 0);
    for (int call = 0; call < 4; ++call)
        fc_threads_probe(plan, 1 + call % 2, FC_I32, "x", &value, sizeof value);
    const int last = fc_threads_named(plan, 3, FC_THREADS_NUM_ACTIVE, "x");
    CHECK_INT(last, 6);
    CHECK_INT(fc_threads_run(plan, kRepetitions, 1), 0);
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
        int affected = 0;
        for (int call = 2; call < 6; ++call) {
            int32_t after;
            memcpy(&after, result(plan, 7, repetition, call)->data, sizeof after);
            CHECK(after == 1 || after == 101);
            affected += after == 101;
        }
        CHECK_INT(affected, 1);
        CHECK_INT(result(plan, 7, repetition, last)->value, 0);
    }
    fc_threads_free(plan);
}

static void every_packet_is_delivered_once(void) {
    fc_threads *plan = fc_threads_new(3);
    for (int call = 0; call < 6; ++call) {
        const unsigned char packet = (unsigned char)(1 << call);
        fc_threads_put(plan, 1 + call % 3, "c", &packet, 1);
        fc_threads_get(plan, 1 + call % 3, "c", "");
    }
    for (int call = 0; call < 6; ++call)
        fc_threads_get(plan, 4, "c", "");
    CHECK_INT(fc_threads_paired(plan, 4, FC_THREADS_DEPTH, "c", ""), 18);
    CHECK_INT(fc_threads_run(plan, kRepetitions, 2), 0);
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
        unsigned sum = 0;
        for (int call = 0; call < 18; ++call)
            sum += result(plan, 19, repetition, call)->data[0];
        CHECK_INT(sum, 63);
        CHECK_INT(result(plan, 19, repetition, 18)->value, 0);
    }
    fc_threads_free(plan);
}

/* How many probe calls of the plan below started after the arming call had returned, in one run;
 * each of them must see the fault. */
static int calls_after_arming(fc_threads *plan, int armed, uint64_t seed) {
    CHECK_INT(fc_threads_run(plan, kRepetitions, seed), 0);
    int later = 0;
    for (int repetition = 1; repetition < kRepetitions; repetition += 2)
        for (int call = armed + 1; call < armed + 6; ++call) {
            const fc_threads_result *probed = result(plan, 7, repetition, call);
            int32_t after;
            memcpy(&after, probed->data, sizeof after);
            CHECK(probed->begin > 0 && probed->end > probed->begin);
            if (probed->begin > result(plan, 7, repetition, armed)->end) {
                CHECK_INT(after, 7);
                ++later;
            }
        }
    return later;
}

/* Arming is seen by every probe call that starts after the arming call returned. A busy machine may
 * let one thread end before the other begins, in all of a run: then there is another one. */
static void arming_is_seen_by_later_calls(void) {
    fc_threads *plan = fc_threads_new(2);
    const fc_model model = {FC_SET_TO, 7, 0, 0};
    const int32_t value = 1;
    fc_threads_probe(plan, 0, FC_I32, "x", &value, sizeof value);
    const int armed = fc_threads_arm(plan, 1, "x", &model);
    for (int call = 0; call < 5; ++call)
        fc_threads_probe_handle(plan, 2, 1);
    int later = 0;
    for (uint64_t seed = 3; later == 0 && seed < 203; ++seed)
        later = calls_after_arming(plan, armed, seed);
    CHECK(later > 0);
    fc_threads_free(plan);
}

/* Everything that arms, disarms and triggers meets probes, puts and gets; for ThreadSanitizer. */
static void everything_at_once(void) {
    fc_threads *plan = fc_threads_new(4);
    const fc_model model = {FC_BITFLIP_RANDOM, 0, 0, 0};
    const fc_model held = {FC_DELAY, 0, 0, 2};
    const unsigned char bytes[] = {1, 2, 3};
    const double value = 1.5;
    const int first = fc_threads_arm(plan, 0, "x", &model);
    for (int lane = 1; lane <= 4; ++lane) {
        const int mine = fc_threads_arm(plan, lane, "x", lane % 2 == 0 ? &model : &held);
        fc_threads_probe(plan, lane, FC_F64, "x", &value, sizeof value);
        fc_threads_probe(plan, lane, FC_BYTES, "y", bytes, sizeof bytes);
        fc_threads_faulted(plan, lane, FC_THREADS_RANDOM, first, 1, 2);
        fc_threads_faulted(plan, lane, FC_THREADS_PERIODIC, mine, 3, 2);
        fc_threads_put(plan, lane, "c", bytes, sizeof bytes);
        fc_threads_numbered(plan, lane, FC_THREADS_CORRUPTION, "c", lane);
        fc_threads_paired(plan, lane, FC_THREADS_SUBSCRIBE, "c", lane % 2 == 0 ? "r" : "s");
        fc_threads_get(plan, lane, "c", lane % 2 == 0 ? "r" : "");
        fc_threads_named(plan, lane, FC_THREADS_LATEST, "x");
        fc_threads_paired(plan, lane, FC_THREADS_MISROUTE, "c", "d");
        fc_threads_probe_handle(plan, lane, 5);
        fc_threads_faulted(plan, lane, FC_THREADS_ENABLE, first, lane % 2, 0);
        fc_threads_faulted(plan, lane, FC_THREADS_REMOVE, mine, 0, 0);
        fc_threads_named(plan, lane, FC_THREADS_CHANNEL_REMOVE_ALL, "c");
    }
    CHECK_INT(fc_threads_run(plan, kRepetitions, 4), 0);
    fc_threads_free(plan);
}

static void wrong_calls_are_refused(void) {
    CHECK(fc_threads_new(0) == NULL);
    CHECK(fc_threads_new(FC_THREADS_MOST + 1) == NULL);
    fc_threads *plan = fc_threads_new(1);
    const unsigned char bytes[FC_THREADS_DATA + 1] = {0};
    CHECK_INT(fc_threads_get(plan, -1, "c", ""), -1);
    CHECK_INT(fc_threads_get(plan, 3, "c", ""), -1);
    CHECK_INT(fc_threads_put(plan, 1, "c", bytes, sizeof bytes), -1);
    CHECK_INT(fc_threads_faulted(plan, 1, FC_THREADS_NONE, 0, 0, 0), -1);
    CHECK_INT(fc_threads_run(plan, 0, 1), -1);
    CHECK_INT(fc_threads_run(plan, 1, 1), 0);
    fc_threads_free(plan);
    fc_threads_free(NULL);
}

int main(void) {
    one_call_uses_up_a_once_trigger();
    every_packet_is_delivered_once();
    arming_is_seen_by_later_calls();
    everything_at_once();
    wrong_calls_are_refused();
    return CHECK_RESULT();
}
