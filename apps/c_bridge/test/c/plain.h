/* What a header says of a library that has no debug information. */
#ifndef PLAIN_H
#define PLAIN_H
struct pair {
    int first;
    double second;
};
extern int plain_counter;
int plain_add(int a, int b);
double plain_second(const struct pair *p);
struct pair plain_make(int first, double second);
#endif
