/* packet_channel.c: two nodes that talk over a channel, and what the channel may do to packets.
 *
 * The way of Paper I, section 4.4: where the program would hand a packet to the network it puts it
 * into a channel, and where it would receive one it gets it from there. Without faults the channel
 * is a plain queue. */
#include <faultcheck_packet_wrapper.h>
#include <stdio.h>

static void node_send(unsigned char number) {
    char packet[2];
    packet[0] = (char)number;
    packet[1] = (char)(0xff - number);
    faultcheck_packet_addPacket("bus", packet, sizeof packet);
}

/* Prints every packet that is there; one whose second byte does not fit its first is marked. */
static void node_receive(void) {
    unsigned char packet[16];
    int length = 0;
    int gets = 0;
    while (gets < 12) { /* a dropped packet ends nothing, so ask more often than was sent */
        gets++;
        if (faultcheck_packet_getPacket("bus", (char *)packet, &length) == 0) {
            continue;
        }
        int intact = length == 2 && packet[0] + packet[1] == 0xff;
        printf(" %d%s", packet[0], intact ? "" : "!");
    }
    printf("\n");
}

static void show(const char *fault) {
    for (unsigned char number = 1; number <= 6; number++) {
        node_send(number);
    }
    printf("%-32s", fault);
    node_receive();
    faultcheck_packet_removeAllFaults();
}

int main(void) {
    show("no fault");

    faultcheck_packet_addFaultCorruptionBitFlip("bus", 0, 7);
    show("bit 7 of byte 0 in all packets");

    faultcheck_packet_addFaultCorruptionBitFlip("bus", 0, 7);
    faultcheck_packet_setTriggerOnceAfterIterations("bus", 2);
    show("the same, third packet only");

    faultcheck_packet_addFaultDrop("bus", 2);
    faultcheck_packet_setTriggerAfterIterations("bus", 3);
    show("two dropped after three gets");

    faultcheck_packet_addFaultRepeat("bus", 2);
    faultcheck_packet_setTriggerAfterIterations("bus", 1);
    show("the second delivered three times");

    /* Faults apply in the order of adding: each copy passes the corruption anew. */
    faultcheck_packet_addFaultRepeat("bus", 2);
    faultcheck_packet_addFaultCorruptionBitFlip("bus", 1, 0);
    faultcheck_packet_setTriggerOnceAfterIterations("bus", 1);
    show("repeated, first copy corrupted");
    return 0;
}
