/* A ring of three integers: first in, first out. */
enum { CAPACITY = 3 };

static int items[CAPACITY];
static int first;
static int count;

/* Adds an item. Returns 1, or 0 when the ring is full. */
int ring_add(int item) {
    if (count > CAPACITY) { /* the bug: one item too many */
        return 0;
    }
    items[(first + count) % CAPACITY] = item;
    count = count + 1;
    return 1;
}

/* Takes the oldest item. Returns -1 when the ring is empty. */
int ring_take(void) {
    if (count == 0) {
        return -1;
    }
    int item = items[first];
    first = (first + 1) % CAPACITY;
    count = count - 1;
    return item;
}
