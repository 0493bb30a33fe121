#include "plain.h"
int plain_counter = 3;
int plain_add(int a, int b) {
    return a + b;
}
double plain_second(const struct pair *p) {
    return p->second;
}
struct pair plain_make(int first, double second) {
    struct pair p = {first, second};
    return p;
}
int not_in_header(void) {
    return 1;
}
