/* E2E_Types.h: the basic types the AUTOSAR C API is written in.
 *
 * Built inside an AUTOSAR project, define E2E_USE_STD_TYPES: its own Std_Types.h is taken instead.
 */
#ifndef E2E_TYPES_H
#define E2E_TYPES_H

#include <stddef.h>

#if defined(E2E_USE_STD_TYPES)
#include "Std_Types.h"
#else
#include <stdint.h>

/* Unsigned integers of that many bits. */
typedef uint8_t uint8;
typedef uint16_t uint16;
typedef uint32_t uint32;
typedef uint64_t uint64;
typedef uint8 boolean;        /* TRUE or FALSE */
typedef uint8 Std_ReturnType; /* E2E_E_OK or another E2E_E_ code */

#ifndef TRUE
#define TRUE 1 /* boolean */
#endif
#ifndef FALSE
#define FALSE 0 /* boolean */
#endif
#endif

/* Marks what a shared library lets others call. */
#if defined(__GNUC__)
#define E2E_API __attribute__((visibility("default")))
#else
#define E2E_API
#endif

#endif
