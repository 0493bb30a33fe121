#include "fc_threads.h"

#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

typedef struct call call;
typedef struct worker worker;

/* Makes one call; `all` are the results of this repetition. */
typedef void (*make_fn)(const call *call, const fc_threads_result *all, fc_threads_result *result);

struct call {
    make_fn make;
    int lane;
    int which;
    char *name;
    char *other;
    int armed_by;
    int64_t n;
    int64_t m;
    fc_model model;
    size_t size;
    unsigned char data[FC_THREADS_DATA];
};

struct worker {
    fc_threads *plan;
    int lane;
    pthread_t thread;
};

struct fc_threads {
    int threads;
    call *calls;
    size_t count;
    size_t capacity;
    fc_threads_result *results;
    int repetitions;
    uint64_t seed;
    worker workers[FC_THREADS_MOST];
    /* The rest is shared by the threads of a run. */
    int abandoned;   /* a thread could not be started */
    int round;       /* that the threads may begin, from 1 */
    int done;        /* threads that have finished it */
    uint64_t ticket; /* the next time */
};

fc_threads *fc_threads_new(int threads) {
    if (threads < 1 || threads > FC_THREADS_MOST)
        return NULL;
    fc_threads *plan = calloc(1, sizeof *plan);
    if (plan != NULL)
        plan->threads = threads;
    return plan;
}

void fc_threads_free(fc_threads *plan) {
    if (plan == NULL)
        return;
    for (size_t at = 0; at < plan->count; ++at) {
        free(plan->calls[at].name);
        free(plan->calls[at].other);
    }
    free(plan->calls);
    free(plan->results);
    free(plan);
}

/* ---- the calls ---------------------------------------------------------------------------- */

static int probe_value(fc_type type, const char *id, void *value, size_t size) {
    switch (type) {
    case FC_F32:
        return fc_probe_f32(NULL, id, value);
    case FC_F64:
        return fc_probe_f64(NULL, id, value);
    case FC_I8:
        return fc_probe_i8(NULL, id, value);
    case FC_I16:
        return fc_probe_i16(NULL, id, value);
    case FC_I32:
        return fc_probe_i32(NULL, id, value);
    case FC_I64:
        return fc_probe_i64(NULL, id, value);
    case FC_U8:
        return fc_probe_u8(NULL, id, value);
    case FC_U16:
        return fc_probe_u16(NULL, id, value);
    case FC_U32:
        return fc_probe_u32(NULL, id, value);
    case FC_U64:
        return fc_probe_u64(NULL, id, value);
    case FC_BOOL:
        return fc_probe_bool(NULL, id, value);
    case FC_BYTES:
        return fc_probe_bytes(NULL, id, value, size);
    }
    return FC_E_ARG;
}

static void make_probe(const call *call, const fc_threads_result *all, fc_threads_result *result) {
    (void)all;
    union {
        unsigned char bytes[FC_THREADS_DATA];
        double aligned;
        int64_t as_well;
    } value;
    memcpy(value.bytes, call->data, sizeof value.bytes);
    result->value = probe_value((fc_type)call->which, call->name, value.bytes, call->size);
    result->size = call->size;
    memcpy(result->data, value.bytes, sizeof result->data);
}

static void make_handle(const call *call, const fc_threads_result *all, fc_threads_result *result) {
    (void)all;
    int32_t value = (int32_t)call->n;
    FC_PROBE_I32("x", &value);
    result->value = FC_OK; /* the macro tells no more */
    result->size = sizeof value;
    memcpy(result->data, &value, sizeof value);
}

static void make_put(const call *call, const fc_threads_result *all, fc_threads_result *result) {
    (void)all;
    result->value = fc_channel_put(NULL, call->name, call->data, call->size);
}

static void make_get(const call *call, const fc_threads_result *all, fc_threads_result *result) {
    (void)all;
    size_t size = 0;
    result->value =
        fc_channel_get(NULL, call->name, call->other, result->data, FC_THREADS_DATA, &size);
    result->size = size;
}

static void make_arm(const call *call, const fc_threads_result *all, fc_threads_result *result) {
    (void)all;
    result->value = fc_add_model(NULL, call->name, &call->model);
}

static int64_t call_named(fc_threads_of_name which, const char *name) {
    switch (which) {
    case FC_THREADS_NUM_ACTIVE:
        return fc_num_active(NULL, name);
    case FC_THREADS_LATEST:
        return fc_latest(NULL, name);
    case FC_THREADS_REMOVE_ALL:
        fc_remove_probe_faults(NULL, name);
        return 0;
    case FC_THREADS_CHANNEL_LATEST:
        return fc_channel_latest(NULL, name);
    case FC_THREADS_CHANNEL_REMOVE_ALL:
        fc_channel_remove_faults(NULL, name);
        return 0;
    case FC_THREADS_CLEAR:
        fc_channel_clear(NULL, name);
        return 0;
    case FC_THREADS_LOSE:
        return fc_channel_add_lose(NULL, name);
    case FC_THREADS_REPEAT_LAST:
        return fc_channel_add_repeat_last(NULL, name);
    case FC_THREADS_BLOCK_GET:
        return fc_channel_add_block_get(NULL, name);
    case FC_THREADS_BLOCK_PUT:
        return fc_channel_add_block_put(NULL, name);
    }
    return FC_E_ARG;
}

static void make_named(const call *call, const fc_threads_result *all, fc_threads_result *result) {
    (void)all;
    result->value = call_named((fc_threads_of_name)call->which, call->name);
}

static int64_t call_numbered(fc_threads_of_number which, const char *channel, int64_t n) {
    switch (which) {
    case FC_THREADS_DROP:
        return fc_channel_add_drop(NULL, channel, n);
    case FC_THREADS_REPEAT:
        return fc_channel_add_repeat(NULL, channel, n);
    case FC_THREADS_DELAY:
        return fc_channel_add_delay(NULL, channel, n);
    case FC_THREADS_RESEQUENCE:
        return fc_channel_add_resequence(NULL, channel, n);
    case FC_THREADS_CORRUPTION:
        return fc_channel_add_corruption(NULL, channel, 0, (int)n);
    }
    return FC_E_ARG;
}

static void make_numbered(const call *call, const fc_threads_result *all,
                          fc_threads_result *result) {
    (void)all;
    result->value = call_numbered((fc_threads_of_number)call->which, call->name, call->n);
}

static int64_t call_paired(fc_threads_of_pair which, const char *channel, const char *other) {
    switch (which) {
    case FC_THREADS_DEPTH:
        return fc_channel_depth(NULL, channel, other);
    case FC_THREADS_SUBSCRIBE:
        return fc_channel_subscribe(NULL, channel, other);
    case FC_THREADS_MISROUTE:
        return fc_channel_add_misroute(NULL, channel, other);
    case FC_THREADS_MASQUERADE:
        return fc_channel_add_masquerade(NULL, channel, other);
    }
    return FC_E_ARG;
}

static void make_paired(const call *call, const fc_threads_result *all, fc_threads_result *result) {
    (void)all;
    result->value = call_paired((fc_threads_of_pair)call->which, call->name, call->other);
}

static int call_faulted(fc_threads_of_fault which, fc_fault_id fault, int64_t n, int64_t m) {
    switch (which) {
    case FC_THREADS_AFTER:
        return fc_trigger_after(NULL, fault, (uint64_t)n);
    case FC_THREADS_ONCE_AFTER:
        return fc_trigger_once_after(NULL, fault, (uint64_t)n);
    case FC_THREADS_DURATION:
        return fc_trigger_duration(NULL, fault, n);
    case FC_THREADS_PERIODIC:
        return fc_trigger_periodic(NULL, fault, (uint64_t)n, (uint64_t)m);
    case FC_THREADS_RANDOM:
        return fc_trigger_random(NULL, fault, (double)n / (double)m);
    case FC_THREADS_NONE:
        return fc_trigger_none(NULL, fault);
    case FC_THREADS_ENABLE:
        return fc_enable(NULL, fault, n != 0);
    case FC_THREADS_REMOVE:
        return fc_remove(NULL, fault);
    }
    return FC_E_ARG;
}

static void make_faulted(const call *call, const fc_threads_result *all,
                         fc_threads_result *result) {
    const fc_fault_id fault = all[call->armed_by].value;
    result->value = call_faulted((fc_threads_of_fault)call->which, fault, call->n, call->m);
}

/* ---- adding them -------------------------------------------------------------------------- */

static bool copy_text(char **copy, const char *text) {
    if (text == NULL)
        text = "";
    *copy = malloc(strlen(text) + 1);
    if (*copy == NULL)
        return false;
    strcpy(*copy, text);
    return true;
}

static bool make_room(fc_threads *plan) {
    if (plan->count < plan->capacity)
        return true;
    const size_t capacity = 2 * plan->capacity + 16;
    call *larger = realloc(plan->calls, capacity * sizeof *larger);
    if (larger == NULL)
        return false;
    plan->calls = larger;
    plan->capacity = capacity;
    return true;
}

static int add(fc_threads *plan, const call *wanted, const char *name, const char *other) {
    if (plan == NULL || wanted->lane < 0 || wanted->lane > plan->threads + 1 || !make_room(plan))
        return -1;
    call new_call = *wanted;
    if (!copy_text(&new_call.name, name))
        return -1;
    if (!copy_text(&new_call.other, other)) {
        free(new_call.name);
        return -1;
    }
    plan->calls[plan->count] = new_call;
    return (int)plan->count++;
}

static int add_with_data(fc_threads *plan, call *wanted, const char *name, const void *data,
                         size_t size) {
    if (size > FC_THREADS_DATA)
        return -1;
    if (size > 0)
        memcpy(wanted->data, data, size);
    wanted->size = size;
    return add(plan, wanted, name, "");
}

int fc_threads_probe(fc_threads *plan, int lane, fc_type type, const char *id, const void *data,
                     size_t size) {
    call wanted = {.make = make_probe, .lane = lane, .which = type};
    return add_with_data(plan, &wanted, id, data, size);
}

int fc_threads_probe_handle(fc_threads *plan, int lane, int32_t value) {
    const call wanted = {.make = make_handle, .lane = lane, .n = value};
    return add(plan, &wanted, "x", "");
}

int fc_threads_put(fc_threads *plan, int lane, const char *channel, const void *data, size_t size) {
    call wanted = {.make = make_put, .lane = lane};
    return add_with_data(plan, &wanted, channel, data, size);
}

int fc_threads_get(fc_threads *plan, int lane, const char *channel, const char *receiver) {
    const call wanted = {.make = make_get, .lane = lane};
    return add(plan, &wanted, channel, receiver);
}

int fc_threads_arm(fc_threads *plan, int lane, const char *id, const fc_model *model) {
    const call wanted = {.make = make_arm, .lane = lane, .model = *model};
    return add(plan, &wanted, id, "");
}

int fc_threads_named(fc_threads *plan, int lane, fc_threads_of_name which, const char *name) {
    const call wanted = {.make = make_named, .lane = lane, .which = which};
    return add(plan, &wanted, name, "");
}

int fc_threads_numbered(fc_threads *plan, int lane, fc_threads_of_number which, const char *channel,
                        int64_t n) {
    const call wanted = {.make = make_numbered, .lane = lane, .which = which, .n = n};
    return add(plan, &wanted, channel, "");
}

int fc_threads_paired(fc_threads *plan, int lane, fc_threads_of_pair which, const char *channel,
                      const char *other) {
    const call wanted = {.make = make_paired, .lane = lane, .which = which};
    return add(plan, &wanted, channel, other);
}

int fc_threads_faulted(fc_threads *plan, int lane, fc_threads_of_fault which, int armed_by,
                       int64_t n, int64_t m) {
    if (plan == NULL || armed_by < 0 || (size_t)armed_by >= plan->count)
        return -1;
    const call wanted = {
        .make = make_faulted, .lane = lane, .which = which, .armed_by = armed_by, .n = n, .m = m};
    return add(plan, &wanted, "", "");
}

/* ---- running them ------------------------------------------------------------------------- */

/* Another processor has the value soon; if not, the thread that writes it needs this one's. */
static void wait_for(const int *place, int wanted) {
    for (int turn = 0; __atomic_load_n(place, __ATOMIC_ACQUIRE) != wanted; ++turn)
        if (turn > 200)
            sched_yield();
}

/* SplitMix64's mixing step. */
static uint64_t mix(uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* Half of the pauses are none, so that calls meet closely. */
static void pause_before(const fc_threads *plan, int repetition, size_t at) {
    const uint64_t drawn = mix(plan->seed + ((uint64_t)repetition << 32) + at);
    const unsigned turns = (drawn & 1) == 0 ? 0 : (unsigned)(drawn >> 1) % 256;
    for (volatile unsigned turn = 0; turn < turns; ++turn)
        ;
}

static void run_lane(fc_threads *plan, int repetition, int lane) {
    fc_threads_result *results = plan->results + (size_t)repetition * plan->count;
    const bool is_timed = repetition % 2 == 1;
    for (size_t at = 0; at < plan->count; ++at) {
        const call *next = &plan->calls[at];
        if (next->lane != lane)
            continue;
        pause_before(plan, repetition, at);
        if (is_timed)
            results[at].begin = __atomic_add_fetch(&plan->ticket, 1, __ATOMIC_RELAXED);
        next->make(next, results, &results[at]);
        if (is_timed)
            results[at].end = __atomic_add_fetch(&plan->ticket, 1, __ATOMIC_RELAXED);
    }
}

static void *work(void *argument) {
    const worker *self = argument;
    fc_threads *plan = self->plan;
    for (int repetition = 0; repetition < plan->repetitions; ++repetition) {
        wait_for(&plan->round, repetition + 1);
        if (__atomic_load_n(&plan->abandoned, __ATOMIC_RELAXED))
            break;
        run_lane(plan, repetition, self->lane);
        __atomic_add_fetch(&plan->done, 1, __ATOMIC_ACQ_REL);
    }
    return NULL;
}

/* What is refused is told by the results. */
static void ignore(void *user, const fc_error *error) {
    (void)user;
    (void)error;
}

static void run_repetition(fc_threads *plan, int repetition) {
    fc_reset(NULL);
    fc_advance(NULL, 0);
    plan->ticket = 0;
    run_lane(plan, repetition, 0);
    __atomic_store_n(&plan->done, 0, __ATOMIC_RELAXED);
    __atomic_store_n(&plan->round, repetition + 1, __ATOMIC_RELEASE);
    wait_for(&plan->done, plan->threads);
    run_lane(plan, repetition, plan->threads + 1);
}

int fc_threads_run(fc_threads *plan, int repetitions, uint64_t seed) {
    if (repetitions < 1)
        return -1;
    free(plan->results);
    plan->results = calloc((size_t)repetitions * plan->count + 1, sizeof *plan->results);
    if (plan->results == NULL)
        return -1;
    plan->repetitions = repetitions;
    plan->seed = mix(seed);
    plan->round = plan->abandoned = 0;
    fc_set_error_callback(NULL, ignore, NULL);
    int started = 0;
    for (; started < plan->threads; ++started) {
        worker *next = &plan->workers[started];
        *next = (worker){.plan = plan, .lane = started + 1};
        if (pthread_create(&next->thread, NULL, work, next) != 0)
            break;
    }
    const bool complete = started == plan->threads;
    if (complete) {
        for (int repetition = 0; repetition < repetitions; ++repetition)
            run_repetition(plan, repetition);
    } else {
        __atomic_store_n(&plan->abandoned, 1, __ATOMIC_RELAXED);
        __atomic_store_n(&plan->round, 1, __ATOMIC_RELEASE);
    }
    while (started > 0)
        pthread_join(plan->workers[--started].thread, NULL);
    return complete ? 0 : -1;
}

const fc_threads_result *fc_threads_results(const fc_threads *plan) {
    return plan->results;
}
