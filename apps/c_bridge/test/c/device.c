/* One file of many: all it calls is elsewhere. */
#include "device.h"

double scaled(int channel) {
    report("scaled", channel);
    return mode_of() == ON ? read_raw(channel) * scale_of(channel) : -1;
}
char first_letter(int channel) {
    return label_of(channel)[0];
}
double filled(int channel) {
    struct reading r = {0, 0};
    return fill_reading(&r, channel) ? r.value : -1;
}
double better(double a, double b) {
    struct reading x = {1, a}, y = {2, b};
    return best_of(x, y).value;
}
