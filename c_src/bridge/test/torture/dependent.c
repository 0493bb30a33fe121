/* A library that needs torture.c: both are under test. */
#include "torture.h"

int own = 1;
int add_twice(int a) {
    own += 1;
    return add(add(a, a), own);
}
