/* The text commands: words, replies, limits, and that an error changes nothing. */
#include "check.h"
#include "fi.h"
#include "fi_replies.h"

#include <stdbool.h>

static bool replies(const char *line, const char *expected) {
    fi_run(line);
    if (strcmp(fi_last.text, expected) == 0)
        return true;
    fprintf(stderr, "%s\n  gave     %s  expected %s", line != NULL ? line : "NULL", fi_last.text,
            expected);
    return false;
}

static void start(void) {
    fi_init();
    CHECK(replies("fi_set_enabled 1", "ok\n"));
}

/* One error line which is this, and the faults are what they were. */
static bool refuses(const char *line, const char *error) {
    char before[sizeof fi_last.text], after[sizeof fi_last.text], expected[200];
    const bool active = fi_is_active();
    fi_run("fi_print_faults");
    memcpy(before, fi_last.text, sizeof before);
    snprintf(expected, sizeof expected, "error: expected %s\n", error);
    const bool as_expected = replies(line, expected);
    fi_run("fi_print_faults");
    memcpy(after, fi_last.text, sizeof after);
    return as_expected && strcmp(before, after) == 0 && active == fi_is_active();
}

static void words_are_separated_by_runs_of_spaces(void) {
    start();
    CHECK(replies("  fi_add_fault   p  OFFSET 1    2 3  ", "ok\n"));
    CHECK(replies("fi_print_faults\r\n",
                  "probe=p it=0 type=OFFSET param=1 start=2 duration=3\nok\n"));
    CHECK(refuses("fi_add_fault\tq\tOFFSET\t1\t2\t3",
                  "a command, not fi_add_fault\tq\tOFFSET\t1\t2\t3"));
}

static void unknown_commands(void) {
    start();
    CHECK(refuses("", "a command, not the end"));
    CHECK(refuses("   ", "a command, not the end"));
    CHECK(refuses(NULL, "a command, not the end"));
    CHECK(refuses("fi_set", "a command, not fi_set"));
    CHECK(refuses("fi_clear_faultss", "a command, not fi_clear_faultss"));
    CHECK(refuses("FI_CLEAR_FAULTS", "a command, not FI_CLEAR_FAULTS"));
    CHECK(refuses("the end", "a command, not the"));
}

static void wrong_numbers_of_words(void) {
    start();
    CHECK(replies("fi_add_fault p OFFSET 1 0 0", "ok\n"));
    CHECK(refuses("fi_set_enabled", "fi_set_enabled 0|1, not the end"));
    CHECK(refuses("fi_set_enabled 0 0", "fi_set_enabled 0|1, not 0"));
    CHECK(refuses("fi_clear_faults now", "fi_clear_faults, not now"));
    CHECK(refuses("fi_print_faults p", "fi_print_faults, not p"));
    CHECK(refuses("fi_reset_cnt 0 1 2 3 4 5 6 7 8 9", "fi_reset_cnt, not 0"));
    CHECK(refuses("fi_add_fault q NONE 1 0",
                  "fi_add_fault <probe_id> <type> <param> <start_it> <duration>, not the end"));
    CHECK(refuses("fi_add_fault q NONE 1 0 0 7 8",
                  "fi_add_fault <probe_id> <type> <param> <start_it> <duration>, not 7"));
}

static void wrong_enable_words(void) {
    static const char *const words[] = {"2", "01", "1x", "-1", "true", "/", "p"};
    start();
    for (int i = 0; i < 7; i++) {
        char line[40], error[40];
        snprintf(line, sizeof line, "fi_set_enabled %s", words[i]);
        snprintf(error, sizeof error, "0 or 1, not %s", words[i]);
        CHECK(refuses(line, error));
    }
}

static void wrong_words_of_a_fault(void) {
    start();
    CHECK(replies("fi_add_fault p SET_TO 4 5 6", "ok\n"));
    CHECK(refuses("fi_add_fault aaaaaaaaaaaaaaaaaaaab SET_TO 1 0 0",
                  "a shorter identifier, not aaaaaaaaaaaaaaaaaaaab"));
    CHECK(refuses("fi_add_fault p bitflip 1 0 0",
                  "NONE, BITFLIP, OFFSET, AMPLIFICATION or SET_TO, not bitflip"));
    CHECK(refuses("fi_add_fault p SET_TO1 1 0 0",
                  "NONE, BITFLIP, OFFSET, AMPLIFICATION or SET_TO, not SET_TO1"));
    CHECK(refuses("fi_add_fault p SET 1 0 0",
                  "NONE, BITFLIP, OFFSET, AMPLIFICATION or SET_TO, not SET"));
    CHECK(refuses("fi_add_fault p NONES 1 0 0",
                  "NONE, BITFLIP, OFFSET, AMPLIFICATION or SET_TO, not NONES"));
    CHECK(refuses("fi_add_fault p BITFLIP abc 0 0", "a decimal float, not abc"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 x 0", "0..2147483647, not x"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 0 y", "0..2147483647, not y"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 -1 0", "0..2147483647, not -1"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 0 -1", "0..2147483647, not -1"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 1.0 0", "0..2147483647, not 1.0"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 0 2147483648", "0..2147483647, not 2147483648"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 0 99999999999", "0..2147483647, not 99999999999"));
    CHECK(refuses("fi_add_fault p BITFLIP 1 +1 0", "0..2147483647, not +1"));
    CHECK(replies("fi_add_fault p BITFLIP 1 2147483647 02147483647", "ok\n"));
}

static void no_free_slots(void) {
    start();
    for (int i = 0; i < 5; i++)
        CHECK(replies("fi_add_fault p NONE 0 0 0", "ok\n"));
    CHECK(refuses("fi_add_fault p NONE 0 0 0", "a free fault slot, not p"));
    CHECK(replies("fi_add_fault q NONE 0 0 0", "ok\n"));
    CHECK(replies("fi_add_fault r NONE 0 0 0", "ok\n"));
    CHECK(replies("fi_add_fault s NONE 0 0 0", "ok\n"));
    CHECK(replies("fi_add_fault aaaaaaaaaaaaaaaaaaaa NONE 0 0 0", "ok\n"));
    CHECK(refuses("fi_add_fault u NONE 0 0 0", "a free probe slot, not u"));
    CHECK(refuses("fi_add_fault aaaaaaaaaaaaaaaaaaaab NONE 0 0 0",
                  "a shorter identifier, not aaaaaaaaaaaaaaaaaaaab"));
    CHECK(replies("fi_add_fault q NONE 0 0 0", "ok\n"));
    CHECK(replies("fi_clear_faults", "ok\n"));
    CHECK(replies("fi_add_fault u NONE 0 0 0", "ok\n"));
}

static void a_line_for_each_fault(void) {
    int value = 0;
    start();
    CHECK(replies("fi_print_faults", "ok\n"));
    CHECK(replies("fi_add_fault q none 0 0 0", "ok\n"));
    CHECK(replies("fi_add_fault aaaaaaaaaaaaaaaaaaaa AMPLIFICATION -1.25 3 4", "ok\n"));
    CHECK(replies("fi_add_fault q BITFLIP -3 2147483647 2147483646", "ok\n"));
    fi_inject_fault_int("q", &value);
    CHECK(replies("fi_add_fault q SET_TO 7 1 0", "ok\n"));
    CHECK(replies(
        "fi_print_faults",
        "probe=q it=1 type=NONE param=0 start=0 duration=0\n"
        "probe=q it=1 type=BITFLIP param=-3 start=2147483647 duration=2147483646\n"
        "probe=q it=1 type=SET_TO param=7 start=2 duration=0\n"
        "probe=aaaaaaaaaaaaaaaaaaaa it=0 type=AMPLIFICATION param=-1.25 start=3 duration=4\n"
        "ok\n"));
}

/* The longest line that there is fits; of an error the end is cut off. */
static void long_lines(void) {
    char line[300] = "fi_set_enabled ";
    start();
    CHECK(replies(
        "fi_add_fault aaaaaaaaaaaaaaaaaaaa AMPLIFICATION -3999999999e-45 2147483647 2147483647",
        "ok\n"));
    CHECK(replies("fi_print_faults",
                  "probe=aaaaaaaaaaaaaaaaaaaa it=0 type=AMPLIFICATION param=-3999999999e-45 "
                  "start=2147483647 duration=2147483647\nok\n"));
    memset(line + 15, 'x', 284);
    line[299] = '\0';
    fi_run(line);
    CHECK_INT(fi_last.lines, 1);
    CHECK_INT(fi_last.length, 120);
    CHECK(strncmp(fi_last.text, "error: expected 0 or 1, not xxx", 31) == 0);
}

static void without_a_callback(void) {
    int value = 1;
    start();
    fi_process_line("fi_add_fault p OFFSET 1 0 0", NULL);
    fi_process_line("fi_print_faults", NULL);
    fi_process_line("fi_nothing", NULL);
    fi_inject_fault_int("p", &value);
    CHECK_INT(value, 2);
}

int main(void) {
    words_are_separated_by_runs_of_spaces();
    unknown_commands();
    wrong_numbers_of_words();
    wrong_enable_words();
    wrong_words_of_a_fault();
    no_free_slots();
    a_line_for_each_fault();
    long_lines();
    without_a_callback();
    return CHECK_RESULT();
}
