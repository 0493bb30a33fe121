/* A library for the fuzz targets: all kinds of types, and functions that are safe with whatever
 * arguments. */
#include <stdint.h>

enum level { LOW = -1, NONE, HIGH = 5 };
struct point {
    int x, y;
};
struct flags {
    unsigned on : 1;
    int level : 4;
    unsigned : 3;
    uint64_t wide : 40;
};
union number {
    float as_float;
    int32_t as_int;
};
struct everything {
    int8_t i8;
    uint16_t u16;
    int64_t i64;
    _Bool yes;
    enum level level;
    float small;
    double large;
    char text[5];
    struct point points[3];
    struct flags flags;
};
struct pointing {
    struct point *to;
    const char *text;
    int (*function)(int);
    struct pointing *next;
};

int counter;
struct everything all;
struct pointing pointing;
union number either;
const int table[3] = {1, 2, 3};
long double precise;

int next(int v) {
    return ++counter + (v & 1);
}
int sum(uint8_t a, int16_t b, int64_t c) {
    return (int)(a + b + (c & 0xFF));
}
double scale(double v, float by) {
    return v * (double)by;
}
int8_t of_level(enum level l) {
    return (int8_t)(l & 1);
}
struct point turned(struct point p) {
    struct point q = {p.y, p.x};
    return q;
}
struct flags same_flags(struct flags f) {
    return f;
}
union number same_number(union number n) {
    return n;
}
struct everything same_all(struct everything e) {
    return e;
}
int takes_pointers(const uint8_t *bytes, struct point *point, char **texts, int (*function)(int)) {
    return (bytes != 0) + (point != 0) + (texts != 0) + (function != 0);
}
struct point *where(void) {
    return all.points;
}
int open_list(int count, ...) {
    return count;
}
