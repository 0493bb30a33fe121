/* fc_bench.c: what a probe and a channel cost. */
#include "faultcheck_packet_wrapper.h"
#include "faultcheck_wrapper.h"
#include "fc.h"
#include "handle.h"
#include "slices.h"

#include <pthread.h>
#include <stdint.h>

static int sink;

static void idle_by_name(long count) {
    int value = 5;
    for (long i = 0; i < count; i++)
        faultcheck_injectFaultInt("S2val", &value);
    sink = value;
}

static void active_by_name(long count) {
    int value = 5;
    for (long i = 0; i < count; i++)
        faultcheck_injectFaultInt("S1val", &value);
    sink = value;
}

static void put_and_get(long count) {
    char packet[4] = {1, 2, 3, 4};
    int len;
    for (long i = 0; i < count; i++) {
        faultcheck_packet_addPacket("airbag", packet, sizeof packet);
        faultcheck_packet_getPacket("airbag", packet, &len);
    }
    sink = packet[0];
}

/* Ten probes, as a simulator would have them: its own clock, a new recording from time to time. */
static void record_ten(long count) {
    double value = 5;
    for (long i = 0; i < count; i += 10) {
        if (i % 100000 == 0)
            fc_record_start(NULL, NULL);
        fc_advance(NULL, 1000);
        probe_ten(&value);
    }
    sink = (int)value;
}

static volatile int stop_arming;

static void *arm_and_disarm(void *unused) {
    (void)unused;
    while (!stop_arming)
        fc_remove(NULL, fc_add_offset(NULL, "rearmed", 1));
    return NULL;
}

/* Idle probe by name while another thread arms and disarms another identifier. */
static double contended_ns(void) {
    pthread_t other;
    stop_arming = 0;
    bench_unpin();
    if (pthread_create(&other, NULL, arm_and_disarm, NULL) != 0)
        return -1;
    bench_pin();
    double ns = bench_ns(idle_by_name);
    stop_arming = 1;
    pthread_join(other, NULL);
    return ns;
}

/* The least a lookup by name can cost: FNV-1a over the identifier, nothing else. */
static void hash_of_name(long count) {
    static const char *volatile name = "S2val";
    uint64_t sum = 0;
    for (long i = 0; i < count; i++) {
        uint64_t hash = 0xcbf29ce484222325u;
        for (const char *at = name; *at != '\0'; at++)
            hash = (hash ^ (unsigned char)*at) * 0x100000001b3u;
        sum += hash;
    }
    sink = (int)sum;
}

int main(void) {
    bench_pin();
    double hash_ns = bench_ns(hash_of_name);
    faultcheck_addFaultBitFlip("S1val", 3);
    bench_print("probe_idle_name_ns", bench_ns(idle_by_name), "ns", "hash_of_name_ns", hash_ns);
    bench_print("probe_active_name_ns", bench_ns(active_by_name), "ns", "hash_of_name_ns", hash_ns);
    bench_print("packet_ns", bench_ns(put_and_get), "ns", "hash_of_name_ns", hash_ns);
    bench_print("probe_idle_handle_ns", bench_ns(idle_by_handle), "ns", "hash_of_name_ns", hash_ns);
    faultcheck_addFaultOffset("yaw", 1);
    bench_print("probe_active_handle_ns", bench_ns(active_by_handle), "ns", "hash_of_name_ns",
                hash_ns);
    fc_reset(NULL);
    bench_print("record_ns", bench_ns(record_ten), "ns", "hash_of_name_ns", hash_ns);
    fc_reset(NULL);
    double idle_ns = bench_ns(idle_by_name);
    bench_print("probe_idle_contended_ratio", contended_ns() / idle_ns, "ratio", "idle_ns",
                idle_ns);
    return 0;
}
