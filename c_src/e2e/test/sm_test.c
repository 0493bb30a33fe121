/* The state machine: its errors, and each transition by hand; long runs are in the recorded
 * vectors. */
#include "E2E_SM.h"
#include "check.h"
#include <string.h>

static const E2E_SMConfigType config = {.WindowSizeValid = 5,
                                        .WindowSizeInit = 3,
                                        .WindowSizeInvalid = 4,
                                        .MinOkStateInit = 2,
                                        .MaxErrorStateInit = 1,
                                        .MinOkStateValid = 1,
                                        .MaxErrorStateValid = 2,
                                        .MinOkStateInvalid = 3,
                                        .MaxErrorStateInvalid = 0,
                                        .ClearToInvalid = FALSE};
static uint8 window[5];
static E2E_SMCheckStateType machine = {.ProfileStatusWindow = window};

static E2E_SMStateType after(const E2E_SMConfigType *by, E2E_PCheckStatusType status) {
    CHECK_EQ(E2E_E_OK, E2E_SMCheck(status, by, &machine));
    return machine.SMState;
}

static void reach_valid(const E2E_SMConfigType *by) {
    CHECK_EQ(E2E_E_OK, E2E_SMCheckInit(&machine, by));
    after(by, E2E_P_OK);
    after(by, E2E_P_OK);
    CHECK_EQ(E2E_SM_VALID, after(by, E2E_P_OK));
}

static void init_empties_the_window(void) {
    memset(window, E2E_P_OK, sizeof window);
    machine.WindowTopIndex = 3;
    CHECK_EQ(E2E_E_OK, E2E_SMCheckInit(&machine, &config));
    for (size_t i = 0; i < sizeof window; i++) {
        CHECK_EQ(E2E_P_NOTAVAILABLE, window[i]);
    }
    CHECK(machine.WindowTopIndex == 0 && machine.OkCount == 0 && machine.ErrorCount == 0);
    CHECK_EQ(E2E_SM_NODATA, machine.SMState);
}

static void nodata_is_left_by_usable_data_which_is_not_counted(void) {
    E2E_SMCheckInit(&machine, &config);
    CHECK_EQ(E2E_SM_NODATA, after(&config, E2E_P_ERROR));
    CHECK_EQ(E2E_SM_NODATA, after(&config, E2E_P_NONEWDATA));
    CHECK_EQ(E2E_SM_INIT, after(&config, E2E_P_WRONGSEQUENCE));
    CHECK_EQ(0, machine.OkCount);
    CHECK_EQ(E2E_SM_INIT, after(&config, E2E_P_OK));
    CHECK_EQ(E2E_SM_INIT, after(&config, E2E_P_REPEATED));
    CHECK_EQ(E2E_SM_VALID, after(&config, E2E_P_OK));
    CHECK_EQ(2, machine.OkCount);
}

static void init_becomes_invalid_by_errors(void) {
    E2E_SMCheckInit(&machine, &config);
    after(&config, E2E_P_OK);
    CHECK_EQ(E2E_SM_INIT, after(&config, E2E_P_ERROR));
    CHECK_EQ(E2E_SM_INVALID, after(&config, E2E_P_ERROR));
    CHECK_EQ(2, machine.ErrorCount);
}

static void valid_is_left_by_too_many_errors_or_too_few_oks(void) {
    reach_valid(&config);
    CHECK_EQ(E2E_SM_VALID, after(&config, E2E_P_ERROR));
    CHECK_EQ(E2E_SM_VALID, after(&config, E2E_P_ERROR));
    CHECK_EQ(E2E_SM_INVALID, after(&config, E2E_P_ERROR));
    reach_valid(&config);
    for (int i = 0; i < 4; i++) {
        CHECK_EQ(E2E_SM_VALID, after(&config, E2E_P_NONEWDATA));
    }
    CHECK_EQ(E2E_SM_INVALID, after(&config, E2E_P_NONEWDATA));
}

static void invalid_recovers_only_with_a_clean_window(void) {
    reach_valid(&config);
    for (int i = 0; i < 3; i++) {
        after(&config, E2E_P_ERROR);
    }
    for (int i = 0; i < 3; i++) {
        CHECK_EQ(E2E_SM_INVALID, after(&config, E2E_P_OK));
    }
    CHECK_EQ(E2E_SM_VALID, after(&config, E2E_P_OK));
}

static void clear_to_invalid_forgets_everything(void) {
    E2E_SMConfigType clearing = config;
    clearing.ClearToInvalid = TRUE;
    reach_valid(&clearing);
    for (int i = 0; i < 3; i++) {
        after(&clearing, E2E_P_ERROR);
    }
    CHECK_EQ(E2E_SM_INVALID, machine.SMState);
    CHECK(machine.ErrorCount == 0 && machine.OkCount == 0 && machine.WindowTopIndex == 0);
    after(&clearing, E2E_P_OK);
    after(&clearing, E2E_P_OK);
    CHECK_EQ(E2E_SM_VALID, after(&clearing, E2E_P_OK));
}

static void a_larger_window_does_not_see_what_the_smaller_had_forgotten(void) {
    E2E_SMConfigType errors = config;
    errors.MinOkStateInit = 3;
    errors.MaxErrorStateInit = 2;
    errors.MaxErrorStateValid = 0;
    E2E_SMCheckInit(&machine, &errors);
    after(&errors, E2E_P_OK);
    after(&errors, E2E_P_ERROR);
    after(&errors, E2E_P_ERROR);
    after(&errors, E2E_P_OK);
    after(&errors, E2E_P_OK);
    CHECK_EQ(E2E_SM_VALID, after(&errors, E2E_P_OK));
    CHECK_EQ(E2E_SM_VALID, after(&errors, E2E_P_OK));
    CHECK_EQ(0, machine.ErrorCount);
}

static void every_error_is_reported_and_changes_nothing(void) {
    E2E_SMConfigType empty = config;
    E2E_SMCheckStateType no_window = {.SMState = E2E_SM_INIT};
    empty.WindowSizeValid = 0;
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_SMCheckInit(NULL, &config));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_SMCheckInit(&machine, NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_SMCheckInit(&no_window, &config));
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_SMCheckInit(&machine, &empty));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_SMCheck(E2E_P_OK, NULL, &machine));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_SMCheck(E2E_P_OK, &config, NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_SMCheck(E2E_P_OK, &config, &no_window));
    reach_valid(&config);
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_SMCheck((E2E_PCheckStatusType)6, &config, &machine));
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_SMCheck(E2E_P_OK, &empty, &machine));
    CHECK_EQ(E2E_SM_VALID, machine.SMState);
    CHECK_EQ(2, machine.WindowTopIndex);
    machine.WindowTopIndex = 5;
    CHECK_EQ(E2E_E_INTERR, E2E_SMCheck(E2E_P_OK, &config, &machine));
    machine.WindowTopIndex = 2;
    machine.SMState = (E2E_SMStateType)5;
    CHECK_EQ(E2E_E_INTERR, E2E_SMCheck(E2E_P_OK, &config, &machine));
    machine.SMState = E2E_SM_DEINIT;
    CHECK_EQ(E2E_E_WRONGSTATE, E2E_SMCheck(E2E_P_OK, &config, &machine));
    CHECK_EQ(E2E_SM_DEINIT, machine.SMState);
}

#define WRONG(member, value)                                                                       \
    do {                                                                                           \
        E2E_SMConfigType changed = config;                                                         \
        changed.member = (value);                                                                  \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_SMCheckConfig(&changed));                               \
    } while (0)

static void configurations_against_the_constraints_are_named_wrong(void) {
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_SMCheckConfig(NULL));
    CHECK_EQ(E2E_E_OK, E2E_SMCheckConfig(&config));
    WRONG(WindowSizeValid, 0);
    WRONG(WindowSizeInit, 6);
    WRONG(WindowSizeInvalid, 6);
    WRONG(MaxErrorStateInit, 3);
    WRONG(MaxErrorStateInvalid, 2);
    WRONG(MinOkStateValid, 0);
    WRONG(MinOkStateValid, 3);
    WRONG(MinOkStateInit, 4);
    WRONG(MaxErrorStateValid, 5);
    WRONG(MinOkStateInvalid, 5);
    WRONG(WindowSizeInit, 2);
}

int main(void) {
    init_empties_the_window();
    nodata_is_left_by_usable_data_which_is_not_counted();
    init_becomes_invalid_by_errors();
    valid_is_left_by_too_many_errors_or_too_few_oks();
    invalid_recovers_only_with_a_clean_window();
    clear_to_invalid_forgets_everything();
    a_larger_window_does_not_see_what_the_smaller_had_forgotten();
    every_error_is_reported_and_changes_nothing();
    configurations_against_the_constraints_are_named_wrong();
    return check_result();
}
