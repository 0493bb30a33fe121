/* e2e_link.c: end-to-end protection at work: what does the receiver notice of each communication
 * fault?
 *
 * A sender protects packets with AUTOSAR E2E profile 5, libfaultcheck plays the network, and the
 * receiver checks each packet and feeds the verdicts to the E2E state machine. */
#include <E2E_P05.h>
#include <E2E_SM.h>
#include <fc.h>
#include <stdio.h>

enum { HEADER = 3, PAYLOAD = 5, LENGTH = HEADER + PAYLOAD, PACKETS = 12, WINDOW = 4 };

static const E2E_P05ConfigType profile = {
    0,          /* Offset, bits */
    8 * LENGTH, /* DataLength, bits */
    0x1234,     /* DataID: known to both sides, never sent */
    2           /* MaxDeltaCounter: one packet may be lost unnoticed */
};
/* Four verdicts count; one good one is enough to begin, one bad one is forgiven. */
static const E2E_SMConfigType limits = {WINDOW, WINDOW, WINDOW, 1, 1, 1, 1, 1, 1, FALSE};

/* ---- sender and receiver ---- */

static void send(fc_context *network, E2E_P05ProtectStateType *state, uint8 reading) {
    uint8 packet[LENGTH] = {0};
    packet[HEADER] = reading;
    E2E_P05Protect(&profile, state, packet, LENGTH);
    fc_channel_put(network, "bus", packet, LENGTH);
}

/* One letter for a verdict, one for a state. */
static char letter(E2E_P05CheckStatusType status) {
    switch (status) {
    case E2E_P05STATUS_OK:
        return '.';
    case E2E_P05STATUS_OKSOMELOST:
        return 'l';
    case E2E_P05STATUS_REPEATED:
        return 'r';
    case E2E_P05STATUS_WRONGSEQUENCE:
        return 's';
    case E2E_P05STATUS_NONEWDATA:
        return '-';
    default:
        return 'E';
    }
}

static char state_letter(E2E_SMStateType state) {
    switch (state) {
    case E2E_SM_VALID:
        return 'V';
    case E2E_SM_INVALID:
        return 'X';
    case E2E_SM_INIT:
        return 'i';
    default:
        return 'n';
    }
}

/* One cycle of the receiver: at most one packet. */
static char receive(fc_context *network, E2E_P05CheckStateType *check, E2E_SMCheckStateType *sm) {
    uint8 packet[2 * LENGTH];
    size_t length = 0;
    int got = fc_channel_get(network, "bus", NULL, packet, sizeof packet, &length);
    Std_ReturnType ret = got == 1 ? E2E_P05Check(&profile, check, packet, (uint16)length)
                                  : E2E_P05Check(&profile, check, NULL, 0);
    E2E_SMCheck(E2E_P05MapStatusToSM(ret, check->Status), &limits, sm);
    /* A packet of the wrong length is refused before it is looked at. */
    return ret == E2E_E_OK ? letter(check->Status) : 'x';
}

/* ---- the test ---- */

static void run(fc_context *network, const char *fault) {
    E2E_P05ProtectStateType sender;
    E2E_P05CheckStateType check;
    uint8 window[WINDOW];
    E2E_SMCheckStateType sm = {window, 0, 0, 0, E2E_SM_DEINIT};
    E2E_P05ProtectInit(&sender);
    E2E_P05CheckInit(&check);
    E2E_SMCheckInit(&sm, &limits);

    char verdicts[PACKETS + 1] = {0};
    char states[PACKETS + 1] = {0};
    for (uint8 i = 0; i < PACKETS; i++) {
        send(network, &sender, i);
        verdicts[i] = receive(network, &check, &sm);
        states[i] = state_letter(sm.SMState);
    }
    printf("%-34s %s  %s\n", fault, verdicts, states);
    fc_reset(network);
}

/* The fault acts on calls 4..6 of the channel. */
static void for_three(fc_context *network, fc_fault_id fault) {
    fc_trigger_after(network, fault, 3);
    fc_trigger_duration(network, fault, 3);
}

int main(void) {
    static const uint8 foreign[LENGTH] = {0x12, 0x34, 3, 99};
    fc_context *net = fc_new(NULL);
    if (net == NULL) {
        return 1;
    }
    printf("%-34s %-12s  state\n", "fault, on packets 4 to 6", "verdicts");
    run(net, "none");
    for_three(net, fc_channel_add_corruption(net, "bus", HEADER, 0));
    run(net, "corruption: one bit of the payload");
    for_three(net, fc_channel_add_lose(net, "bus"));
    run(net, "loss");
    for_three(net, fc_channel_add_drop(net, "bus", 1));
    run(net, "loss of packet 4 only");
    for_three(net, fc_channel_add_repeat_last(net, "bus"));
    run(net, "repetition of the packet before");
    for_three(net, fc_channel_add_delay(net, "bus", 2));
    run(net, "delay by two cycles");
    for_three(net, fc_channel_add_insert(net, "bus", foreign, LENGTH, 3));
    run(net, "insertion of foreign packets");
    for_three(net, fc_channel_add_truncate(net, "bus", LENGTH - 1));
    run(net, "truncation by a byte");
    for_three(net, fc_channel_add_block_get(net, "bus"));
    run(net, "blocked bus");
    printf("\nverdicts: . ok, l ok but some lost, r repeated, s wrong sequence, - no data, E "
           "error, x refused\n"
           "state: n no data, i initial, V valid, X invalid\n");
    fc_free(net);
    return 0;
}
