/* generated from power series by c_src/coptersim/tools/kernel_coefficients.py; do not edit */
#ifndef CSIM_KERNEL_COEFFICIENTS_H
#define CSIM_KERNEL_COEFFICIENTS_H

namespace csim_kernels {

/* pi / 180, its leading 26 bits, and what they leave */
constexpr double radians_per_degree = 0x1.1df46a2529d39p-6;
constexpr double radians_per_degree_short = 0x1.1df46a0000000p-6;
constexpr double radians_per_degree_rest = 0x1.294e9c8ae0ec6p-33;
/* 180 / pi, as a sum of two doubles */
constexpr double degrees_per_radian = 0x1.ca5dc1a63c1f8p+5;
constexpr double degrees_per_radian_low = -0x1.1e7ab456405f9p-49;
/* ln 2, as a sum of two doubles */
constexpr double ln_2 = 0x1.62e42fefa39efp-1;
constexpr double ln_2_low = 0x1.abc9e3b39803fp-56;
/* 1 / 3, as a sum of two doubles */
constexpr double third = 0x1.5555555555555p-2;
constexpr double third_low = 0x1.5555555555555p-56;

/* (sin y - y) / y^3, t = y^2, |y| <= pi/4; error below 9.3e-18 */
constexpr double sin_rest[] = {
    -0x1.5555555555555p-3,
    0x1.1111111111110p-7,
    -0x1.a01a01a019937p-13,
    0x1.71de3a54607fap-19,
    -0x1.ae6454129f078p-26,
    0x1.61217eed1c04ap-33,
    -0x1.ab17c21adf462p-41,
};

/* (cos y - 1 + y^2/2) / y^4, t = y^2, |y| <= pi/4; error below 2.3e-18 */
constexpr double cos_rest[] = {
    0x1.5555555555555p-5,
    -0x1.6c16c16c16c16p-10,
    0x1.a01a01a019d0ap-16,
    -0x1.27e4fb7712cc8p-22,
    0x1.1eed8deb869afp-29,
    -0x1.9394b9f1ce104p-37,
    0x1.ab784b1122af7p-45,
};

/* (atan q - q) / q^3, t = q^2, |q| <= 1/2; error below 1.9e-17 */
constexpr double atan_rest[] = {
    -0x1.5555555555555p-2,
    0x1.999999999998ep-3,
    -0x1.2492492491932p-3,
    0x1.c71c71c68a0c5p-4,
    -0x1.745d172701e87p-4,
    0x1.3b13ad5571f07p-4,
    -0x1.1110befb7253cp-4,
    0x1.e1d8a9bad8600p-5,
    -0x1.aecb542412942p-5,
    0x1.837a52499d8b8p-5,
    -0x1.56b2f82e012ddp-5,
    0x1.166a8732cc738p-5,
    -0x1.633de283fb773p-6,
    0x1.f5c3523066ab0p-8,
};

/* (exp t - 1 - t - t^2/2) / t^3, |t| <= ln(2)/2; error below 9.9e-18 */
constexpr double exp_rest[] = {
    0x1.5555555555555p-3,
    0x1.5555555555556p-5,
    0x1.1111111111111p-7,
    0x1.6c16c16c162cfp-10,
    0x1.a01a01a019b27p-13,
    0x1.a01a01a6db488p-16,
    0x1.71de3a5906976p-19,
    0x1.27e4db5bb725ap-22,
    0x1.ae643440b654bp-26,
    0x1.1f7315649f2d7p-29,
    0x1.61b2cab08aa6ap-33,
};

/* (artanh s - s - s^3/3) / s^5, t = s^2, |s| <= 0.1716; error below 1.1e-17 */
constexpr double atanh_rest[] = {
    0x1.999999999999ap-3,
    0x1.2492492492491p-3,
    0x1.c71c71c71cfdep-4,
    0x1.745d174512f5ep-4,
    0x1.3b13b1bcae4fap-4,
    0x1.1110df9bb9145p-4,
    0x1.e1f80050fe02dp-5,
    0x1.ac4a0689e4f11p-5,
    0x1.b8d8d83f51283p-5,
};

} // namespace csim_kernels

#endif
