/* Crc.h: the checksums of the AUTOSAR CRC library that end-to-end protection needs.
 *
 * All have the form  T Crc_CalculateX(Data, Length, StartValue, IsFirstCall):
 *   Data         Length bytes; may be NULL when Length is 0
 *   Length       in bytes
 *   StartValue   ignored when IsFirstCall is TRUE; else the result of the call before, so that
 *                X(b, n, X(a, m, 0, TRUE), FALSE) is the checksum of a followed by b
 *   IsFirstCall  TRUE starts a new checksum
 * None of them can fail. */
#ifndef CRC_H
#define CRC_H

#include "E2E_Types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* SAE J1850: polynomial 0x1D, start and final XOR 0xFF. */
E2E_API uint8 Crc_CalculateCRC8(const uint8 *Data, uint32 Length, uint8 StartValue,
                                boolean IsFirstCall);

/* Polynomial 0x2F, start and final XOR 0xFF. */
E2E_API uint8 Crc_CalculateCRC8H2F(const uint8 *Data, uint32 Length, uint8 StartValue,
                                   boolean IsFirstCall);

/* CCITT-FALSE: polynomial 0x1021, start 0xFFFF, no final XOR. */
E2E_API uint16 Crc_CalculateCRC16(const uint8 *Data, uint32 Length, uint16 StartValue,
                                  boolean IsFirstCall);

/* ARC: polynomial 0x8005, reflected, start 0, no final XOR. */
E2E_API uint16 Crc_CalculateCRC16ARC(const uint8 *Data, uint32 Length, uint16 StartValue,
                                     boolean IsFirstCall);

/* Ethernet: polynomial 0x04C11DB7, reflected, start and final XOR all ones. */
E2E_API uint32 Crc_CalculateCRC32(const uint8 *Data, uint32 Length, uint32 StartValue,
                                  boolean IsFirstCall);

/* Polynomial 0xF4ACFB13, reflected, start and final XOR all ones. */
E2E_API uint32 Crc_CalculateCRC32P4(const uint8 *Data, uint32 Length, uint32 StartValue,
                                    boolean IsFirstCall);

/* ECMA: polynomial 0x42F0E1EBA9EA3693, reflected, start and final XOR all ones. */
E2E_API uint64 Crc_CalculateCRC64(const uint8 *Data, uint32 Length, uint64 StartValue,
                                  boolean IsFirstCall);

#ifdef __cplusplus
}
#endif

#endif
