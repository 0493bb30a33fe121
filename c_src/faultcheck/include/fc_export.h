/* fc_export.h: marks the functions that libfaultcheck exports. */
#ifndef FC_EXPORT_H
#define FC_EXPORT_H

#if defined(__GNUC__)
#define FC_API __attribute__((visibility("default")))
#else
#define FC_API
#endif

#endif
