/* The realistic faults of a vehicle (Paper III, 2.2; docs/faults.md), in simulated time: steps of 5
 * ms, ranges and messages every 100 ms. */
#include "errors.h"

#include <math.h>

enum { MS = 1000000, STEP = 5 * MS, MESSAGE = 92 };

static fc_context *ctx;
static int64_t sim_ns;

/* A clock may ask the library, also for what is being called: no lock is held. */
static int64_t sim_clock(void *user) {
    int64_t *asked = user;
    *asked += fc_num_active(ctx, "RollId0") + fc_channel_depth(ctx, "ITS_DATA0", "") + 1;
    return sim_ns;
}

static int64_t asked;

static void start(void) {
    ctx = fc_new(NULL);
    errors_start(ctx);
    sim_ns = 0;
    fc_set_clock(ctx, sim_clock, &asked);
}

static void finish(void) {
    CHECK_NO_ERROR();
    fc_free(ctx);
}

static fc_fault_id arm(const char *id, const char *model, const fc_argument *arguments,
                       size_t count) {
    const fc_fault_id fault = fc_arm_named(ctx, id, model, arguments, count);
    CHECK(fault > 0);
    return fault;
}

static fc_fault_id arm_channel(const char *model, const fc_argument *arguments, size_t count) {
    const fc_fault_id fault = fc_channel_arm_named(ctx, "ITS_DATA0", model, arguments, count);
    CHECK(fault > 0);
    return fault;
}

#define ARM(id, model, ...)                                                                        \
    arm(id, model, (const fc_argument[]){__VA_ARGS__},                                             \
        sizeof((const fc_argument[]){__VA_ARGS__}) / sizeof(fc_argument))
#define ARM_CHANNEL(model, ...)                                                                    \
    arm_channel(model, (const fc_argument[]){__VA_ARGS__},                                         \
                sizeof((const fc_argument[]){__VA_ARGS__}) / sizeof(fc_argument))

static double probe(const char *id, double value) {
    CHECK_INT(fc_probe_f64(ctx, id, &value), FC_OK);
    return value;
}

static void a_misaligned_accelerometer(void) {
    start();
    ARM("RollId0", "offset", {"value", NULL, 3});
    for (; sim_ns < 1000 * (int64_t)MS; sim_ns += STEP)
        CHECK_BITS(probe("RollId0", 10), 13);
    finish();
}

static void moving_air_holds_a_gust_and_ends(void) {
    start();
    const int64_t hold = 200 * (int64_t)MS, window = 3000 * (int64_t)MS;
    ARM("RollId0", "offset", {"value", NULL, 1}); /* two faults on one probe */
    const fc_fault_id gust = ARM("RollId0", "held_offset", {"low", NULL, -4}, {"high", NULL, 4},
                                 {"ns", NULL, (double)hold});
    CHECK_INT(fc_trigger_time(ctx, gust, 0, window), FC_OK);
    double held = 0;
    int changes = 0;
    for (; sim_ns < window; sim_ns += STEP) {
        const double now = probe("RollId0", 0) - 1;
        CHECK(now >= -4 && now <= 4);
        if (sim_ns % hold == 0) {
            changes += now != held;
            held = now;
        }
        CHECK_BITS(now, held);
    }
    CHECK_INT(changes, window / hold);
    for (; sim_ns < 2 * window; sim_ns += STEP)
        CHECK_BITS(probe("RollId0", 0), 1);
    finish();
}

static void noise_of_air_lasts_for_its_window(void) {
    start();
    const fc_fault_id noise = ARM("PitchId0", "noise_gauss", {"deviation", NULL, 1});
    CHECK_INT(fc_trigger_time(ctx, noise, 1000 * (int64_t)MS, 2000 * (int64_t)MS), FC_OK);
    int steps = 0;
    double sum = 0, squares = 0;
    for (; sim_ns < 4000 * (int64_t)MS; sim_ns += STEP) {
        const double x = probe("PitchId0", 0);
        CHECK((x != 0) == (sim_ns >= 1000 * (int64_t)MS && sim_ns < 3000 * (int64_t)MS));
        steps += x != 0;
        sum += x;
        squares += x * x;
    }
    CHECK_INT(steps, 400);
    CHECK(fabs(sum / steps) < 0.2 && squares / steps > 0.75 && squares / steps < 1.25);
    finish();
}

static void a_gyroscope_drifts_by_the_second_up_to_a_limit(void) {
    start();
    ARM("YawId0", "drift_timed", {"rate", NULL, 0.2}, {"limit", NULL, 20});
    for (; sim_ns <= 120 * (int64_t)1000 * MS; sim_ns += STEP) {
        const double seconds = (double)sim_ns * 1e-9;
        CHECK(fabs(probe("YawId0", 30) - 30 - fmin(0.2 * seconds, 20)) < 1e-12);
    }
    finish();
}

static void a_gain_cannot_be_seen_while_level(void) {
    start();
    ARM("PitchId0", "amplification", {"value", NULL, 0.95});
    CHECK_BITS(probe("PitchId0", 0), 0);
    CHECK_BITS(probe("PitchId0", -10), -9.5);
    finish();
}

static void scattered_reflections_are_never_too_short(void) {
    start();
    const fc_fault_id detour =
        ARM("RangeId0Anch2", "random_offset", {"low", NULL, 0.5}, {"high", NULL, 8});
    CHECK_INT(fc_trigger_random(ctx, detour, 0.2), FC_OK);
    int reflected = 0, long_ones = 0;
    for (int sample = 0; sample < 4000; sample++) {
        const double range = probe("RangeId0Anch2", 11);
        CHECK(range == 11 || (range >= 11.5 && range <= 19));
        reflected += range != 11;
        long_ones += range > 15.25;
    }
    CHECK(reflected > 680 && reflected < 920);  /* 800, deviation 25 */
    CHECK(long_ones > 300 && long_ones < 500);  /* half of them */
    CHECK_BITS(probe("RangeId0Anch1", 11), 11); /* of one anchor only */
    finish();
}

static void a_lasting_reflection_ends(void) {
    start();
    const fc_fault_id detour =
        ARM("RangeId0Anch2", "random_offset", {"low", NULL, 0.5}, {"high", NULL, 8});
    CHECK_INT(fc_trigger_time(ctx, detour, 500 * (int64_t)MS, 1000 * (int64_t)MS), FC_OK);
    int reflected = 0;
    for (; sim_ns < 3000 * (int64_t)MS; sim_ns += 100 * MS)
        reflected += probe("RangeId0Anch2", 11) >= 11.5;
    CHECK_INT(reflected, 10);
    finish();
}

static void a_misplaced_anchor_is_so_for_all_copters(void) {
    start();
    static const char *const of_copters[] = {"AnchXId0Anch1", "AnchXId1Anch1", "AnchXId7Anch1"};
    for (int at = 0; at < 3; at++)
        ARM(of_copters[at], "offset", {"value", NULL, 0.2});
    for (int at = 0; at < 3; at++)
        CHECK_BITS(probe(of_copters[at], -8), -7.8);
    finish();
}

/* A position to which the probe is applied in place: the offset is added once, not at each step. */
static void a_jump_takes_one_step(void) {
    start();
    fc_trigger_duration(ctx, ARM("PxId0", "offset", {"value", NULL, 1.5}), 1);
    double px = 2;
    for (int step = 0; step < 10; step++) {
        px = probe("PxId0", px);
        CHECK_BITS(px, 3.5);
    }
    finish();
}

/* One put of a message with that number, then gets until empty: the number of the last message got,
 * or -1. */
static unsigned char got[MESSAGE];

static int take(void) {
    int last = -1;
    for (;;) {
        size_t len = 0;
        const int result = fc_channel_get(ctx, "ITS_DATA0", "", got, sizeof got, &len);
        if (result != 1)
            return last;
        CHECK_INT(len, MESSAGE);
        last = got[0];
    }
}

static void send(int number) {
    unsigned char message[MESSAGE] = {0};
    message[0] = (unsigned char)number;
    CHECK_INT(fc_channel_put(ctx, "ITS_DATA0", message, sizeof message), FC_OK);
}

static void every_bit_of_a_message_can_be_corrupted(void) {
    start();
    for (int bit = 0; bit < 8 * MESSAGE; bit++) {
        ARM_CHANNEL("bitflip", {"byte", NULL, bit / 8}, {"bit", NULL, bit % 8});
        send(0);
        take();
        for (int byte = 0; byte < MESSAGE; byte++)
            CHECK_INT(got[byte], byte == bit / 8 ? 1 << bit % 8 : 0);
        fc_channel_remove_faults(ctx, "ITS_DATA0");
    }
    finish();
}

static void messages_are_lost_by_number_and_by_time(void) {
    start();
    ARM_CHANNEL("drop", {"count", NULL, 50});
    for (int number = 1; number <= 60; number++) {
        send(number);
        CHECK_INT(take(), number <= 50 ? -1 : number);
    }
    fc_channel_remove_faults(ctx, "ITS_DATA0");
    const fc_fault_id loss = arm_channel("lose", NULL, 0);
    CHECK_INT(fc_trigger_time(ctx, loss, 0, 800 * (int64_t)MS), FC_OK);
    for (int number = 1; number <= 20; number++, sim_ns += 100 * MS) {
        send(number);
        CHECK_INT(take(), number <= 8 ? -1 : number);
    }
    fc_channel_remove_faults(ctx, "ITS_DATA0");
    arm_channel("drop", NULL, 0); /* without a count: all */
    for (int number = 1; number <= 200; number++) {
        send(number);
        CHECK_INT(take(), -1);
    }
    finish();
}

/* The number of copies of a message, and the times from its sending to the first and the last. */
static void deliveries(int copies) {
    int delivered[3] = {0};
    for (int step = 0; step < 200; step++, sim_ns += STEP) {
        if (step % 20 == 0 && step / 20 < 3)
            send(step / 20);
        for (;;) {
            size_t len = 0;
            if (fc_channel_get(ctx, "ITS_DATA0", "", got, sizeof got, &len) != 1)
                break;
            CHECK_INT(step * 5, got[0] * 100 + 250);
            delivered[got[0]]++;
        }
    }
    CHECK_INT(delivered[0], copies);
    CHECK_INT(delivered[1], 1);
    CHECK_INT(delivered[2], 1);
}

static void messages_come_late_and_once_more(void) {
    start();
    fc_channel_handle handle;
    fc_resolve_channel(ctx, "ITS_DATA0", &handle);
    ARM_CHANNEL("delay", {"ns", NULL, 250. * MS});
    deliveries(1);
    ARM_CHANNEL("repeat", {"count", NULL, 3});
    deliveries(4);
    fc_channel_remove_faults(ctx, "ITS_DATA0");
    CHECK(fc_channel_is_idle(&handle));
    finish();
}

int main(void) {
    a_misaligned_accelerometer();
    moving_air_holds_a_gust_and_ends();
    noise_of_air_lasts_for_its_window();
    a_gyroscope_drifts_by_the_second_up_to_a_limit();
    a_gain_cannot_be_seen_while_level();
    scattered_reflections_are_never_too_short();
    a_lasting_reflection_ends();
    a_misplaced_anchor_is_so_for_all_copters();
    a_jump_takes_one_step();
    every_bit_of_a_message_can_be_corrupted();
    messages_are_lost_by_number_and_by_time();
    messages_come_late_and_once_more();
    CHECK(asked > 0);
    return CHECK_RESULT();
}
