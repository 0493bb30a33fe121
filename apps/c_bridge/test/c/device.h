/* Functions of another file: to be replaced by stubs. */
#ifndef DEVICE_H
#define DEVICE_H
enum mode { OFF, ON, FAULT = 9 };
struct reading {
    int channel;
    double value;
};
int read_raw(int channel);
double scale_of(int channel);
enum mode mode_of(void);
const char *label_of(int channel);
void report(const char *text, int value);
int fill_reading(struct reading *out, int channel);
struct reading best_of(struct reading a, struct reading b);
unsigned char small(void);
void (*handler_of(int which))(int);
#endif
