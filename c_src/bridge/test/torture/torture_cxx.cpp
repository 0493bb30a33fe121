// The C++ side of a library's interface, as far as it can be called.
#include <cstdint>
#include <stdexcept>
#include <string>

namespace shop {

enum class Size : std::uint8_t { Small = 1, Large = 200 };

struct Item {
    int price;
    bool sold;
    static int made;
};
int Item::made = 4;

int stock = 12;

int price_of(const Item &item) {
    return item.price;
}
Size next(Size size) {
    return size == Size::Small ? Size::Large : Size::Small;
}
namespace inner {
int deep(int v) {
    return v + 1000;
}
} // namespace inner

} // namespace shop

int twice(int v) {
    return 2 * v;
}
double twice(double v) {
    return 2 * v;
}

struct Base {
    int below = 1;
};
struct Derived : Base {
    int above = 2;
};
Derived both;

class Counter {
  public:
    int count = 0;
    int up(int by);
};
int Counter::up(int by) {
    return count += by;
}
Counter counter;

struct Owner {
    std::string name;
    ~Owner();
};
Owner::~Owner() {}
int length_of(Owner owner) {
    return static_cast<int>(owner.name.size());
}

extern "C" {
void swap_ints(int &a, int &b) {
    const int c = a;
    a = b;
    b = c;
}
int checked(int v) {
    if (v < 0) {
        throw std::out_of_range("below zero");
    }
    if (v == 0) {
        throw 42;
    }
    return v;
}
}
