/* The end of the counters, which takes 2^32 calls to reach: they are set here from inside. */
#include "../fi.c"

#include "check.h"

static char last[FI_ID_BYTES + 100];

static void keep(const char *text) {
    strcpy(last, text);
}

static int probe_p(void) {
    int value = 0;
    fi_inject_fault_int("p", &value);
    return value;
}

/* As if the probe had been called so often since the last reset. */
static void count_to(uint32_t calls, uint32_t first) {
    probes[0].base = first;
    probes[0].calls = first + calls;
}

static void at_the_end_windows_are_over_and_permanent_faults_stay(uint32_t first) {
    fi_init();
    fi_process_line("fi_set_enabled 1", NULL);
    fi_process_line("fi_add_fault p OFFSET 1 1 0", NULL);
    fi_process_line("fi_add_fault p OFFSET 2 2147483647 2147483647", NULL);
    count_to(UINT32_C(4294967292), first);
    CHECK_INT(probe_p(), 3);
    CHECK_INT(probe_p(), 3);
    for (int i = 0; i < 4; i++)
        CHECK_INT(probe_p(), 1);
    fi_process_line("fi_print_faults", keep);
    CHECK_INT(counter(probes), UINT32_MAX);
}

static void a_window_past_the_end_is_refused(uint32_t first) {
    fi_init();
    fi_process_line("fi_set_enabled 1", NULL);
    fi_process_line("fi_add_fault p OFFSET 1 0 1", NULL);
    count_to(UINT32_MAX - 10, first);
    fi_process_line("fi_add_fault p OFFSET 1 5 6", keep);
    CHECK(strcmp(last, "error: expected fi_reset_cnt first, not 6") == 0);
    fi_process_line("fi_add_fault p OFFSET 1 5 5", keep);
    CHECK(strcmp(last, "ok") == 0);
    CHECK_INT(probes[0].faults, 2);
    fi_process_line("fi_reset_cnt", keep);
    CHECK_INT(counter(probes), 0);
    CHECK_INT(probe_p(), 1);
    fi_process_line("fi_add_fault p OFFSET 1 5 6", keep);
    CHECK(strcmp(last, "ok") == 0);
}

int main(void) {
    at_the_end_windows_are_over_and_permanent_faults_stay(0);
    at_the_end_windows_are_over_and_permanent_faults_stay(UINT32_C(0x80001234));
    a_window_past_the_end_is_refused(0);
    a_window_past_the_end_is_refused(UINT32_C(0xfffffff0));
    return CHECK_RESULT();
}
