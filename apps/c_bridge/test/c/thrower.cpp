// C++: an exception that the library does not catch, a namespace, a reference.
#include <stdexcept>

namespace shop {
int price(int count) {
    if (count < 0)
        throw std::invalid_argument("negative count");
    return 3 * count;
}
} // namespace shop

extern "C" int bill(int count) {
    return shop::price(count) + 1;
}
