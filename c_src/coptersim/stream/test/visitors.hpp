/* visitors.hpp: any message as JSON, and any message made up from a seed. */
#ifndef CSIM_STREAM_VISITORS_HPP
#define CSIM_STREAM_VISITORS_HPP

#include "members.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace viz_test {

using json = nlohmann::ordered_json;

/* Members by name; reals that are not finite are the texts "inf", "neg_inf", "nan". */
class printer {
  public:
    template <class M> static json of(M message) {
        printer p;
        members(message, p);
        return p.result_;
    }

    template <class T> void operator()(const char *name, T &member) {
        result_[name] = value(member);
    }
    template <class T> void count(const char *name, std::int32_t &n, std::vector<T> &) {
        result_[name] = n;
    }
    void rows(const char *name, std::int32_t &n, std::vector<std::vector<float>> &, int) {
        result_[name] = n;
    }

  private:
    static json value(double x) {
        if (std::isnan(x)) {
            return "nan";
        }
        return std::isinf(x) ? json(x > 0 ? "inf" : "neg_inf") : json(x);
    }
    static json value(float x) {
        return value(static_cast<double>(x));
    }
    static json value(std::int8_t n) {
        return n;
    }
    static json value(std::int32_t n) {
        return n;
    }
    static json value(std::int64_t n) {
        return n;
    }
    static json value(std::string &text) {
        return text;
    }
    template <class T, std::size_t N> static json value(T (&array)[N]) {
        json list = json::array();
        for (T &item : array) {
            list.push_back(value(item));
        }
        return list;
    }
    template <class T> static json value(std::vector<T> &array) {
        json list = json::array();
        for (T &item : array) {
            list.push_back(value(item));
        }
        return list;
    }
    template <class M> static json value(M &message) {
        return of(message);
    }

    json result_ = json::object();
};

/* Whole ranges of numbers, limits often; a few reals that are not finite; UTF-8 of all lengths. */
class maker {
  public:
    explicit maker(std::uint64_t seed) : random_(seed) {}

    template <class M> M make() {
        M message{};
        members(message, *this);
        return message;
    }

    template <class T> void operator()(const char *, T &member) {
        fill(member);
    }
    template <class T> void count(const char *, std::int32_t &n, std::vector<T> &array) {
        n = below(6);
        array.resize(static_cast<std::size_t>(n));
    }
    void rows(const char *, std::int32_t &n, std::vector<std::vector<float>> &array, int width) {
        n = below(6);
        array.assign(static_cast<std::size_t>(n),
                     std::vector<float>(static_cast<std::size_t>(width)));
    }

  private:
    std::int32_t below(std::uint32_t n) {
        return static_cast<std::int32_t>(random_() % n);
    }
    template <class T> T whole() {
        switch (below(4)) {
        case 0:
            return largest<T>();
        case 1:
            return sizeof(T) == 8 ? -largest<T>() : std::numeric_limits<T>::min();
        case 2:
            return static_cast<T>(below(200) - 100);
        default:
            return static_cast<T>(random_()) % largest<T>();
        }
    }
    /* Of 64 bits no more than what all languages hold as a number. */
    template <class T> static T largest() {
        return sizeof(T) == 8 ? static_cast<T>((std::int64_t{1} << 53) - 1)
                              : std::numeric_limits<T>::max();
    }
    template <class T> T real() {
        switch (below(12)) {
        case 0:
            return std::numeric_limits<T>::infinity();
        case 1:
            return -std::numeric_limits<T>::infinity();
        case 2:
            return std::numeric_limits<T>::quiet_NaN();
        case 3:
            return std::numeric_limits<T>::max();
        case 4:
            return std::numeric_limits<T>::denorm_min();
        case 5:
            return T(-0.0);
        default:
            return static_cast<T>(below(2000000) - 1000000) / T(1024);
        }
    }
    void fill(std::int8_t &n) {
        n = whole<std::int8_t>();
    }
    void fill(std::int32_t &n) {
        n = whole<std::int32_t>();
    }
    void fill(std::int64_t &n) {
        n = whole<std::int64_t>();
    }
    void fill(float &x) {
        x = real<float>();
    }
    void fill(double &x) {
        x = real<double>();
    }
    void fill(std::string &text) {
        static const char *const pieces[] = {
            "a",  "{\"x\": 1}", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x9a\x81", " ",
            "\n", "\\",         "<"};
        for (int n = below(12); n > 0; n--) {
            text += pieces[below(9)];
        }
    }
    template <class T, std::size_t N> void fill(T (&array)[N]) {
        for (T &item : array) {
            fill(item);
        }
    }
    template <class T> void fill(std::vector<T> &array) {
        for (T &item : array) {
            fill(item);
        }
    }
    template <class M> void fill(M &message) {
        members(message, *this);
    }

    std::mt19937_64 random_;
};

template <class M> std::string bytes_of(const M &message) {
    std::string bytes(static_cast<std::size_t>(message.getEncodedSize()), '\0');
    int size = message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    return size == static_cast<int>(bytes.size()) ? bytes : std::string();
}

} // namespace viz_test

#endif
