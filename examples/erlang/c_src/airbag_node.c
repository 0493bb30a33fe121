/* airbag_node.c: a sensor that talks to an airbag over a channel, without any protection.
 *
 * Two messages [85,170] in succession fire the airbag. */
#include <faultcheck_packet_wrapper.h>

static int in_succession;
static int fired;

/* The sensor's side. */
void sensor(unsigned char first, unsigned char second) {
    char message[2];
    message[0] = (char)first;
    message[1] = (char)second;
    faultcheck_packet_addPacket("airbag", message, 2);
}

/* The airbag's side: takes all messages that are there. Returns whether it has fired. */
int airbag_iteration(void) {
    unsigned char message[16];
    int length = 0;
    while (faultcheck_packet_getPacket("airbag", (char *)message, &length)) {
        in_succession = message[0] == 85 && message[1] == 170 ? in_succession + 1 : 0;
        if (in_succession == 2) {
            fired = 1;
        }
    }
    return fired;
}
