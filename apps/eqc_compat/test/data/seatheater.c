/* A seat heater, for the test of models in Quviq's style.
 *
 * A temperature in degrees arrives with each sample, and a second one that is not used yet. The
 * heater switches off for good after three samples in a row above the limit. Its defect: a cool
 * sample does not clear the count of hot ones while the seat is occupied. */
#include <string.h>

#ifndef HEATER_LIMIT
#error "HEATER_LIMIT comes from the compiler's command line"
#endif

int heater_off;
static int hot_samples;
static int occupied;
char heater_label[16];

void heater_sample(const unsigned char *degrees) {
    if (degrees[0] > HEATER_LIMIT) {
        hot_samples++;
    } else if (!occupied) {
        hot_samples = 0;
    }
    if (hot_samples >= 3) {
        heater_off = 1;
    }
}

void heater_occupy(int yes) {
    occupied = yes;
}

int heater_hot_samples(void) {
    return hot_samples;
}

void heater_set_label(const char *text) {
    strncpy(heater_label, text, sizeof heater_label - 1);
}
