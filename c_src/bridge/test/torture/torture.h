#ifndef TORTURE_H
#define TORTURE_H

#include <stddef.h>
#include <stdint.h>

struct point {
    int x, y;
};
struct line {
    struct point from, to;
};
struct vector {
    float x, y, z;
};
struct pair {
    int64_t count;
    double weight;
};
struct tiny {
    uint8_t bytes[3];
};
struct wide_mix {
    float a;
    int b;
    double d;
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
struct mixed {
    int own;
    union {
        int left;
        float right;
    };
    struct {
        struct point inner;
    };
};
struct packed {
    char a;
    int b;
} __attribute__((packed));
struct node {
    int value;
    struct node *next;
};
struct flexible {
    int count;
    int values[];
};
enum level { LOW = -1, NONE, HIGH = 5 };
enum depth { SHALLOW, DEEP = 200 };
typedef unsigned int metres_t;
typedef metres_t distance_t;

int add(int a, int b);
int sum_ints(const int *values, int count);

#endif
