/* The two nodes of Paper I, section 5. See airbag.h. */
#include "airbag.h"

#include <stdio.h>
#include <string.h>

#include "E2E_P01.h"
#include "faultcheck_packet_wrapper.h"
#include "fc.h"

enum {
    DATA_BYTES = 2,
    PACKET_BYTES = 4,
    /* A fault or a test may put longer packets into the channel than the nodes do. */
    RECEIVE_BYTES = 256
};

static const uint8_t fire_message[DATA_BYTES] = {85, 170};

int airbag_active;
int activations;
airbag_statuses airbag_seen;

static airbag_variant configured_variant = AIRBAG_THESIS;
static int configured_needed = 2;

static int needed = 2;
static E2E_P01ConfigType config;
static E2E_P01ProtectStateType sender;
static E2E_P01CheckStateType receiver;

int airbag_configure(airbag_variant variant, int needed_messages) {
    if ((variant != AIRBAG_THESIS && variant != AIRBAG_RECOMMENDED) || needed_messages < 1)
        return -1;
    configured_variant = variant;
    configured_needed = needed_messages;
    return 0;
}

static void configure_thesis(void) {
    config.CounterOffset = 24;
    config.CRCOffset = 0;
    config.DataID = 0;
    config.DataIDNibbleOffset = 0;
    config.DataIDMode = E2E_P01_DATAID_BOTH;
    config.DataLength = 16;
    config.MaxDeltaCounterInit = 3;
    config.MaxNoNewOrRepeatedData = 14; /* behaves as the early release the thesis used */
    config.SyncCounterInit = 0;
}

static void configure_recommended(void) {
    configure_thesis();
    config.DataID = 0x0123;
    config.DataLength = 32;
    E2E_P01ProtectInit(&sender);
    E2E_P01CheckInit(&receiver);
}

void application_init(void) {
    airbag_active = 0;
    activations = 0;
    needed = configured_needed;
    memset(&config, 0, sizeof config);
    memset(&sender, 0, sizeof sender);
    memset(&receiver, 0, sizeof receiver);
    if (configured_variant == AIRBAG_RECOMMENDED)
        configure_recommended();
    else
        configure_thesis();
}

void sensor(const uint8_t *data) {
    faultcheck_packet_addPacket(AIRBAG_CHANNEL, (const char *)data, DATA_BYTES);
}

void sensor_e2e(const uint8_t *data) {
    uint8_t packet[PACKET_BYTES] = {0};
    memcpy(packet + 1, data, DATA_BYTES);
    E2E_P01Protect(&config, &sender, packet);
    faultcheck_packet_addPacket(AIRBAG_CHANNEL, (const char *)packet, PACKET_BYTES);
}

/* Take one packet; 1 if there was one. The buffer holds RECEIVE_BYTES. */
static int receive(uint8_t *buffer, int *length) {
    return faultcheck_packet_getPacket(AIRBAG_CHANNEL, (char *)buffer, length);
}

static void evaluate(const uint8_t *data) {
    activations = memcmp(data, fire_message, DATA_BYTES) == 0 ? activations + 1 : 0;
    if (activations >= needed && !airbag_active) {
        airbag_active = 1;
        printf("airbag: fired after %d activation messages\n", activations);
    }
}

/* For a recording: what has become of the airbag after one packet. */
static void monitor(void) {
    fc_monitor_i32(NULL, AIRBAG_ACTIVATIONS, activations);
    fc_monitor_i32(NULL, AIRBAG_FIRED, airbag_active);
}

void airbag_iteration(void) {
    uint8_t buffer[RECEIVE_BYTES];
    int length = 0;
    while (receive(buffer, &length)) {
        if (length == DATA_BYTES)
            evaluate(buffer);
        else
            activations = 0;
        monitor();
    }
}

static void count_status(E2E_P01CheckStatusType status) {
    switch (status) {
    case E2E_P01STATUS_OK:
        airbag_seen.ok++;
        break;
    case E2E_P01STATUS_NONEWDATA:
        airbag_seen.no_new_data++;
        break;
    case E2E_P01STATUS_WRONGCRC:
        airbag_seen.wrong_crc++;
        break;
    case E2E_P01STATUS_SYNC:
        airbag_seen.sync++;
        break;
    case E2E_P01STATUS_INITIAL:
        airbag_seen.initial++;
        break;
    case E2E_P01STATUS_REPEATED:
        airbag_seen.repeated++;
        break;
    case E2E_P01STATUS_OKSOMELOST:
        airbag_seen.ok_some_lost++;
        break;
    case E2E_P01STATUS_WRONGSEQUENCE:
        airbag_seen.wrong_sequence++;
        break;
    }
}

/* The status, or -1. After an error return the status is the one of an earlier packet and must not
 * be looked at: a received counter of 15 would otherwise go unnoticed. */
static int check(const uint8_t *packet, int new_data) {
    receiver.NewDataAvailable = new_data ? TRUE : FALSE;
    if (E2E_P01Check(&config, &receiver, packet) != E2E_E_OK) {
        airbag_seen.rejected++;
        return -1;
    }
    count_status(receiver.Status);
    return (int)receiver.Status;
}

/* 1 if the packet may be used. */
static int usable(const uint8_t *packet) {
    const int status = check(packet, 1);
    fc_monitor_i32(NULL, AIRBAG_STATUS, status);
    return status == E2E_P01STATUS_OK;
}

/* The end of the loop is an empty channel, not the status NONEWDATA: that one is stale after a
 * rejected packet and would leave packets behind. */
void airbag_iteration_e2e(void) {
    uint8_t buffer[RECEIVE_BYTES] = {0};
    int length = 0;
    while (receive(buffer, &length)) {
        if (length == PACKET_BYTES && usable(buffer))
            evaluate(buffer + 1);
        monitor();
    }
    check(buffer, 0);
}

int airbag_is_active(void) {
    return airbag_active;
}

void airbag_clear_statuses(void) {
    memset(&airbag_seen, 0, sizeof airbag_seen);
}
